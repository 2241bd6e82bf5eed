#include "host/io/hydrodynamics/read_hydrodynamics.h"

#include <new>
#include <optional>
#include <span>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/file_extension.h"
#include "host/io/file_mark.h"
#include "host/io/hydrodynamics/capytaine_file.h"
#include "host/io/module.h"
#include "host/io/spectra/netcdf_module.h"
#include "host/io/spectra/text_cursor.h"
#include "host/io/whole_file.h"

namespace offing {
namespace {

using hydrodynamics::HydrodynamicFile;
using hydrodynamics::WamitText;

constexpr FileExpectation expectation{.kind = "a file of hydrodynamic data",
                                      .most_bytes = std::size_t{1} << 28,
                                      .hint_of_size = "leave out directions or frequencies"};

/// A file of WAMIT, and its name.
struct Loaded {
  std::string name, text;

  WamitText view() const { return {text, name}; }
};

bool is_wamit(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".1" || extension == ".3" || extension == ".hst";
}

HydrodynamicFile read_wamit(const std::filesystem::path& path, const hydrodynamics::WamitUnits& units,
                            Trust trust) {
  std::vector<Loaded> files;
  for (const std::filesystem::path& file : hydrodynamic_files(path)) {
    if (file != path) require_beside(path, file, trust);
    files.push_back({file.string(), read_whole_file(file, expectation)});
  }
  return hydrodynamics::parse_wamit(files[0].view(), files[1].view(),
                                    files.size() > 2 ? std::optional(files[2].view()) : std::nullopt, units);
}

HydrodynamicFile read(const std::filesystem::path& path, const hydrodynamics::WamitUnits& units,
                      Trust trust) {
  if (is_wamit(path)) return read_wamit(path, units, trust);
  const std::string name = path.string(), bytes = read_whole_file(path, expectation);
  if (is_hdf5(bytes) && trust == Trust::untrusted) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a self-contained file, got HDF5 (NetCDF-4), which can name other "
                            "files as its data",
                            spectra::printable_name(name)),
                "convert it with nccopy -k cdf5, or leave out --untrusted if you trust the author");
  }
  if (is_hdf5(bytes) || bytes.starts_with("CDF")) {
    return hydrodynamics::parse_capytaine(
        std::as_bytes(std::span(bytes)), name,
        module_functions<spectra::NetcdfModule>("netcdf", "read NetCDF").read_arrays);
  }
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected a file of hydrodynamic data, got {}", spectra::printable_name(name),
                          bytes.empty() ? "an empty file" : "a file of unknown format"),
              "give the NetCDF file of Capytaine (.nc), or numeric output of WAMIT (.1, .3, .hst)");
}

}  // namespace

std::vector<std::filesystem::path> hydrodynamic_files(const std::filesystem::path& path) {
  if (!is_wamit(path)) return {path};
  std::vector<std::filesystem::path> files;
  for (const char* extension : {".1", ".3", ".hst"}) {
    files.push_back(path);
    files.back().replace_extension(extension);
  }
  std::error_code status;
  if (!std::filesystem::exists(files.back(), status)) files.pop_back();
  return files;
}

HydrodynamicFile read_hydrodynamics(const std::filesystem::path& path, const hydrodynamics::WamitUnits& units,
                                    Trust trust) {
  try {
    return read(path, units, trust);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::out_of_memory,
                fmt::format("{}: not enough memory for its data", spectra::printable_name(path.string())),
                "leave out directions or frequencies");
  }
}

}  // namespace offing
