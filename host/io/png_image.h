#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "host/base/rgba_image.h"
#include "host/io/atomic_file.h"

namespace offing {

/// An sRGB picture: rgb [height][width][3] row-major, row 0 at the top, 0 ... 255.
struct RgbImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Display value 0 ... 1, still linear, of exposed light: Narkowicz 2015, "ACES filmic tone mapping curve",
/// as present/passes/tone.frag has it.
float filmic(float exposed);

/// sRGB byte of a linear intensity; 0 and below (and NaN) give 0, 1 and above 255. IEC 61966-2-1.
std::uint8_t srgb_from_linear(float linear);

/// Fixed noise of a pixel, at least -0.5 and below 0.5, whose mean over a few pixels is 0: interleaved
/// gradient noise (Jimenez 2014), as present/passes/tone.frag has it.
float dither_noise(int column, int row);

/// The same byte with less than one step of this noise added before it is rounded, which hides the steps of 8
/// bits in smooth pictures. Black and white stay as they are.
std::uint8_t dithered_srgb(float linear, float noise);

/// How a PNG is compressed. For a picture of a sea, `fast` takes at most a quarter of the time and up to a
/// seventh more bytes.
enum class PngCompression { small, fast };

/// Writes an 8-bit PNG marked as sRGB, atomically; equal pictures give equal bytes.
/// Throws Error(bad_input) for an empty picture or pixels that do not match its size, Error(file) if it
/// cannot be written.
void write_png(const std::filesystem::path& path, const RgbImage& image,
               Existing existing = Existing::replace, PngCompression compression = PngCompression::small);

/// An 8-bit PNG marked as sRGB, for files that hold pictures. Throws Error(bad_input) as write_png() does.
std::string png_bytes(const RgbaImage& image);

/// Reads any PNG as 8-bit RGB, transparency over black. Throws Error(bad_input) if it cannot be read or is no
/// PNG.
RgbImage read_png(const std::filesystem::path& path);

/// The same with its transparency; of one that has none, all 255.
RgbaImage read_png_with_alpha(const std::filesystem::path& path);

}  // namespace offing
