#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace offing::spectra {

/// What a new NetCDF file holds.
struct NetcdfLayout {
  /// An attribute.
  struct Text {
    std::string name, value;
  };
  /// An axis of variables.
  struct Dimension {
    std::string name;
    std::size_t length =
        0;  ///< 0: grows as values are put; at most one, the first of each variable that has it
  };
  /// Of the values of a variable.
  enum class Type { int32, float32, float64 };
  /// An array with its axes.
  struct Variable {
    std::string name;
    Type type = Type::float64;
    std::vector<std::size_t> dimensions = {};  ///< indices, slowest first
    std::vector<Text> attributes = {};
  };

  std::vector<Dimension> dimensions;
  std::vector<Variable> variables;
  std::vector<Text> attributes;
};

/// A NetCDF file that is being written, in the classic format with 64-bit offsets, which every reader knows.
class NetcdfOutput {
 public:
  virtual ~NetcdfOutput() = default;

  /// Writes a block of the variable with this index of the layout; start and count as its dimensions.
  virtual void put(std::size_t variable, std::span<const std::size_t> start,
                   std::span<const std::size_t> count, std::span<const double> values) = 0;
  /// Call last; without it the file is not whole.
  virtual void close() = 0;
};

/// Creates or empties `path`. Failures, later ones too, throw Error(file) that names `target`.
std::unique_ptr<NetcdfOutput> create_netcdf(const std::filesystem::path& path, const NetcdfLayout& layout,
                                            const std::string& target);

}  // namespace offing::spectra
