#include "host/io/spectra/netcdf_variables.h"

#include <algorithm>
#include <utility>

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

std::vector<std::optional<NetcdfArray>> read_netcdf_arrays(std::span<const std::byte> bytes,
                                                           std::string_view file_name,
                                                           std::span<const std::string> names) {
  constexpr std::size_t most_numbers = std::size_t{1} << 22;
  const NetcdfFile file(bytes, file_name);
  std::vector<std::optional<NetcdfArray>> found;
  for (const std::string& name : names) {
    const std::optional<NetcdfVariable> variable = file.find({name});
    if (!variable) {
      found.emplace_back();
      continue;
    }
    NetcdfArray array{variable->dimensions, variable->lengths, {}, file.texts(*variable)};
    if (array.texts.empty()) {
      std::size_t count = 1;
      for (const std::size_t length : array.lengths) {
        if (length > most_numbers || (count *= length) > most_numbers) {
          file.fail(fmt::format("expected up to {} numbers in {}, got more", most_numbers, name),
                    damaged_hint);
        }
      }
      const std::vector<std::size_t> start(std::max<std::size_t>(array.lengths.size(), 1), 0);
      array.values = file.values(*variable, {start.data(), array.lengths.size()}, array.lengths);
    }
    found.emplace_back(std::move(array));
  }
  return found;
}

}  // namespace offing::spectra
