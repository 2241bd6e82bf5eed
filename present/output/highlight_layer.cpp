#include "present/output/highlight_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "host/io/exr_image.h"
#include "host/io/png_image.h"

namespace offing::present {
namespace {

using Rgb = std::array<float, 3>;

Rgb rgb_of(const PictureLight& picture, std::size_t pixel) {
  const float* values = &picture.rgba[4 * pixel];
  return {values[0], values[1], values[2]};
}

/// As a screen shows light, 0 ... 1, still linear.
Rgb shown(const Rgb& kcdpm2, double exposure) {
  const auto gain = static_cast<float>(exposure);
  return {filmic(gain * kcdpm2[0]), filmic(gain * kcdpm2[1]), filmic(gain * kcdpm2[2])};
}

/// The least alpha with which something of 0 or more, laid over `below`, gives `above`.
float alpha_that_darkens(const Rgb& above, const Rgb& below) {
  float alpha = 0.0f;
  for (std::size_t c = 0; c < 3; ++c) {
    if (above[c] < below[c]) alpha = std::max(alpha, 1.0f - above[c] / below[c]);
  }
  return alpha;
}

/// The least alpha with which something of 1 or less does.
float alpha_that_brightens(const Rgb& above, const Rgb& below) {
  float alpha = 0.0f;
  for (std::size_t c = 0; c < 3; ++c) {
    if (above[c] > below[c]) alpha = std::max(alpha, (above[c] - below[c]) / (1.0f - below[c]));
  }
  return alpha;
}

void add_light(HighlightLayer& layer, float alpha, const Rgb& above, const Rgb& below) {
  alpha = std::clamp(std::max(alpha, alpha_that_darkens(above, below)), 0.0f, 1.0f);
  for (std::size_t c = 0; c < 3; ++c) layer.light.push_back(above[c] - (1.0f - alpha) * below[c]);
  layer.light.push_back(alpha);
}

void add_shown(HighlightLayer& layer, float alpha, const Rgb& above, const Rgb& below) {
  alpha = std::max({alpha, alpha_that_darkens(above, below), alpha_that_brightens(above, below)});
  // The colour makes up for the steps of alpha, which is rounded up to leave it the room.
  const float steps = std::clamp(std::ceil(255.0f * alpha - 1e-3f), 0.0f, 255.0f), stored = steps / 255.0f;
  for (std::size_t c = 0; c < 3; ++c) {
    const float premultiplied = above[c] - (1.0f - stored) * below[c];
    layer.shown.rgba.push_back(steps > 0.0f ? srgb_from_linear(premultiplied / stored) : std::uint8_t{0});
  }
  layer.shown.rgba.push_back(static_cast<std::uint8_t>(steps));
}

}  // namespace

PictureLight read_light(const RenderTarget& light) {
  return {light.width(), light.height(), light.read()};
}

HighlightLayer highlight_layer(const PictureLight& alone, const PictureLight& with,
                               const PictureLight& without, double exposure) {
  HighlightLayer layer{.width = alone.width, .height = alone.height, .light = {}, .shown = {}};
  layer.shown.width = alone.width;
  layer.shown.height = alone.height;
  const auto width = static_cast<std::size_t>(alone.width), height = static_cast<std::size_t>(alone.height);
  layer.light.reserve(4 * width * height);
  layer.shown.rgba.reserve(4 * width * height);
  for (std::size_t row = height; row-- > 0;) {
    for (std::size_t pixel = row * width; pixel < (row + 1) * width; ++pixel) {
      const float alpha = alone.rgba[4 * pixel + 3];
      const Rgb above = rgb_of(with, pixel), below = rgb_of(without, pixel);
      add_light(layer, alpha, above, below);
      add_shown(layer, alpha, shown(above, exposure), shown(below, exposure));
    }
  }
  return layer;
}

HighlightLayer highlight_layer(const PictureLight& alone, double exposure) {
  const PictureLight black{alone.width, alone.height, std::vector<float>(alone.rgba.size(), 0.0f)};
  return highlight_layer(alone, alone, black, exposure);
}

void write_layer(const std::filesystem::path& path, const HighlightLayer& layer, double time_s,
                 double exposure, Existing existing) {
  if (path.extension() == ".png") {
    write_file_atomically(path, png_bytes(layer.shown), existing);
    return;
  }
  constexpr std::array<const char*, 4> names{"R", "G", "B", "A"};
  std::array<std::vector<float>, 4> channels;
  for (std::size_t i = 0; i < layer.light.size(); ++i) channels[i % 4].push_back(layer.light[i]);
  ExrImage image{.width = layer.width,
                 .height = layer.height,
                 .channels = {},
                 .attributes = {{"time_s", time_s},
                                {"unit", std::string("kcd/m2")},
                                {"exposure", exposure},
                                {"alpha", std::string("premultiplied")}}};
  for (std::size_t c = 0; c < names.size(); ++c) image.channels.push_back({names[c], channels[c]});
  write_exr(path, image, PixelType::half_16, ExrCompression::zip, existing);
}

}  // namespace offing::present
