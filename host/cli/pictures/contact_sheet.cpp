#include "host/cli/pictures/contact_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"

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

std::vector<ContactFrame> chosen(std::span<const ContactFrame> frames) {
  const std::size_t count = std::min<std::size_t>(frames.size(), most_frames);
  std::vector<ContactFrame> some;
  for (std::size_t i = 0; i < count; ++i) {
    some.push_back(frames[count == 1 ? 0 : i * (frames.size() - 1) / (count - 1)]);
  }
  return some;
}

}  // namespace

RgbImage make_contact_sheet(std::span<const ContactFrame> frames) {
  if (frames.empty()) {
    throw Error(ErrorKind::bad_input, "contact sheet: no frames", "make at least one preview picture first");
  }
  const std::vector<ContactFrame> shown = chosen(frames);
  const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(shown.size()))));
  const int rows = (static_cast<int>(shown.size()) + columns - 1) / columns;
  RgbImage sheet;
  int cell_height = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const RgbImage picture = read_png(shown[i].picture);
    if (i == 0) {
      cell_height = std::max(digit_margin + (digit_rows + 2) * digit_scale,
                             cell_width * picture.height / picture.width);
      sheet.width = columns * (cell_width + gap) + gap;
      sheet.height = rows * (cell_height + gap) + gap;
      sheet.rgb.assign(std::size_t{3} * sheet.width * sheet.height, background);
    }
    const int index = static_cast<int>(i);
    const Place place{gap + (index % columns) * (cell_width + gap),
                      gap + (index / columns) * (cell_height + gap)};
    draw_scaled(sheet, place, cell_width, cell_height, picture);
    draw_number(sheet, place, fmt::format("{:04d}", std::abs(shown[i].number)));
  }
  return sheet;
}

}  // namespace offing::cli
