#include "host/cli/ocean/frame_writer.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/cli/pictures/sea_map.h"
#include "host/ocean/query/gerstner_instant.h"
#include "host/scene/file/version.h"

namespace offing::cli {

FrameWriter::FrameWriter(const scene::Sea& sea, const BakeSettings& settings, const FrameFiles& files,
                         std::string scene_hash, std::string spectrum_name)
    : sea_(sea),
      settings_(settings),
      files_(files),
      scene_hash_(std::move(scene_hash)),
      spectrum_name_(std::move(spectrum_name)),
      hs_m_(ocean::integrate_sea_state(sea.spectrum).hs_m),
      maps_(baked_maps(settings, sea.parameters.cascades.size())),
      contact_sheet_(settings.frames, [&files](int frame) { return files.preview(frame); }) {}

void FrameWriter::write(BakedFrame frame) {
  files_.remove_foreign_files(frame.number);
  std::optional<RgbImage> preview;
  if (settings_.preview == PreviewUse::pictures) preview = draw_preview(frame);
  if (settings_.axes == MapAxes::z_up) turn_z_up(frame);
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

void FrameWriter::write_fields(BakedFrame& frame) {
  for (auto first = maps_.begin(); first != maps_.end();) {
    const auto last =
        std::find_if(first, maps_.end(), [&](const BakedMap& map) { return map.file != first->file; });
    write_file(frame, {first, last});
    first = last;
  }
}

void FrameWriter::write_file(BakedFrame& frame, std::span<const BakedMap> maps) {
  ExrImage image = image_of(frame);
  const bool is_wake = maps.front().cascade >= frame.cascades.size();
  const bool is_whole_sea = maps.front().cascade == 0 && frame.first_with_gerstner;
  image.attributes.emplace_back("tileable", is_wake || is_whole_sea ? 0 : 1);
  std::deque<std::vector<float>> rounded;  // what the channels of 16-bit floats refer to
  std::optional<std::size_t> cascade;
  for (const BakedMap& map : maps) {
    if (cascade != map.cascade) {
      cascade = map.cascade;
      if (is_wake) {
        set_wake_place(image, frame.wakes[*cascade - frame.cascades.size()],
                       settings_.wake_cells[*cascade - frame.cascades.size()]);
      } else {
        add_cascade_attributes(image, *cascade,
                               settings_.layout == FileLayout::combined ? fmt::format("c{}.", *cascade) : "");
      }
    }
    for (const BakedMap::Channel& channel : map.channels) {
      std::span<const float> values = channel.values(frame.written(*cascade));
      if (settings_.pixel_type == PixelType::half_16)
        values = rounded.emplace_back(round_to_half(map, values));
      image.channels.push_back({channel.name, values});
    }
  }
  image.attributes.emplace_back("values_hash", values_hash(image.channels));
  write_exr(files_.exr(frame.number, maps.front().file), image, settings_.pixel_type, settings_.compression);
}

/// The values as they will be read; keeps how far they are off.
std::vector<float> FrameWriter::round_to_half(const BakedMap& map, std::span<const float> values) {
  std::vector<float> rounded(values.size());
  HalfError found{.unit = map.unit};
  for (std::size_t i = 0; i < values.size(); ++i) {
    rounded[i] = rounded_to_half(values[i]);
    found.largest_error = std::max(found.largest_error, std::abs(values[i] - rounded[i]));
    found.largest_value = std::max(found.largest_value, std::abs(values[i]));
  }
  const std::lock_guard lock(half_errors_mutex_);
  HalfError& kept = half_errors_.try_emplace(map.name, found).first->second;
  kept.largest_error = std::max(kept.largest_error, found.largest_error);
  kept.largest_value = std::max(kept.largest_value, found.largest_value);
  return rounded;
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
  if (settings_.axes == MapAxes::z_up) {
    image.attributes.emplace_back("axes", "z-up");
  }
  if (!sea_.parameters.gerstner_waves.waves.empty()) {
    add_gerstner_attributes(image, frame.time_s);
  }
  return image;
}

/// The waves as they stand at this time: h = sum of A cos(kx x + kz z + phase), displaced sideways by -Q A
/// K/k sin(kx x + kz z + phase); with z up, ky y instead of kz z.
void FrameWriter::add_gerstner_attributes(ExrImage& image, double time_s) const {
  const ocean::GerstnerInstant instant(sea_.parameters.gerstner_waves, time_s);
  const bool is_z_up = settings_.axes == MapAxes::z_up;
  std::string list;
  for (const ocean::GerstnerInstant::Wave& wave : instant.waves()) {
    const double phase_rad = std::remainder(wave.phase_rad, 2.0 * std::numbers::pi);
    list += fmt::format("{}{:.17g} {:.17g} {:.17g} {:.17g}", list.empty() ? "" : "; ", wave.amplitude_m,
                        wave.kx_radpm, is_z_up ? -wave.kz_radpm : wave.kz_radpm, phase_rad);
  }
  image.attributes.emplace_back("gerstner", list);
  image.attributes.emplace_back("gerstner_columns",
                                fmt::format("A_m kx_radpm {}_radpm phase_rad", is_z_up ? "ky" : "kz"));
  image.attributes.emplace_back("gerstner_choppiness", instant.horizontal_scale());
}

/// Its first texel is at this place; texels go on along x and to the south.
void FrameWriter::set_wake_place(ExrImage& image, const BakedFrame::Wake& wake, int cells) const {
  image.width = image.height = cells;
  const bool is_z_up = settings_.axes == MapAxes::z_up;
  image.attributes.emplace_back("texel_m", wake.cell_m);
  image.attributes.emplace_back("origin_x_m", wake.origin_x_m);
  image.attributes.emplace_back(is_z_up ? "origin_y_m" : "origin_z_m",
                                is_z_up ? -wake.origin_z_m : wake.origin_z_m);
}

void FrameWriter::add_cascade_attributes(ExrImage& image, std::size_t cascade,
                                         const std::string& layer) const {
  const ocean::Cascade& band = sea_.parameters.cascades[cascade];
  image.attributes.emplace_back(layer + "patch_size_m", band.patch_length_m);
  image.attributes.emplace_back(layer + "k_min_radpm", band.k_min_radpm);
  image.attributes.emplace_back(layer + "k_max_radpm", band.k_max_radpm);
}

}  // namespace offing::cli
