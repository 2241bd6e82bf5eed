#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "host/io/file_trust.h"

namespace offing {

/// How a height is packed into the samples of a picture.
enum class HeightEncoding {
  plain,      ///< one band holds heights
  mapbox,     ///< 8-bit RGB: h = -10000 + 0.1 (65536 R + 256 G + B) m
  terrarium,  ///< 8-bit RGB: h = 256 R + G + B / 256 - 32768 m
};

/// Samples of a file without a header.
enum class RawType { unsigned_16, signed_16, float_32 };
/// Of samples of more than one byte.
enum class ByteOrder { little_endian, big_endian };

/// What coordinates count in, where the file does not say.
enum class HorizontalUnit { of_file, metre, degree };

/// How to read a height map; what is left alone is taken from the file.
struct HeightMapOptions {
  HeightEncoding encoding = HeightEncoding::plain;
  int band = 1;             ///< of files with several, counted from 1
  std::string exr_channel;  ///< empty: the only one, or one of height, Y, Z, R

  /// Files without a header (.r16, .r32, .raw, .bin): posts along x and z; 0 for all others.
  int raw_columns = 0, raw_rows = 0;
  std::optional<RawType> raw_type;  ///< by default unsigned_16 for .r16, float_32 for .r32
  ByteOrder raw_byte_order = ByteOrder::little_endian;

  double vertical_scale = 1.0;  ///< metres a unit of the file's, after its own scale and unit
  double offset_m = 0.0;        ///< added to the scaled height
  std::optional<double> spacing_x_m, spacing_z_m;
  /// A sample with this value, before any scale, is a void, beside those that the file marks. NaN may be
  /// given.
  std::optional<double> nodata;
  std::optional<double>
      void_height_m;  ///< height of voids; by default they are filled from their surroundings
  HorizontalUnit horizontal_unit = HorizontalUnit::of_file;
  /// Coordinate system in metres to resample to: "utm" (the zone of the centre), or what PROJ understands,
  /// such as "EPSG:32719". Empty: the posts stay where they are.
  std::string reproject_to;

  FileTrust trust;  ///< how far the file may lead
};

}  // namespace offing
