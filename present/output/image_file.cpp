#include "present/output/image_file.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "host/io/atomic_file.h"
#include "host/io/exr_image.h"
#include "host/io/file_extension.h"
#include "host/io/file_presence.h"

namespace offing::present {
namespace {

void write_exr_of(const std::filesystem::path& path, const RenderTarget& light, double time_s,
                  double exposure, Existing existing) {
  const std::vector<float> pixels = light.read();
  const auto width = static_cast<std::size_t>(light.width()),
             height = static_cast<std::size_t>(light.height());
  std::vector<std::vector<float>> channels(3, std::vector<float>(width * height));
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t column = 0; column < width; ++column) {
      for (std::size_t c = 0; c < 3; ++c) {
        channels[c][row * width + column] = pixels[4 * ((height - 1 - row) * width + column) + c];
      }
    }
  }
  write_exr(path,
            {.width = light.width(),
             .height = light.height(),
             .channels = {{"R", channels[0]}, {"G", channels[1]}, {"B", channels[2]}},
             .attributes = {{"time_s", time_s}, {"unit", std::string("kcd/m2")}, {"exposure", exposure}}},
            PixelType::half_16, ExrCompression::zip, existing);
}

bool is_exr(const std::filesystem::path& path) {
  return path.extension() == ".exr";
}

}  // namespace

void require_image_name(const std::filesystem::path& path) {
  require_extension(path, {".png", ".exr"});
}

std::filesystem::path unused_image_name(const std::string& stem) {
  int number = 1;
  std::filesystem::path path;
  do {
    path = fmt::format("{}_{:03}.png", stem, number++);
  } while (is_taken(path));
  return path;
}

RgbImage shown_image(const Frame& frame) {
  const RenderTarget& screen = frame.screen();
  const std::vector<unsigned char> pixels = screen.read_bytes();
  const std::size_t row = 3 * static_cast<std::size_t>(screen.width());
  RgbImage image{.width = screen.width(), .height = screen.height(), .rgb = {}};
  // OpenGL's first row is at the bottom.
  for (auto end = pixels.end(); end != pixels.begin(); end -= static_cast<std::ptrdiff_t>(row)) {
    image.rgb.insert(image.rgb.end(), end - static_cast<std::ptrdiff_t>(row), end);
  }
  return image;
}

void write_image(const std::filesystem::path& path, const Frame& frame, double time_s, double exposure,
                 Existing existing) {
  if (is_exr(path)) {
    write_exr_of(path, frame.light(), time_s, exposure, existing);
  } else {
    write_png(path, shown_image(frame), existing);
  }
}

}  // namespace offing::present
