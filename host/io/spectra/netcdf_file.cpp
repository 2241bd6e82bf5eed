#include "host/io/spectra/netcdf_file.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include "host/base/error.h"
#include "host/io/spectra/text_cursor.h"

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

/// Walks the header of a classic NetCDF file (CDF-1, CDF-2, CDF-5) and says what is wrong with it: lengths
/// and offsets that do not fit the file's size, dimensions that do not exist. Empty if it is sound, and for
/// everything that does not start with "CDF". libnetcdf trusts these lengths: a damaged one makes it allocate
/// or read beyond bounds, so nothing unsound reaches it. Source: NetCDF classic format specification
/// (Unidata), the grammar in BNF.
std::string classic_header_fault(std::span<const std::byte> bytes) {
  const bool is_classic = bytes.size() >= 3 && bytes[0] == std::byte{'C'} && bytes[1] == std::byte{'D'} &&
                          bytes[2] == std::byte{'F'};
  return is_classic ? HeaderWalk(bytes).fault() : std::string();
}

// One block of values stays below this; a header that asks for more is damaged.
constexpr std::size_t most_values = std::size_t{1} << 27;
constexpr std::size_t most_texts = 4096;

}  // namespace

std::optional<std::size_t> NetcdfVariable::axis(std::initializer_list<std::string_view> names) const {
  for (const std::string_view wanted : names) {
    for (std::size_t i = 0; i < dimensions.size(); ++i) {
      if (dimensions[i] == wanted) return i;
    }
  }
  return std::nullopt;
}

NetcdfFile::NetcdfFile(std::span<const std::byte> bytes, std::string_view file_name)
    : name_(printable_name(file_name)), size_(bytes.size()) {
  if (const std::string fault = classic_header_fault(bytes); !fault.empty()) {
    fail("expected a NetCDF file, but " + fault, damaged_hint);
  }
  // The library takes a pointer to non-const but only reads without NC_WRITE; opening from memory also keeps
  // it from taking a file's name for an address on the network.
  void* memory = const_cast<std::byte*>(bytes.data());
  check(nc_open_mem("spectra", NC_NOWRITE, bytes.size(), memory, &id_), "opening");
}

NetcdfFile::~NetcdfFile() {
  nc_close(id_);
}

void NetcdfFile::fail(const std::string& what, const std::string& hint) const {
  throw Error(ErrorKind::bad_input, fmt::format("{}: {}", name_, what), hint);
}

void NetcdfFile::check(int status, std::string_view action) const {
  if (status == NC_NOERR) return;
  fail(fmt::format("expected a NetCDF file, but {} it failed: {}", action, nc_strerror(status)),
       damaged_hint);
}

std::optional<NetcdfVariable> NetcdfFile::find(std::initializer_list<std::string_view> names) const {
  for (const std::string_view name : names) {
    NetcdfVariable variable{0, std::string(name), {}, {}};
    if (nc_inq_varid(id_, variable.name.c_str(), &variable.id) != NC_NOERR) continue;
    int count = 0;
    check(nc_inq_varndims(id_, variable.id, &count), "reading");
    std::vector<int> ids(static_cast<std::size_t>(count));
    check(nc_inq_vardimid(id_, variable.id, ids.data()), "reading");
    for (const int dimension : ids) {
      std::array<char, NC_MAX_NAME + 1> text{};
      std::size_t length = 0;
      check(nc_inq_dim(id_, dimension, text.data(), &length), "reading");
      variable.dimensions.emplace_back(text.data());
      variable.lengths.push_back(length);
    }
    return variable;
  }
  return std::nullopt;
}

std::string NetcdfFile::attribute_text(int variable_id, const char* name) const {
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(id_, variable_id, name, &type, &length) != NC_NOERR || length == 0) return {};
  if (type == NC_STRING && length == 1) {
    char* text = nullptr;
    check(nc_get_att_string(id_, variable_id, name, &text), "reading");
    std::string copy = text ? text : "";
    nc_free_string(1, &text);
    return copy;
  }
  if (type != NC_CHAR || length > size_) return {};
  std::string text(length, '\0');
  check(nc_get_att_text(id_, variable_id, name, text.data()), "reading");
  while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.pop_back();
  return text;
}

std::optional<double> NetcdfFile::attribute_number(int variable_id, const char* name) const {
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(id_, variable_id, name, &type, &length) != NC_NOERR) return std::nullopt;
  if (length != 1 || type == NC_CHAR || type >= NC_STRING) return std::nullopt;
  double value = 0.0;
  check(nc_get_att_double(id_, variable_id, name, &value), "reading");
  return value;
}

std::string NetcdfFile::text_attribute(const NetcdfVariable& variable, const char* name) const {
  return attribute_text(variable.id, name);
}

std::string NetcdfFile::global_attribute(const char* name) const {
  return attribute_text(NC_GLOBAL, name);
}

std::vector<double> NetcdfFile::values(const NetcdfVariable& variable, std::span<const std::size_t> start,
                                       std::span<const std::size_t> count) const {
  nc_type type = NC_NAT;
  check(nc_inq_vartype(id_, variable.id, &type), "reading");
  if (type == NC_CHAR || type >= NC_STRING) {
    fail(fmt::format("expected numbers in {}, got another type", variable.name), damaged_hint);
  }
  std::size_t total = 1;
  for (const std::size_t length : count) {
    if (length != 0 && total > most_values / length) {
      fail(fmt::format("{} holds more than {} values per spectrum", variable.name, most_values),
           damaged_hint);
    }
    total *= length;
  }
  std::vector<double> values(total);
  check(nc_get_vara_double(id_, variable.id, start.data(), count.data(), values.data()), "reading");

  const double scale = attribute_number(variable.id, "scale_factor").value_or(1.0);
  const double offset = attribute_number(variable.id, "add_offset").value_or(0.0);
  std::optional<double> fill = attribute_number(variable.id, "_FillValue");
  const std::optional<double> missing = attribute_number(variable.id, "missing_value");
  // Without the attribute, unwritten floats hold the library's own mark.
  if (!fill && type == NC_FLOAT) fill = double{NC_FILL_FLOAT};
  if (!fill && type == NC_DOUBLE) fill = NC_FILL_DOUBLE;
  for (double& value : values) {
    const bool is_missing = value == fill || value == missing;
    value = is_missing ? std::numeric_limits<double>::quiet_NaN() : value * scale + offset;
  }
  return values;
}

std::vector<double> NetcdfFile::column(const NetcdfVariable& variable) const {
  if (variable.lengths.size() != 1) {
    fail(fmt::format("expected one dimension in {}, got {}", variable.name, variable.lengths.size()),
         damaged_hint);
  }
  const std::size_t start = 0;
  return values(variable, {&start, 1}, variable.lengths);
}

std::vector<std::string> NetcdfFile::texts(const NetcdfVariable& variable) const {
  nc_type type = NC_NAT;
  check(nc_inq_vartype(id_, variable.id, &type), "reading");
  const bool is_rows = type == NC_CHAR && !variable.lengths.empty();
  if (!is_rows && type != NC_STRING) return {};
  std::size_t count = 1;
  for (std::size_t i = 0; i + (is_rows ? 1 : 0) < variable.lengths.size(); ++i) {
    if (variable.lengths[i] > most_texts || (count *= variable.lengths[i]) > most_texts) {
      fail(fmt::format("{} holds more than {} texts", variable.name, most_texts), damaged_hint);
    }
  }
  std::vector<std::string> texts;
  if (is_rows) {
    std::vector<std::size_t> start(variable.lengths.size(), 0), one(variable.lengths.size(), 1);
    one.back() = variable.lengths.back();
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t rest = i;
      for (std::size_t axis = start.size() - 1; axis-- > 0; rest /= variable.lengths[axis])
        start[axis] = rest % variable.lengths[axis];
      texts.push_back(characters(variable, start, one));
    }
    return texts;
  }
  if (count == 0) return texts;
  std::vector<char*> raw(count, nullptr);
  check(nc_get_var_string(id_, variable.id, raw.data()), "reading");
  for (const char* text : raw) texts.emplace_back(text == nullptr ? "" : text);
  nc_free_string(count, raw.data());
  return texts;
}

std::string NetcdfFile::characters(const NetcdfVariable& variable, std::span<const std::size_t> start,
                                   std::span<const std::size_t> count) const {
  nc_type type = NC_NAT;
  check(nc_inq_vartype(id_, variable.id, &type), "reading");
  std::size_t total = 1;
  for (const std::size_t length : count) {
    if (length != 0 && total > NC_MAX_NAME / length) return {};
    total *= length;
  }
  if (type != NC_CHAR) return {};
  std::string text(total, '\0');
  check(nc_get_vara_text(id_, variable.id, start.data(), count.data(), text.data()), "reading");
  text.resize(text.find('\0') == std::string::npos ? text.size() : text.find('\0'));
  const std::size_t end = text.find_last_not_of(' ');
  text.resize(end == std::string::npos ? 0 : end + 1);
  return text;
}

}  // namespace offing::spectra
