#include "tests/io/spectra/netcdf_writer.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include <netcdf.h>

#include "tests/io/spectra/spectrum_checks.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

void check(int status) {
  if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
}

void put_attributes(int file, int variable, const std::vector<TestAttribute>& attributes) {
  for (const TestAttribute& attribute : attributes) {
    if (!attribute.text.empty()) {
      check(nc_put_att_text(file, variable, attribute.name.c_str(), attribute.text.size(),
                            attribute.text.data()));
    } else if (attribute.name == "_FillValue" && variable != NC_GLOBAL) {
      nc_type type = NC_NAT;
      check(nc_inq_vartype(file, variable, &type));
      check(nc_put_att_double(file, variable, "_FillValue", type, 1, &attribute.number));
    } else {
      check(nc_put_att_double(file, variable, attribute.name.c_str(), NC_DOUBLE, 1, &attribute.number));
    }
  }
}

}  // namespace

TestVariable& TestNetcdf::variable(const std::string& name) {
  const auto found =
      std::find_if(variables.begin(), variables.end(), [&](const TestVariable& v) { return v.name == name; });
  if (found == variables.end()) throw std::runtime_error("no variable " + name);
  return *found;
}

std::string netcdf_bytes(const TestNetcdf& file, NetcdfFormat format) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "spectra.nc";
  int id = 0;
  check(nc_create(path.c_str(), NC_CLOBBER | (format == NetcdfFormat::hdf5 ? NC_NETCDF4 : 0), &id));
  std::map<std::string, int> dimension_ids;
  for (const TestDimension& dimension : file.dimensions) {
    check(nc_def_dim(id, dimension.name.c_str(), dimension.length, &dimension_ids[dimension.name]));
  }
  std::vector<int> ids;
  for (const TestVariable& variable : file.variables) {
    std::vector<int> dimensions;
    for (const std::string& name : variable.dimensions) dimensions.push_back(dimension_ids.at(name));
    const nc_type type = !variable.text.empty() ? NC_CHAR : variable.is_packed ? NC_SHORT : NC_DOUBLE;
    check(nc_def_var(id, variable.name.c_str(), type, static_cast<int>(dimensions.size()), dimensions.data(),
                     &ids.emplace_back()));
    put_attributes(id, ids.back(), variable.attributes);
  }
  put_attributes(id, NC_GLOBAL, file.attributes);
  check(nc_enddef(id));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const TestVariable& variable = file.variables[i];
    if (!variable.text.empty()) {
      check(nc_put_var_text(id, ids[i], variable.text.data()));
    } else if (!variable.values.empty()) {
      check(nc_put_var_double(id, ids[i], variable.values.data()));
    }
  }
  check(nc_close(id));
  return read_text(path);
}

}  // namespace offing::test
