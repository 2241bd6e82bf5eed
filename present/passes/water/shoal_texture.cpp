#include "present/passes/water/shoal_texture.h"

#include <vector>

#include <glm/vec4.hpp>

#include "present/gl/sampler.h"

namespace offing::present {
namespace {

constexpr GLuint shares_binding = 4;
constexpr std::size_t share_values = SHOAL_STEPS * SHOAL_BANDS / 4;

void upload(const ocean::DepthMap& map) {
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, map.columns, map.rows, 0, GL_RED, GL_FLOAT, map.depths_m.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

ShoalTexture::ShoalTexture() : depths_(GlTexture::make()), shares_("Shoals", shares_binding, share_values) {}

void ShoalTexture::prepare(const std::shared_ptr<const ocean::Shoals>& shoals) {
  if (shoals == shoals_) return;
  shoals_ = shoals;
  if (!shoals) return;
  const ocean::ShoalsInstant& instant = shoals->instant();
  glBindTexture(GL_TEXTURE_2D, depths_.name());
  upload(*instant.depths);
  std::vector<glm::vec4> values;
  const std::vector<float>& shares = instant.table.shares();
  for (std::size_t i = 0; i < shares.size(); i += 4) {
    values.emplace_back(shares[i], shares[i + 1], shares[i + 2], shares[i + 3]);
  }
  shares_.fill(std::move(values));
}

void ShoalTexture::bind(const ShaderProgram& program, glm::dvec2 eye_m, int unit) const {
  if (!shoals_) return;
  bind_sampler(program, "shoal_depths", unit, depths_.name());
  shares_.bind(program);
  const ocean::DepthMap& map = *shoals_->instant().depths;
  program.set("shoal_place", glm::vec4((eye_m.x - map.origin_x_m) / map.spacing_x_m,
                                       (eye_m.y - map.origin_z_m) / map.spacing_z_m, 1.0 / map.spacing_x_m,
                                       1.0 / map.spacing_z_m));
  program.set("shoal_deepest_m", static_cast<float>(shoals_->instant().table.deepest_m()));
}

}  // namespace offing::present
