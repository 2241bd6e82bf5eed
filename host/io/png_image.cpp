#include "host/io/png_image.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <png.h>
#include <zlib.h>

#include "host/base/error.h"
#include "host/io/atomic_file.h"

namespace offing {
namespace {

/// `name` stands for the picture in messages.
void require_pixels_of_size(const std::string& name, int width, int height, std::size_t channels,
                            std::size_t pixel_bytes) {
  const std::size_t bytes =
      width < 1 || height < 1 ? 0 : channels * static_cast<unsigned>(width) * static_cast<unsigned>(height);
  if (bytes != 0 && pixel_bytes == bytes) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: cannot write a picture of {}x{} pixels from {} bytes", name, width, height,
                          pixel_bytes),
              fmt::format("give width x height x {} bytes", channels));
}

[[noreturn]] void refuse_to_encode(const std::string& name, const std::string& why) {
  throw Error(ErrorKind::file, fmt::format("{}: cannot encode: {}", name, why), "make the picture smaller");
}

/// Pixels as a PNG file.
std::string encoded(const std::string& name, int width, int height, png_uint_32 format,
                    const std::vector<std::uint8_t>& pixels) {
  require_pixels_of_size(name, width, height, PNG_IMAGE_SAMPLE_CHANNELS(format), pixels.size());
  png_image description{};
  description.version = PNG_IMAGE_VERSION;
  description.width = static_cast<png_uint_32>(width);
  description.height = static_cast<png_uint_32>(height);
  description.format = format;
  std::string file(PNG_IMAGE_PNG_SIZE_MAX(description), '\0');
  png_alloc_size_t size = file.size();
  if (png_image_write_to_memory(&description, file.data(), &size, 0, pixels.data(), 0, nullptr) == 0)
    refuse_to_encode(name, description.message);
  file.resize(size);
  return file;
}

/// Writes a picture through libpng's functions; false if one failed. A failure jumps back to the start, so
/// nothing here may have a destructor. Deflate gets differences from the pixel to the left and looks for runs
/// of a byte alone. A sea is noise: it repeats little else, and searching for that takes longer than the
/// rest.
bool write_rows(png_structp png, png_infop info, const RgbImage& image) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  const auto width = static_cast<png_uint_32>(image.width), height = static_cast<png_uint_32>(image.height);
  png_set_IHDR(png, info, width, height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_set_compression_level(png, Z_BEST_SPEED);
  png_set_compression_strategy(png, Z_RLE);
  png_write_info(png, info);
  for (std::size_t row = 0; row < height; ++row) png_write_row(png, &image.rgb[3 * row * width]);
  png_write_end(png, info);
  return true;
}

/// Pixels as a PNG file, in half the time. libpng's simple interface cannot choose filter and strategy.
std::string encoded_fast(const std::string& name, const RgbImage& image) {
  require_pixels_of_size(name, image.width, image.height, 3, image.rgb.size());
  std::string file, failure = "too little memory";
  // No exception may pass through libpng. A row has one more byte, its filter.
  const auto filter_bytes = static_cast<std::size_t>(image.height);
  file.reserve((image.rgb.size() + filter_bytes) / 4 * 5 + 1024);
  png_structp png = png_create_write_struct(
      PNG_LIBPNG_VER_STRING, &failure,
      [](png_structp failed, png_const_charp message) {
        *static_cast<std::string*>(png_get_error_ptr(failed)) = message;
        png_longjmp(failed, 1);
      },
      [](png_structp, png_const_charp) {});  // no warnings: what fails is an error
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &file,
      [](png_structp from, png_bytep bytes, std::size_t count) {
        static_cast<std::string*>(png_get_io_ptr(from))->append(reinterpret_cast<const char*>(bytes), count);
      },
      nullptr);
  const bool written = png != nullptr && info != nullptr && write_rows(png, info, image);
  png_destroy_write_struct(&png, &info);
  if (!written) refuse_to_encode(name, failure);
  return file;
}

/// Throws where a header promises more pixels than its file can hold: deflate shrinks to a 1032nd at most,
/// and a pixel takes a bit or more.
void require_pixels(const std::filesystem::path& path, const png_image& header, std::size_t file_bytes) {
  const double most = 8.0 * 1032.0 * static_cast<double>(file_bytes);
  if (static_cast<double>(header.width) * header.height <= most) return;
  throw Error(
      ErrorKind::bad_input,
      fmt::format(
          "{}: not a whole PNG file: expected at most {:.0f} pixels in {} bytes, found a header for {}x{}",
          path.string(), most, file_bytes, header.width, header.height),
      "make the picture again");
}

/// Pixels in a format of libpng; returns width and height.
std::pair<int, int> decode_png(const std::filesystem::path& path, png_uint_32 format,
                               const png_color* background, std::vector<std::uint8_t>& pixels) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file.good() && !file.eof()) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: cannot read: {}", path.string(), std::strerror(errno)),
                "check the path");
  }
  png_image description{};
  description.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> freed(&description, png_image_free);
  bool decoded = png_image_begin_read_from_memory(&description, bytes.data(), bytes.size()) != 0;
  if (decoded) {
    require_pixels(path, description, bytes.size());
    description.format = format;
    pixels.resize(PNG_IMAGE_SIZE(description));
    decoded = png_image_finish_read(&description, background, pixels.data(), 0, nullptr) != 0;
  }
  if (!decoded) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: not a whole PNG file: {}", path.string(), description.message),
                "make the picture again");
  }
  return {static_cast<int>(description.width), static_cast<int>(description.height)};
}

/// 255 times the sRGB curve of a linear intensity in [0, 1].
float srgb_curve(float linear) {
  return 255.0f * (linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f);
}

// Straight lines between 256 points an octave replace the curve where they give the same byte. Their error is
// at most 0.0001 (an eighth of the second derivative times the squared length, at 0.5), besides rounding.
constexpr float least_by_lines = 1.0f / 256.0f;
constexpr int octaves = 8, pieces_an_octave = 256, piece_bits = 15;
constexpr float lines_tolerance = 0.001f;

/// srgb_curve() within lines_tolerance, for least_by_lines <= linear < 1. Read as an integer, a float's bits
/// grow linearly within an octave and carry on into the next.
float srgb_by_lines(float linear) {
  constexpr std::uint32_t first = std::bit_cast<std::uint32_t>(least_by_lines);
  static const std::vector<float> points = [] {
    std::vector<float> values;
    for (std::uint32_t i = 0; i <= octaves * pieces_an_octave; ++i)
      values.push_back(srgb_curve(std::bit_cast<float>(first + (i << piece_bits))));
    return values;
  }();
  const std::uint32_t place = std::bit_cast<std::uint32_t>(linear) - first, piece = place >> piece_bits;
  const float share = static_cast<float>(place & ((1u << piece_bits) - 1)) / (1u << piece_bits);
  return points[piece] + share * (points[piece + 1] - points[piece]);
}

}  // namespace

float filmic(float exposed) {
  const float x = exposed;
  return std::clamp(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f), 0.0f, 1.0f);
}

float dither_noise(int column, int row) {
  // No value here is negative. std::floor() would be a function call.
  const auto fraction = [](float value) { return value - static_cast<float>(static_cast<int>(value)); };
  const float x = static_cast<float>(column) + 0.5f, y = static_cast<float>(row) + 0.5f;
  return fraction(52.9829189f * fraction(0.06711056f * x + 0.00583715f * y)) - 0.5f;
}

std::uint8_t srgb_from_linear(float linear) {
  return dithered_srgb(linear, 0.0f);
}

std::uint8_t dithered_srgb(float linear, float noise) {
  if (!(linear > 0.0f)) return 0;
  if (linear >= 1.0f) return 255;
  if (linear >= least_by_lines && std::abs(noise) < 1.0f) {
    const float value = srgb_by_lines(linear) + noise;
    const int whole = static_cast<int>(value);
    const float past_half = value - static_cast<float>(whole) - 0.5f;
    if (std::abs(past_half) > lines_tolerance)
      return static_cast<std::uint8_t>(std::min(255, whole + (past_half > 0.0f)));
  }
  return static_cast<std::uint8_t>(std::lround(std::clamp(srgb_curve(linear) + noise, 0.0f, 255.0f)));
}

void write_png(const std::filesystem::path& path, const RgbImage& image, Existing existing,
               PngCompression compression) {
  const std::string file = compression == PngCompression::fast
                               ? encoded_fast(path.string(), image)
                               : encoded(path.string(), image.width, image.height, PNG_FORMAT_RGB, image.rgb);
  write_file_atomically(path, file, existing);
}

std::string png_bytes(const RgbaImage& image) {
  return encoded("picture", image.width, image.height, PNG_FORMAT_RGBA, image.rgba);
}

RgbImage read_png(const std::filesystem::path& path) {
  const png_color black{0, 0, 0};
  RgbImage image;
  std::tie(image.width, image.height) = decode_png(path, PNG_FORMAT_RGB, &black, image.rgb);
  return image;
}

RgbaImage read_png_with_alpha(const std::filesystem::path& path) {
  RgbaImage image;
  std::tie(image.width, image.height) = decode_png(path, PNG_FORMAT_RGBA, nullptr, image.rgba);
  return image;
}

}  // namespace offing
