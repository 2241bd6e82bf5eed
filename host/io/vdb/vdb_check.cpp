// Walks through the lengths and truth values in an OpenVDB file of format 222 or later (2013), as OpenVDB's
// own headers read it.
#include "host/io/vdb/vdb_check.h"

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <openvdb/Metadata.h>
#include <openvdb/io/Compression.h>
#include <openvdb/io/DelayedLoadMetadata.h>
#include <openvdb/openvdb.h>

namespace offing::vdb {
namespace {

using Mask = std::vector<std::uint64_t>;

std::uint64_t bits_in(const Mask& mask) {
  std::uint64_t count = 0;
  for (const std::uint64_t word : mask) count += static_cast<std::uint64_t>(std::popcount(word));
  return count;
}

/// The bytes of one value in the file: as it is, and in the arrays of nodes.
struct ValueBytes {
  std::uint64_t whole, stored;
};

ValueBytes bytes_of(const openvdb::GridBase& grid, bool is_half) {
  if (grid.isType<openvdb::FloatGrid>()) return {4, is_half ? 2U : 4U};
  if (grid.isType<openvdb::DoubleGrid>()) return {8, is_half ? 2U : 8U};
  return {12, is_half ? 6U : 12U};
}

/// Goes through a stream and throws for what does not fit into it.
class Walk {
 public:
  Walk(std::istream& stream, const PartOfVdb& part)
      : stream_(stream), part_(part), begin_(stream.tellg()), at_(begin_) {
    stream_.seekg(0, std::ios::end);
    end_ = stream_.tellg();
    go_back();
  }

  void go_back() {
    stream_.seekg(begin_);
    at_ = begin_;
  }

  std::string text() {
    const auto length = read<std::uint32_t>();
    require_left(length, "text");
    std::string text(length, '\0');
    stream_.read(text.data(), length);
    at_ += length;
    return text;
  }

  void metadata() {
    for (auto count = read<std::uint32_t>(); count > 0; --count) {
      text();  // its name
      const std::string type = text();
      const auto length = read<std::uint32_t>();
      require_left(length, "metadata");
      // The library does not use the length of a number.
      if (type != "string" && openvdb::Metadata::isRegisteredType(type)) {
        require_equal(length, openvdb::Metadata::createMetadata(type)->size(), "metadata");
      }
      if (type == "bool" && length == 1)
        truth();
      else
        skip(length);
    }
  }

  /// Kinds of transforms have names; a perspective holds a transform of another kind.
  void transform() {
    constexpr std::string_view perspective = "NonlinearFrustumMap";
    if (text() != perspective) return;
    skip(8 * sizeof(double));  // its box, taper and depth
    if (text() == perspective) fail("a perspective inside a perspective");
  }

  /// The root of a tree with its tiles; returns the number of its children.
  std::uint32_t root(const ValueBytes& value, std::uint32_t compression) {
    value_ = value;
    compression_ = compression;
    at_ = stream_.tellg();
    skip(sizeof(std::int32_t) + value_.whole);  // number of buffers and background
    const auto tiles = read<std::uint32_t>(), children = read<std::uint32_t>();
    require_left(tiles * (origin_bytes + value_.whole + 1), "tiles");
    for (std::uint32_t i = 0; i < tiles; ++i) {
      skip(origin_bytes + value_.whole);
      truth();  // whether it is active
    }
    return children;
  }

  /// What lies below the root of a compressed tree.
  void compressed_nodes(std::uint32_t children) {
    std::uint64_t leaves = 0;
    for (std::uint32_t i = 0; i < children; ++i) {
      skip(origin_bytes);
      leaves += node(32);
    }
    for (; leaves > 0; --leaves) values(leaf_cells, mask(leaf_cells));
  }

  template <typename Value>
  Value read() {
    Value value{};
    stream_.read(reinterpret_cast<char*>(&value), sizeof value);
    at_ += static_cast<std::streamoff>(sizeof value);
    return value;
  }

 private:
  static constexpr std::uint64_t origin_bytes = 3 * sizeof(std::int32_t), leaf_cells = 512;

  [[noreturn]] void fail(const std::string& found) const { throw broken_vdb(part_, found); }

  void require_left(std::uint64_t bytes, const char* what) const {
    const auto left = static_cast<std::uint64_t>(end_ - at_);
    if (bytes > left) fail(fmt::format("{} of {} bytes where {} are left", what, bytes, left));
  }

  void require_equal(std::uint64_t bytes, std::uint64_t expected, const char* what) const {
    if (bytes != expected) fail(fmt::format("{} of {} bytes instead of {}", what, bytes, expected));
  }

  /// The library takes a byte for a bool, which has two values.
  void truth() {
    require_left(1, "a truth value");
    if (const auto value = read<std::uint8_t>(); value > 1) fail(fmt::format("a truth value of {}", value));
  }

  void skip(std::uint64_t bytes) {
    require_left(bytes, "a part");
    at_ += static_cast<std::streamoff>(bytes);
    constexpr std::uint64_t near = 1 << 14;  // a jump empties the stream's buffer
    if (bytes < near)
      stream_.ignore(static_cast<std::streamsize>(bytes));
    else
      stream_.seekg(at_);
  }

  Mask mask(std::uint64_t bits) {
    Mask words(bits / 64);
    stream_.read(reinterpret_cast<char*>(words.data()), static_cast<std::streamsize>(bits / 8));
    at_ += static_cast<std::streamoff>(bits / 8);
    return words;
  }

  /// Returns the number of leaves below a node of edge^3 places.
  std::uint64_t node(std::uint64_t edge) {
    const std::uint64_t places = edge * edge * edge;
    const std::uint64_t children = bits_in(mask(places));
    values(places, mask(places));
    constexpr std::uint64_t lowest_edge = 16;
    if (edge == lowest_edge) {
      skip(children * leaf_cells / 8);
      return children;
    }
    std::uint64_t leaves = 0;
    for (std::uint64_t i = 0; i < children; ++i) leaves += node(lowest_edge);
    return leaves;
  }

  void values(std::uint64_t places, const Mask& active) {
    namespace io = openvdb::io;
    const auto kind = read<std::int8_t>();
    if (kind == io::MASK_AND_TWO_INACTIVE_VALS) skip(2 * value_.whole);
    if (kind == io::NO_MASK_AND_ONE_INACTIVE_VAL || kind == io::MASK_AND_ONE_INACTIVE_VAL) skip(value_.whole);
    if (kind == io::MASK_AND_NO_INACTIVE_VALS || kind == io::MASK_AND_ONE_INACTIVE_VAL ||
        kind == io::MASK_AND_TWO_INACTIVE_VALS) {
      skip(places / 8);
    }
    const bool has_active_alone =
        (compression_ & io::COMPRESS_ACTIVE_MASK) != 0 && kind != io::NO_MASK_AND_ALL_VALS;
    const std::uint64_t count = has_active_alone ? bits_in(active) : places;
    // Of no halves the library does not even read the size.
    if (count > 0 || value_.stored == value_.whole) block(count * value_.stored);
  }

  /// A block that unpacks to this many bytes.
  void block(std::uint64_t unpacked) {
    const auto length = read<std::int64_t>();  // below 0: that many bytes that are not packed
    if (length <= 0) {
      const std::uint64_t plain = 0 - static_cast<std::uint64_t>(length);
      require_equal(plain, unpacked, "a block");
      return skip(plain);
    }
    const auto packed = static_cast<std::uint64_t>(length);
    require_left(packed, "a block");
    if ((compression_ & openvdb::io::COMPRESS_BLOSC) == 0) return skip(packed);
    // Blosc itself trusts its header: four bytes, then three lengths.
    constexpr std::uint64_t header_bytes = 16;
    if (packed < header_bytes) fail(fmt::format("a block of {} bytes", packed));
    skip(4);
    require_equal(read<std::uint32_t>(), unpacked, "a block");
    skip(4);
    require_equal(read<std::uint32_t>(), packed, "a packed block");
    skip(packed - header_bytes);
  }

  std::istream& stream_;
  const PartOfVdb& part_;
  std::streamoff begin_, at_, end_ = 0;
  ValueBytes value_{};
  std::uint32_t compression_ = 0;
};

}  // namespace

void check_metadata(std::istream& stream, const PartOfVdb& part) {
  Walk walk(stream, part);
  walk.metadata();
  walk.go_back();
}

void check_descriptor(std::istream& stream, const PartOfVdb& part) {
  Walk walk(stream, part);
  for (int i = 0; i < 3; ++i) walk.text();  // names of the grid, of its type and of the one it shares
  walk.go_back();
}

void check_grid(std::istream& stream, const PartOfVdb& part, const openvdb::GridBase& grid) {
  Walk walk(stream, part);
  const auto compression = walk.read<std::uint32_t>();
  walk.metadata();
  walk.transform();
  walk.go_back();
  walk.read<std::uint32_t>();
  // Metadata say whether values are halves, and each kind of transform has a length of its own.
  const openvdb::GridBase::Ptr header = grid.copyGridWithNewTree();
  header->readMeta(stream);
  header->readTransform(stream);
  const std::uint32_t children = walk.root(bytes_of(grid, header->saveFloatAsHalf()), compression);
  if ((compression & (openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_BLOSC)) != 0) {
    walk.compressed_nodes(children);
  }
  walk.go_back();
}

void initialize() {
  [[maybe_unused]] static const bool once = [] {
    openvdb::initialize();
    openvdb::io::DelayedLoadMetadata::unregisterType();
    return true;
  }();
}

bool is_readable(const openvdb::GridBase& grid) {
  return grid.isType<openvdb::FloatGrid>() || grid.isType<openvdb::DoubleGrid>() ||
         grid.isType<openvdb::Vec3SGrid>();
}

}  // namespace offing::vdb
