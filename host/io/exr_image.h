#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "host/io/atomic_file.h"

namespace offing {

/// A channel to be written: values [height][width] row-major, row 0 first. A layer is part of the name, as in
/// "c0.displacement.X".
struct ImageChannel {
  std::string name;
  std::span<const float> values;
};

using ExrAttribute = std::variant<std::string, double, int>;
using ExrAttributes = std::vector<std::pair<std::string, ExrAttribute>>;

/// What to write; the channels refer to the caller's arrays.
struct ExrImage {
  int width = 0, height = 0;
  std::vector<ImageChannel> channels;
  ExrAttributes attributes;  ///< beside the ones that every EXR has
};

/// What was read; channels and attributes are sorted by name.
struct ExrContent {
  /// Values under a name, "c0.displacement.X".
  struct Channel {
    std::string name;
    std::vector<float> values;  ///< [height][width]
  };
  int width = 0, height = 0;
  std::vector<Channel> channels;
  ExrAttributes attributes;

  /// Values of a channel; throws Error(bad_input) if there is none of that name.
  const std::vector<float>& channel(const std::string& name) const;
};

/// How channels are stored.
enum class PixelType { half_16, float_32 };
/// half_16 keeps a value within the larger of this share of it and this number.
inline constexpr double half_relative_error = 1.0 / 2048.0, half_absolute_error = 1.0 / 33554432.0;
/// What half_16 makes of a value.
float rounded_to_half(float value);
/// OpenEXR's lossless compressions.
enum class ExrCompression { none, zips, zip, piz };

/// Writes a scan line EXR, atomically (AtomicFile). Equal images give equal bytes: no clock, no host name,
/// and the order of channels and attributes does not matter.
///
/// With half_16, values beyond +-65504 (infinities too) become +-65504 and others are rounded to nearest;
/// with float_32 they are kept bit by bit. Throws Error(bad_input) for a NaN (which channel, row, column), an
/// empty image, values that do not match the size, repeated names or attribute names that EXR itself uses;
/// Error(file) if it cannot be written.
void write_exr(const std::filesystem::path& path, const ExrImage& image, PixelType pixel_type,
               ExrCompression compression, Existing existing = Existing::replace);

/// Reads all channels of a single-part EXR as float, and its string, double, float and int attributes.
/// Throws Error(bad_input) if it cannot be opened or is not a whole EXR.
ExrContent read_exr(const std::filesystem::path& path);

/// Reads the string, double, float and int attributes alone: quick, whatever the size of the image. Errors as
/// read_exr.
ExrAttributes read_exr_attributes(const std::filesystem::path& path);

}  // namespace offing
