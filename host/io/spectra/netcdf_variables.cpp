#include "host/io/spectra/netcdf_variables.h"

#include <fmt/format.h>

#include "host/io/spectra/netcdf_file.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::spectra {

std::vector<std::optional<std::vector<double>>> read_netcdf_variables(std::span<const std::byte> bytes,
                                                                      std::string_view file_name,
                                                                      std::span<const std::string> names) {
  const NetcdfFile file(bytes, file_name);
  std::vector<std::optional<std::vector<double>>> found;
  for (const std::string& name : names) {
    const std::optional<NetcdfVariable> variable = file.find({name});
    if (variable && variable->lengths.size() > 1) {
      file.fail(fmt::format("expected one dimension or none in {}, got {}", name, variable->lengths.size()),
                damaged_hint);
    }
    const std::size_t start = 0;
    found.push_back(variable ? std::optional(file.values(*variable, {&start, variable->lengths.size()},
                                                         variable->lengths))
                             : std::nullopt);
  }
  return found;
}

}  // namespace offing::spectra
