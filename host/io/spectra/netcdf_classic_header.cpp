#include "host/io/spectra/netcdf_classic_header.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace offing::spectra {
namespace {

constexpr std::uint64_t overflow = std::numeric_limits<std::uint64_t>::max();

// Longest name, and most dimensions of a variable, that libnetcdf has room for.
constexpr std::uint64_t longest_name = 256;
constexpr std::uint64_t most_dimensions = 1024;

enum class Tag : std::uint32_t { absent = 0, dimension = 10, variable = 11, attribute = 12 };

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  std::uint64_t result = 0;
  return __builtin_mul_overflow(a, b, &result) ? overflow : result;
}

std::uint64_t sum(std::uint64_t a, std::uint64_t b) {
  std::uint64_t result = 0;
  return __builtin_add_overflow(a, b, &result) ? overflow : result;
}

std::uint64_t padded(std::uint64_t size) {
  return sum(size, 3) / 4 * 4;
}

// Bytes of one value of an nc_type (byte, char, short, int, float, double, then CDF-5's unsigned and 64-bit
// types); 0 if there is no such type.
std::uint64_t type_size(std::uint64_t type) {
  constexpr std::array<std::uint64_t, 12> sizes{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
  return type < sizes.size() ? sizes[type] : 0;
}

/// Reads the header once, front to back; the first fault ends the walk.
class HeaderWalk {
 public:
  explicit HeaderWalk(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::string fault() {
    walk();
    return fault_;
  }

 private:
  struct Variable {
    std::uint64_t begin;
    std::uint64_t size;  ///< bytes of its values, of one record if it has records
    bool has_records;
  };

  void fail(std::string_view what) {
    if (fault_.empty()) fault_ = what;
  }
  bool is_sound() const { return fault_.empty(); }

  std::uint64_t remaining() const { return bytes_.size() - at_; }

  std::uint64_t take_big_endian(std::size_t width) {
    if (remaining() < width) {
      fail("the header is cut short");
      return 0;
    }
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < width; ++i)
      value = value << 8 | std::to_integer<std::uint64_t>(bytes_[at_++]);
    return value;
  }

  std::uint64_t take_count() { return take_big_endian(version_ == 5 ? 8 : 4); }
  std::uint64_t take_offset() { return take_big_endian(version_ == 1 ? 4 : 8); }

  void skip(std::uint64_t size) {
    if (size > remaining()) {
      fail("a length in the header exceeds the file");
    } else {
      at_ += static_cast<std::size_t>(size);
    }
  }

  void skip_name() {
    const std::uint64_t length = take_count();
    if (length == 0 || length > longest_name) fail("a name in the header is empty or too long");
    if (is_sound()) skip(padded(length));
  }

  // Count of a list's elements; each takes at least 8 bytes.
  std::uint64_t take_list(Tag tag) {
    const std::uint64_t found = take_big_endian(4);
    const std::uint64_t count = take_count();
    const bool is_absent = found == static_cast<std::uint32_t>(Tag::absent) && count == 0;
    if (!is_absent && found != static_cast<std::uint32_t>(tag)) fail("a list in the header has another tag");
    if (count > remaining() / 8) fail("a list in the header is longer than the file");
    return is_sound() ? count : 0;
  }

  void walk_attributes() {
    for (std::uint64_t left = take_list(Tag::attribute); left > 0 && is_sound(); --left) {
      skip_name();
      const std::uint64_t size = type_size(take_big_endian(4));
      if (size == 0) fail("an attribute has an unknown type");
      const std::uint64_t count = take_count();
      if (is_sound()) skip(padded(product(count, size)));
    }
  }

  void walk_dimensions() {
    for (std::uint64_t left = take_list(Tag::dimension); left > 0 && is_sound(); --left) {
      skip_name();
      const std::uint64_t length = take_count();
      if (length == 0 && has_record_dimension_) fail("two dimensions are unlimited");
      has_record_dimension_ |= length == 0;
      lengths_.push_back(length);
    }
  }

  void walk_variables() {
    for (std::uint64_t left = take_list(Tag::variable); left > 0 && is_sound(); --left) {
      skip_name();
      const std::uint64_t dimension_count = take_count();
      if (dimension_count > most_dimensions) fail("a variable has too many dimensions");
      Variable variable{0, 1, false};
      for (std::uint64_t i = 0; i < dimension_count && is_sound(); ++i) {
        const std::uint64_t id = take_count();
        if (id >= lengths_.size()) return fail("a variable has a dimension that does not exist");
        const std::uint64_t length = lengths_[id];
        if (length == 0 && i > 0) return fail("a variable has its unlimited dimension in the wrong place");
        if (length == 0) {
          variable.has_records = true;
        } else {
          variable.size = product(variable.size, length);
        }
      }
      walk_attributes();
      const std::uint64_t size = type_size(take_big_endian(4));
      if (size == 0) fail("a variable has an unknown type");
      variable.size = product(variable.size, size);
      take_count();  // vsize, which libnetcdf computes anew
      variable.begin = take_offset();
      variables_.push_back(variable);
    }
  }

  void check_extents() {
    std::uint64_t record_size = 0;
    std::size_t record_variables = 0;
    for (const Variable& variable : variables_) {
      if (!variable.has_records) continue;
      record_size = sum(record_size, padded(variable.size));
      ++record_variables;
      if (record_variables == 1) only_record_size_ = variable.size;
    }
    // A single record variable is stored without padding.
    if (record_variables == 1) record_size = only_record_size_;
    for (const Variable& variable : variables_) {
      if (variable.has_records && record_count_ == 0) continue;
      const std::uint64_t before = variable.has_records ? product(record_count_ - 1, record_size) : 0;
      const std::uint64_t end = sum(variable.begin, sum(before, variable.size));
      if (variable.begin < at_ || end > bytes_.size()) {
        return fail("the values of a variable lie outside the file; it is cut short or damaged");
      }
    }
  }

  void walk() {
    at_ = 3;
    version_ = take_big_endian(1);
    if (version_ != 1 && version_ != 2 && version_ != 5) return fail("the version is not 1, 2 or 5");
    record_count_ = take_count();
    walk_dimensions();
    walk_attributes();
    walk_variables();
    if (is_sound()) check_extents();
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  std::uint64_t version_ = 0;
  std::uint64_t record_count_ = 0;
  std::uint64_t only_record_size_ = 0;
  bool has_record_dimension_ = false;
  std::vector<std::uint64_t> lengths_;
  std::vector<Variable> variables_;
  std::string fault_;
};

}  // namespace

std::string classic_header_fault(std::span<const std::byte> bytes) {
  const bool is_classic = bytes.size() >= 3 && bytes[0] == std::byte{'C'} && bytes[1] == std::byte{'D'} &&
                          bytes[2] == std::byte{'F'};
  return is_classic ? HeaderWalk(bytes).fault() : std::string();
}

}  // namespace offing::spectra
