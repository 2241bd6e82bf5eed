#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/file_extension.h"
#include "host/io/height_maps/source_heights.h"

namespace offing::height_maps {

namespace {

RawType raw_type_of(const std::filesystem::path& path, const HeightMapOptions& options) {
  const std::string extension = lower_extension(path);
  if (options.raw_type) {
    return *options.raw_type;
  }
  if (extension == ".r16") {
    return RawType::unsigned_16;
  }
  if (extension == ".r32") {
    return RawType::float_32;
  }
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: a file without a header, expected the type of its samples", path.string()),
              "give --raw-type u16, s16 or f32");
}

/// What the number of samples suggests: a square, if it is one.
std::string size_hint(std::uintmax_t samples) {
  const auto side = static_cast<std::uintmax_t>(std::llround(std::sqrt(static_cast<double>(samples))));
  return side * side == samples && side > 1
             ? fmt::format(
                   "it would fit a square: --raw-size {0}x{0}; in a scene, raw_columns and raw_rows = {0}",
                   side)
             : "give --raw-size COLUMNSxROWS that fits; in a scene, raw_columns and raw_rows";
}

template <typename Bits>
Bits bits_of(const char* bytes, ByteOrder order) {
  Bits bits = 0;
  for (std::size_t i = 0; i < sizeof(Bits); ++i) {
    const std::size_t shift = 8 * (order == ByteOrder::little_endian ? i : sizeof(Bits) - 1 - i);
    bits = static_cast<Bits>(bits | static_cast<Bits>(Bits{static_cast<unsigned char>(bytes[i])} << shift));
  }
  return bits;
}

double sample_of(const char* bytes, RawType type, ByteOrder order) {
  switch (type) {
    case RawType::unsigned_16:
      return bits_of<std::uint16_t>(bytes, order);
    case RawType::signed_16:
      return static_cast<std::int16_t>(bits_of<std::uint16_t>(bytes, order));
    case RawType::float_32:
      return std::bit_cast<float>(bits_of<std::uint32_t>(bytes, order));
  }
  return 0.0;
}

const char* name_of(RawType type) {
  return type == RawType::unsigned_16 ? "UInt16" : type == RawType::signed_16 ? "Int16" : "Float32";
}

}  // namespace

bool is_raw_name(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".r16" || extension == ".r32" || extension == ".raw" || extension == ".bin";
}

SourceHeights read_raw_heights(const std::filesystem::path& path, const HeightMapOptions& options,
                               const RowTaker& taker) {
  const RawType type = raw_type_of(path, options);
  const std::size_t sample_bytes = type == RawType::float_32 ? 4 : 2;
  const std::uintmax_t bytes = std::filesystem::file_size(path);
  if (options.raw_columns == 0 || options.raw_rows == 0) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: a file without a header, expected its size in posts", path.string()),
                size_hint(bytes / sample_bytes));
  }
  // Before check_size(): a wrong size is not a lack of memory.
  const std::uintmax_t expected = std::uintmax_t{sample_bytes} *
                                  static_cast<std::uintmax_t>(options.raw_columns) *
                                  static_cast<std::uintmax_t>(options.raw_rows);
  if (bytes != expected) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: {}x{} posts of {} take {} bytes, found {}", path.string(),
                            options.raw_columns, options.raw_rows, name_of(type), expected, bytes),
                bytes % sample_bytes == 0
                    ? size_hint(bytes / sample_bytes)
                    : "the file is cut short, or its samples are of another type: --raw-type");
  }
  SourceHeights source = begin_heights(path, options.raw_columns, options.raw_rows, taker);
  source.format = "raw";
  source.sample_type = name_of(type);
  const HeightScale scale{options.vertical_scale, options.offset_m};
  if (taker.begin) taker.begin(source);
  std::ifstream file(path, std::ios::binary);
  std::vector<char> row(sample_bytes * static_cast<std::size_t>(source.columns));
  for (int r = 0; r < source.rows; ++r) {
    if (!file.read(row.data(), static_cast<std::streamsize>(row.size()))) {
      throw Error(ErrorKind::file, fmt::format("{}: row {} cannot be read", path.string(), r),
                  "check the permissions of the file, and the disk");
    }
    for (std::size_t at = 0; at < row.size(); at += sample_bytes) {
      const double sample = sample_of(&row[at], type, options.raw_byte_order);
      append_sample(path, source, sample, scale, options.nodata);
    }
    hand_over_rows(source);
  }
  return source;
}

}  // namespace offing::height_maps
