#include "host/cli/ocean/frame_writer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/cli/pictures/sea_map.h"
#include "host/ocean/query/gerstner_instant.h"
#include "host/scene/file/version.h"

namespace offing::cli {

namespace {

/// What is written of a cascade.
const BakedFrame::CascadeFields& fields_of(const BakedFrame& frame, std::size_t cascade) {
  return cascade == 0 && frame.first_with_gerstner ? *frame.first_with_gerstner : frame.cascades[cascade];
}

}  // namespace

FrameWriter::FrameWriter(const scene::Sea& sea, const BakeSettings& settings, const FrameFiles& files,
                         std::string scene_hash, std::string spectrum_name)
    : sea_(sea),
      settings_(settings),
      files_(files),
      scene_hash_(std::move(scene_hash)),
      spectrum_name_(std::move(spectrum_name)),
      hs_m_(ocean::integrate_sea_state(sea.spectrum).hs_m),
      contact_sheet_(settings.frames, [&files](int frame) { return files.preview(frame); }) {}

void FrameWriter::write(const BakedFrame& frame) {
  files_.remove_foreign_files(frame.number);
  std::optional<RgbImage> preview;
  if (settings_.preview == PreviewUse::pictures) preview = draw_preview(frame);
  // A frame is done when all its files are there. The EXR files come first: they tell whose the folder is.
  files_.remove_products(frame.number);
  write_fields(frame);
  if (settings_.mesh == MeshFormat::obj) {
    write_obj(files_.mesh(frame.number), frame.mesh);
  } else if (settings_.mesh == MeshFormat::ply) {
    write_ply(files_.mesh(frame.number), frame.mesh);
  }
  if (preview) {
    write_png(files_.preview(frame.number), *preview, Existing::replace, PngCompression::fast);
    contact_sheet_.keep(frame.number, *preview);
  }
}

void FrameWriter::write_fields(const BakedFrame& frame) const {
  if (settings_.layout == FileLayout::combined) {
    ExrImage image = image_of(frame);
    image.attributes.emplace_back("tileable", frame.first_with_gerstner ? 0 : 1);
    for (std::size_t i = 0; i < frame.cascades.size(); ++i) {
      const std::string layer = fmt::format("c{}.", i);
      add_cascade(image, fields_of(frame, i), layer);
      add_cascade_attributes(image, i, layer);
    }
    write_exr(files_.exr(frame.number, 0), image, settings_.pixel_type, settings_.compression);
    return;
  }
  for (std::size_t i = 0; i < frame.cascades.size(); ++i) {
    ExrImage image = image_of(frame);
    image.attributes.emplace_back("tileable", i == 0 && frame.first_with_gerstner ? 0 : 1);
    add_cascade(image, fields_of(frame, i), "");
    add_cascade_attributes(image, i, "");
    write_exr(files_.exr(frame.number, static_cast<int>(i)), image, settings_.pixel_type,
              settings_.compression);
  }
}

RgbImage FrameWriter::draw_preview(const BakedFrame& frame) const {
  std::vector<SeaMapCascade> cascades;
  for (std::size_t i = 0; i < frame.cascades.size(); ++i) {
    cascades.push_back(
        {sea_.parameters.cascades[i].patch_length_m, &frame.cascades[i].surface, frame.cascades[i].foam});
  }
  return draw_sea_map(cascades, {sea_.parameters.gerstner_waves, frame.time_s}, hs_m_);
}

ExrImage FrameWriter::image_of(const BakedFrame& frame) const {
  ExrImage image;
  image.width = sea_.parameters.size;
  image.height = sea_.parameters.size;
  image.attributes = {{"frame", frame.number},
                      {"time_s", frame.time_s},
                      {"frames_per_second", settings_.frames_per_second},
                      {"spectrum", spectrum_name_},
                      {"seed", fmt::format("{}", sea_.parameters.seed)},  // 64 bits do not fit an EXR integer
                      {"choppiness", sea_.parameters.choppiness},
                      {"scene_hash", scene_hash_},
                      {"offing_version", std::string(scene::version())}};
  if (sea_.parameters.loop_period_s) {
    image.attributes.emplace_back("loop_period_s", *sea_.parameters.loop_period_s);
  }
  if (settings_.has(ChannelGroup::velocity)) {
    image.attributes.emplace_back("velocity_depth_m", settings_.velocity_depth_m);
  }
  if (!sea_.parameters.gerstner_waves.waves.empty()) {
    add_gerstner_attributes(image, frame.time_s);
  }
  return image;
}

/// The waves as they stand at this time: h = sum of A cos(kx x + kz z + phase), displaced sideways by -Q A
/// K/k sin(kx x + kz z + phase).
void FrameWriter::add_gerstner_attributes(ExrImage& image, double time_s) const {
  const ocean::GerstnerInstant instant(sea_.parameters.gerstner_waves, time_s);
  std::string list;
  for (const ocean::GerstnerInstant::Wave& wave : instant.waves()) {
    const double phase_rad = std::remainder(wave.phase_rad, 2.0 * std::numbers::pi);
    list += fmt::format("{}{:.17g} {:.17g} {:.17g} {:.17g}", list.empty() ? "" : "; ", wave.amplitude_m,
                        wave.kx_radpm, wave.kz_radpm, phase_rad);
  }
  image.attributes.emplace_back("gerstner", list);
  image.attributes.emplace_back("gerstner_columns", "A_m kx_radpm kz_radpm phase_rad");
  image.attributes.emplace_back("gerstner_choppiness", instant.horizontal_scale());
}

void FrameWriter::add_cascade(ExrImage& image, const BakedFrame::CascadeFields& fields,
                              const std::string& layer) const {
  const ocean::SurfaceFields& surface = fields.surface;
  const auto add = [&](ChannelGroup group, const char* name, const std::vector<float>& values) {
    if (settings_.has(group)) {
      image.channels.push_back({layer + name, values});
    }
  };
  add(ChannelGroup::displacement, "displacement.X", surface.displacement_x);
  add(ChannelGroup::displacement, "displacement.Y", surface.displacement_y);
  add(ChannelGroup::displacement, "displacement.Z", surface.displacement_z);
  add(ChannelGroup::slope, "slope.X", surface.slope_x);
  add(ChannelGroup::slope, "slope.Z", surface.slope_z);
  add(ChannelGroup::gradient, "gradient.XX", surface.gradient_xx);
  add(ChannelGroup::gradient, "gradient.XZ", surface.gradient_xz);
  add(ChannelGroup::gradient, "gradient.ZZ", surface.gradient_zz);
  add(ChannelGroup::jacobian, "jacobian", surface.jacobian);
  add(ChannelGroup::jacobian, "jacobian_min_eigenvalue", surface.jacobian_min_eigenvalue);
  add(ChannelGroup::foam, "foam", fields.foam);
  add(ChannelGroup::velocity, "velocity.X", fields.velocity.x);
  add(ChannelGroup::velocity, "velocity.Y", fields.velocity.y);
  add(ChannelGroup::velocity, "velocity.Z", fields.velocity.z);
}

void FrameWriter::add_cascade_attributes(ExrImage& image, std::size_t cascade,
                                         const std::string& layer) const {
  const ocean::Cascade& band = sea_.parameters.cascades[cascade];
  image.attributes.emplace_back(layer + "patch_size_m", band.patch_length_m);
  image.attributes.emplace_back(layer + "k_min_radpm", band.k_min_radpm);
  image.attributes.emplace_back(layer + "k_max_radpm", band.k_max_radpm);
}

}  // namespace offing::cli
