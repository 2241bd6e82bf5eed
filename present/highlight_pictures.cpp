#include "present/highlight_pictures.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace offing::present {
namespace {

float linear_of(std::uint8_t srgb) {
  const float value = static_cast<float>(srgb) / 255.0f;
  return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

float plain_of(std::uint8_t byte) {
  return static_cast<float>(byte) / 255.0f;
}

/// Rows as they are: the first one is the top of the box (highlight.frag).
std::vector<float> premultiplied(const RgbaImage& picture, float (*value_of)(std::uint8_t)) {
  std::vector<float> texels(picture.rgba.size());
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    const float alpha = plain_of(picture.rgba[i + 3]);
    for (std::size_t c = 0; c < 3; ++c) texels[i + c] = alpha * value_of(picture.rgba[i + c]);
    texels[i + 3] = alpha;
  }
  return texels;
}

}  // namespace

HighlightPictures::HighlightPictures()
    : white_(uploaded({.width = 1, .height = 1, .rgba = {255, 255, 255, 255}}, Use::normals)) {}

GlTexture HighlightPictures::uploaded(const RgbaImage& picture, Use use) {
  const std::vector<float> texels = premultiplied(picture, use == Use::colours ? linear_of : plain_of);
  GlTexture texture = GlTexture::make();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, picture.width, picture.height, 0, GL_RGBA, GL_FLOAT,
               texels.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  // Beyond its edges there is nothing.
  constexpr std::array<float, 4> clear{};
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, clear.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  return texture;
}

GLuint HighlightPictures::texture(const Pictures& pictures, const highlights::HighlightControls& controls) {
  const bool is_normals = controls.texture == highlights::HighlightTexture::normal_map;
  const bool is_picture = is_normals || controls.texture == highlights::HighlightTexture::image;
  const auto index = static_cast<std::size_t>(controls.picture);
  if (!is_picture || index >= pictures.size() || !pictures[index]) return white_.name();
  const Use use = is_normals ? Use::normals : Use::colours;
  GlTexture& texture = textures_[{pictures[index], use}];
  if (!texture) texture = uploaded(*pictures[index], use);
  return texture.name();
}

}  // namespace offing::present
