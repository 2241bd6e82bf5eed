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

Loaded load_beside(const std::filesystem::path& path, const char* extension, Trust trust) {
  std::filesystem::path file = path;
  file.replace_extension(extension);
  if (file != path) require_beside(path, file, trust);
  return {file.string(), read_whole_file(file, expectation)};
}

HydrodynamicFile read_wamit(const std::filesystem::path& path, const hydrodynamics::WamitUnits& units,
                            Trust trust) {
  const Loaded radiation = load_beside(path, ".1", trust), excitation = load_beside(path, ".3", trust);
  std::filesystem::path beside = path;
  std::error_code status;
  std::optional<Loaded> restoring;
  if (std::filesystem::exists(beside.replace_extension(".hst"), status))
    restoring = load_beside(path, ".hst", trust);
  return hydrodynamics::parse_wamit(radiation.view(), excitation.view(),
                                    restoring ? std::optional(restoring->view()) : std::nullopt, units);
}

HydrodynamicFile read(const std::filesystem::path& path, const hydrodynamics::WamitUnits& units,
                      Trust trust) {
  const std::string extension = lower_extension(path);
  if (extension == ".1" || extension == ".3" || extension == ".hst") return read_wamit(path, units, trust);
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
