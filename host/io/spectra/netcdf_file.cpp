#include "host/io/spectra/netcdf_file.h"

#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include "host/base/error.h"
#include "host/io/spectra/netcdf_classic_header.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::spectra {
namespace {

constexpr const char* damaged_hint = "the file is damaged or cut short; fetch or write it again";

// One block of values stays below this; a header that asks for more is damaged.
constexpr std::size_t most_values = std::size_t{1} << 27;

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
      fail(fmt::format("{} holds more than {} values a spectrum", variable.name, most_values), damaged_hint);
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
