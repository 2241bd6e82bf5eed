#include "host/io/exr_rows.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <thread>

#include <Imath/half.h>
#include <zlib.h>

#include "host/base/error.h"
#include "host/base/parallel_for.h"

namespace offing {
namespace {

static_assert(std::endian::native == std::endian::little, "EXR files are little-endian");

/// In front of each block: its row and its bytes.
constexpr std::size_t head_bytes = 2 * sizeof(std::int32_t);

/// Makes blocks; for one thread.
class RowPacker {
 public:
  explicit RowPacker(const ExrRows& image) : image_(image) {
    if (image.compression == ExrCompression::none) return;
    // Runs and the frequency of bytes are all there is to find.
    if (deflateInit2(&deflate_, Z_DEFAULT_COMPRESSION, Z_DEFLATED, 15, 8, Z_RLE) != Z_OK) {
      throw Error(ErrorKind::out_of_memory, "an EXR file: expected 256 kB for its compression, found none",
                  "close other programs");
    }
  }
  RowPacker(const RowPacker&) = delete;
  RowPacker& operator=(const RowPacker&) = delete;
  ~RowPacker() {
    if (image_.compression != ExrCompression::none) deflateEnd(&deflate_);
  }

  void pack(int row, std::string& block) {
    const std::size_t bytes = bytes_a_row(image_);
    block.resize(head_bytes + bytes);
    char* const values = block.data() + head_bytes;
    fill(row, values);
    std::int32_t head[2] = {row, static_cast<std::int32_t>(bytes)};
    if (image_.compression == ExrCompression::zips && compress(values, bytes)) {
      head[1] = static_cast<std::int32_t>(compressed_.size());
      std::copy(compressed_.begin(), compressed_.end(), values);
      block.resize(head_bytes + compressed_.size());
    }
    std::memcpy(block.data(), head, head_bytes);
  }

  static std::size_t bytes_a_row(const ExrRows& image) {
    return image.channels.size() * static_cast<std::size_t>(image.columns) * (is_half(image) ? 2 : 4);
  }

 private:
  static bool is_half(const ExrRows& image) { return image.pixel_type == PixelType::half_16; }

  void fill(int row, char* to) const {
    const auto columns = static_cast<std::size_t>(image_.columns);
    for (const std::span<const float> channel : image_.channels) {
      const std::span<const float> values = channel.subspan(static_cast<std::size_t>(row) * columns, columns);
      if (is_half(image_)) {
        for (const float value : values) {
          const std::uint16_t bits = half_bits(value);
          std::memcpy(to, &bits, sizeof(bits));
          to += sizeof(bits);
        }
      } else {
        std::memcpy(to, values.data(), values.size_bytes());
        to += values.size_bytes();
      }
    }
  }

  /// As OpenEXR's ZIPS: bytes at even places, then those at odd ones; of these the difference to the byte
  /// before, plus 128; then zlib. False if that is no shorter, as then the values themselves are stored.
  bool compress(const char* values, std::size_t bytes) {
    sorted_.resize(bytes);
    compressed_.resize(bytes - 1);
    for (std::size_t i = 0; i < bytes / 2; ++i) {
      sorted_[i] = static_cast<unsigned char>(values[2 * i]);
      sorted_[bytes / 2 + i] = static_cast<unsigned char>(values[2 * i + 1]);
    }
    for (std::size_t i = bytes - 1; i > 0; --i) {
      sorted_[i] = static_cast<unsigned char>(sorted_[i] - sorted_[i - 1] + 128);
    }
    deflateReset(&deflate_);
    deflate_.next_in = sorted_.data();
    deflate_.avail_in = static_cast<uInt>(bytes);
    deflate_.next_out = compressed_.data();
    deflate_.avail_out = static_cast<uInt>(compressed_.size());
    if (deflate(&deflate_, Z_FINISH) != Z_STREAM_END) return false;
    compressed_.resize(compressed_.size() - deflate_.avail_out);
    return true;
  }

  const ExrRows& image_;
  z_stream deflate_{};
  std::vector<unsigned char> sorted_, compressed_;
};

}  // namespace

std::uint16_t half_bits(float value) {
  constexpr float largest_half = 65504.0f;
  return imath_float_to_half(std::clamp(value, -largest_half, largest_half));
}

void write_exr_rows(AtomicFile& file, const ExrRows& image) {
  const auto rows = static_cast<std::size_t>(image.rows);
  std::vector<std::uint64_t> places(rows);
  const std::uint64_t table = file.position();
  file.write(places.data(), rows * sizeof(std::uint64_t));
  std::uint64_t place = table + rows * sizeof(std::uint64_t);
  // Enough rows that starting threads for them costs little, few enough to wait in memory.
  constexpr std::size_t rows_at_once = 128, rows_a_turn = 4, bytes_a_thread = std::size_t{1} << 17;
  const std::size_t bytes_at_once = std::min(rows, rows_at_once) * RowPacker::bytes_a_row(image);
  const auto threads = static_cast<int>(std::clamp<std::size_t>(
      bytes_at_once / bytes_a_thread, 1, std::max(1u, std::thread::hardware_concurrency())));
  std::vector<std::string> blocks(std::min(rows, rows_at_once));
  for (std::size_t first = 0; first < rows; first += rows_at_once) {
    const std::size_t count = std::min(rows - first, rows_at_once);
    ChunkQueue queue(count, rows_a_turn);
    parallel_rows(
        threads,
        [&](int) {
          RowPacker packer(image);
          queue.drain([&](std::size_t i) { packer.pack(static_cast<int>(first + i), blocks[i]); });
        },
        threads);
    for (std::size_t i = 0; i < count; ++i) {
      places[first + i] = place;
      place += blocks[i].size();
      file.write(blocks[i]);
    }
  }
  file.seek(table);
  file.write(places.data(), rows * sizeof(std::uint64_t));
}

}  // namespace offing
