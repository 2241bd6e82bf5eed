#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace offing::test {

/// A dimension of a NetCDF file.
struct TestDimension {
  std::string name;
  std::size_t length;
};

/// A text attribute, or a number if `text` is empty.
struct TestAttribute {
  std::string name;
  std::string text = {};
  double number = 0.0;
};

/// A variable over dimensions of the file, by name; characters if `text` is not empty, else doubles, or
/// shorts if is_packed.
struct TestVariable {
  std::string name;
  std::vector<std::string> dimensions;
  std::vector<TestAttribute> attributes = {};
  std::vector<double> values = {};
  std::string text = {};
  bool is_packed = false;
};

struct TestNetcdf {
  std::vector<TestDimension> dimensions;
  std::vector<TestVariable> variables;
  std::vector<TestAttribute> attributes = {};

  TestVariable& variable(const std::string& name);
};

/// The format of the file: classic (CDF-1) or NetCDF-4 (HDF5).
enum class NetcdfFormat { classic, hdf5 };

/// The bytes of that file.
std::string netcdf_bytes(const TestNetcdf& file, NetcdfFormat format = NetcdfFormat::classic);

}  // namespace offing::test
