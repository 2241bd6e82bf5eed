#include "host/cli/pictures/contact_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace offing::cli {
namespace {

constexpr int most_frames = 24;
constexpr int cell_width = 320;
constexpr int gap = 4;
constexpr int digit_columns = 5, digit_rows = 7, digit_scale = 2, digit_margin = 6;
constexpr std::uint8_t background = 24;

/// Digits 0 ... 9, a byte a row, the leftmost of five columns in bit 4.
constexpr std::array<std::array<std::uint8_t, digit_rows>, 10> digits{{{14, 17, 19, 21, 25, 17, 14},
                                                                       {4, 12, 4, 4, 4, 4, 14},
                                                                       {14, 17, 1, 2, 4, 8, 31},
                                                                       {31, 2, 4, 2, 1, 17, 14},
                                                                       {2, 6, 10, 18, 31, 2, 2},
                                                                       {31, 16, 30, 1, 1, 17, 14},
                                                                       {6, 8, 16, 30, 17, 17, 14},
                                                                       {31, 1, 2, 4, 8, 8, 8},
                                                                       {14, 17, 17, 14, 17, 17, 14},
                                                                       {14, 17, 17, 15, 1, 2, 12}}};

struct Place {
  int left = 0, top = 0;
};

std::uint8_t* pixel_of(RgbImage& image, int column, int row) {
  return &image.rgb[std::size_t{3} * (static_cast<std::size_t>(row) * image.width + column)];
}

RgbImage blank(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(std::size_t{3} * width * height, background)};
}

/// Mean of the source pixels that each pixel of the cell covers; bytes are averaged as they are, which is
/// good enough for a picture to choose frames by.
void draw_scaled(RgbImage& sheet, Place place, int width, int height, const RgbImage& source) {
  for (int row = 0; row < height; ++row) {
    const int top = row * source.height / height,
              bottom = std::max(top + 1, (row + 1) * source.height / height);
    for (int column = 0; column < width; ++column) {
      const int left = column * source.width / width,
                right = std::max(left + 1, (column + 1) * source.width / width);
      std::array<int, 3> sums{};
      for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) {
          for (int c = 0; c < 3; ++c) {
            sums[c] += source.rgb[std::size_t{3} * (static_cast<std::size_t>(y) * source.width + x) + c];
          }
        }
      }
      const int count = (bottom - top) * (right - left);
      std::uint8_t* const pixel = pixel_of(sheet, place.left + column, place.top + row);
      for (int c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>((sums[c] + count / 2) / count);
    }
  }
}

/// White digits on a dark plate in the cell's upper left corner.
void draw_number(RgbImage& sheet, Place place, const std::string& text) {
  const int advance = (digit_columns + 1) * digit_scale;
  const int width = advance * static_cast<int>(text.size()) + digit_scale,
            height = (digit_rows + 2) * digit_scale;
  for (int row = 0; row < height; ++row) {
    std::fill_n(pixel_of(sheet, place.left + digit_margin, place.top + digit_margin + row), 3 * width,
                background);
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto& digit = digits[static_cast<std::size_t>(text[i] - '0')];
    const int left = place.left + digit_margin + digit_scale + advance * static_cast<int>(i);
    const int top = place.top + digit_margin + digit_scale;
    for (int y = 0; y < digit_rows * digit_scale; ++y) {
      for (int x = 0; x < digit_columns * digit_scale; ++x) {
        if (((digit[y / digit_scale] >> (digit_columns - 1 - x / digit_scale)) & 1) == 0) continue;
        std::fill_n(pixel_of(sheet, left + x, top + y), 3, std::uint8_t{255});
      }
    }
  }
}

int cell_height_of(const RgbImage& picture) {
  return std::max(digit_margin + (digit_rows + 2) * digit_scale, cell_width * picture.height / picture.width);
}

}  // namespace

ContactSheet::ContactSheet(const FrameRange& frames,
                           const std::function<std::filesystem::path(int)>& picture_of) {
  const int last = frames.last - frames.first, steps = std::min(last, most_frames - 1);
  for (int i = 0; i <= steps; ++i) {
    const int frame = frames.first + static_cast<int>(std::int64_t{i} * last / std::max(steps, 1));
    cells_.push_back({frame, picture_of(frame)});
  }
}

void ContactSheet::keep(int frame, const RgbImage& picture) {
  for (Cell& cell : cells_) {
    if (cell.frame != frame) continue;
    cell.kept = blank(cell_width, cell_height_of(picture));
    draw_scaled(cell.kept, {}, cell.kept.width, cell.kept.height, picture);
  }
}

RgbImage ContactSheet::draw() const {
  const int count = static_cast<int>(cells_.size());
  const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
  const int rows = (count + columns - 1) / columns;
  RgbImage sheet;
  int cell_height = 0;
  for (int i = 0; i < count; ++i) {
    const Cell& cell = cells_[i];
    const RgbImage read = cell.kept.rgb.empty() ? read_png(cell.picture) : RgbImage{};
    const RgbImage& picture = cell.kept.rgb.empty() ? read : cell.kept;
    if (i == 0) {
      cell_height = cell_height_of(picture);
      sheet = blank(columns * (cell_width + gap) + gap, rows * (cell_height + gap) + gap);
    }
    const Place place{gap + (i % columns) * (cell_width + gap), gap + (i / columns) * (cell_height + gap)};
    draw_scaled(sheet, place, cell_width, cell_height, picture);
    draw_number(sheet, place, fmt::format("{:04d}", std::abs(cell.frame)));
  }
  return sheet;
}

}  // namespace offing::cli
