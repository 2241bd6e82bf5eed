#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace offing::spectra {

/// One variable's place in an open NetCDF file.
struct NetcdfVariable {
  int id;
  std::string name;
  std::vector<std::string> dimensions;  ///< names, slowest first
  std::vector<std::size_t> lengths;

  /// Position of the first of these dimensions, or nothing.
  std::optional<std::size_t> axis(std::initializer_list<std::string_view> names) const;
};

/// An open NetCDF file held in memory; closes itself. All failures throw Error(bad_input) naming the file.
class NetcdfFile {
 public:
  NetcdfFile(std::span<const std::byte> bytes, std::string_view file_name);
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;
  ~NetcdfFile();

  /// The variable of the first of these names that exists.
  std::optional<NetcdfVariable> find(std::initializer_list<std::string_view> names) const;

  /// Text of an attribute of a variable, or of the file; empty if there is none or it is no text.
  std::string text_attribute(const NetcdfVariable& variable, const char* name) const;
  std::string global_attribute(const char* name) const;

  /// Values of a block of a variable, with scale_factor and add_offset applied; NaN where _FillValue or
  /// missing_value stands. start and count as the variable's dimensions.
  std::vector<double> values(const NetcdfVariable& variable, std::span<const std::size_t> start,
                             std::span<const std::size_t> count) const;

  /// All values of a variable of one dimension.
  std::vector<double> column(const NetcdfVariable& variable) const;

  /// Characters of a block of a text variable; empty if it is not of type char.
  std::string characters(const NetcdfVariable& variable, std::span<const std::size_t> start,
                         std::span<const std::size_t> count) const;

  /// All texts of a variable of strings, or of characters whose last dimension is the length of each; empty
  /// if it holds numbers.
  std::vector<std::string> texts(const NetcdfVariable& variable) const;

  /// Size of the file in bytes.
  std::size_t size() const { return size_; }

  /// The file's name, as errors show it.
  const std::string& name() const { return name_; }

  [[noreturn]] void fail(const std::string& what, const std::string& hint) const;

 private:
  std::string attribute_text(int variable_id, const char* name) const;
  std::optional<double> attribute_number(int variable_id, const char* name) const;
  void check(int status, std::string_view action) const;

  std::string name_;
  std::size_t size_;
  int id_ = -1;
};

}  // namespace offing::spectra
