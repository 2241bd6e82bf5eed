#include "host/io/spectra/read_spectra.h"

#include <algorithm>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/io/file_mark.h"
#include "host/io/module.h"
#include "host/io/spectra/datawell_spectra.h"
#include "host/io/spectra/gzip.h"
#include "host/io/spectra/ndbc_spectra.h"
#include "host/io/spectra/netcdf_module.h"
#include "host/io/spectra/octopus_spectra.h"
#include "host/io/spectra/spotter_spectra.h"
#include "host/io/spectra/swan_spectra.h"
#include "host/io/spectra/text_cursor.h"
#include "host/io/spectra/triaxys_spectra.h"
#include "host/io/spectra/ww3_spectra.h"
#include "host/io/whole_file.h"

namespace offing {
namespace {

using spectra::NamedText;

struct LoadedFile {
  std::string name;
  std::string bytes;

  NamedText text() const { return {bytes, name}; }
};

/// Unpacked if it is compressed.
LoadedFile load(const std::filesystem::path& path) {
  // A year of a buoy has 20 MB.
  constexpr std::size_t most_unpacked_bytes = std::size_t{1} << 28;
  LoadedFile file{path.string(),
                  read_whole_file(path, {.kind = "a wave spectrum file",
                                         .most_bytes = std::size_t{1} << 30,
                                         .hint_of_size = "cut the file into months, or extract "
                                                         "the records that you need"})};
  if (spectra::is_gzip(file.bytes)) {
    file.bytes = spectra::unpack_gzip(file.bytes, file.name, most_unpacked_bytes);
  }
  return file;
}

/// A companion of `main`, or the same compressed.
std::optional<LoadedFile> load_if_there(const std::filesystem::path& main, const std::filesystem::path& path,
                                        Trust trust) {
  std::filesystem::path packed = path;
  packed += ".gz";
  std::error_code status;
  for (const std::filesystem::path& file : {path, packed}) {
    if (!std::filesystem::exists(file, status)) continue;
    require_beside(main, file, trust);
    return load(file);
  }
  return std::nullopt;
}

std::vector<WaveSpectrum> read_ndbc(const LoadedFile& main, const std::filesystem::path& path, Trust trust) {
  const auto paths = spectra::ndbc_companion_paths(path);
  if (!paths) return spectra::parse_ndbc(main.bytes, main.name);
  const std::optional<LoadedFile> alpha1 = load_if_there(path, paths->alpha1, trust);
  const std::optional<LoadedFile> alpha2 = load_if_there(path, paths->alpha2, trust);
  const std::optional<LoadedFile> r1 = load_if_there(path, paths->r1, trust);
  const std::optional<LoadedFile> r2 = load_if_there(path, paths->r2, trust);
  const bool has_any = alpha1 || alpha2 || r1 || r2;
  if (has_any && !(alpha1 && alpha2 && r1 && r2)) {
    spdlog::warn("{}: of the four directional files {} {} {} {} not all are there: {}",
                 spectra::printable_name(main.name), paths->alpha1.filename().string(),
                 paths->alpha2.filename().string(), paths->r1.filename().string(),
                 paths->r2.filename().string(),
                 alpha1 && r1 ? "spreading is made from the mean direction and r1 alone"
                              : "the spectra are read without directions");
  }
  const auto text = [](const std::optional<LoadedFile>& file) {
    return file ? std::optional(file->text()) : std::nullopt;
  };
  return spectra::parse_ndbc(main.bytes, main.name, {text(alpha1), text(alpha2), text(r1), text(r2)});
}

std::string_view first_filled_line(std::string_view text, std::string_view name) {
  spectra::TextCursor cursor(text, name);
  cursor.next_filled_line();
  return cursor.line();
}

// "#YY MM DD" and older headers without the mark. Other files may begin with a # too.
bool is_ndbc(std::string_view first_line) {
  std::string_view rest =
      first_line.substr(std::min(first_line.find_first_not_of("# \t"), first_line.size()));
  const std::string_view word = spectra::take_word(rest);
  return word == "YY" || word == "YYYY";
}

// A Datawell file has no mark but its name, or twelve lines of a single number.
bool is_datawell(const LoadedFile& file, const std::filesystem::path& path) {
  if (path.extension() == ".spt" || path.extension() == ".SPT") return true;
  spectra::TextCursor cursor(file.bytes, file.name);
  for (int line = 0; line < 12; ++line) {
    if (!cursor.next_filled_line() || !spectra::take_number(cursor.rest()) ||
        !spectra::is_blank(cursor.rest()))
      return false;
  }
  return true;
}

std::vector<WaveSpectrum> parse(const LoadedFile& file, const std::filesystem::path& path, Trust trust) {
  if (is_hdf5(file.bytes) && trust == Trust::untrusted) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a self-contained file, got HDF5 (NetCDF-4), which can name other "
                            "files as its data",
                            spectra::printable_name(file.name)),
                "convert it with nccopy -k cdf5, or leave out --untrusted if you trust the author");
  }
  if (is_hdf5(file.bytes) || file.bytes.starts_with("CDF"))
    return module_functions<spectra::NetcdfModule>("netcdf", "read NetCDF spectra")
        .parse_netcdf(std::as_bytes(std::span(file.bytes)), file.name);
  const std::string_view line = first_filled_line(file.bytes, file.name);
  std::string_view rest = line;
  const std::string_view word = spectra::take_word(rest);
  if (line.find("WAVEWATCH III SPECTRA") != std::string_view::npos)
    return spectra::parse_ww3(file.bytes, file.name);
  if (word == "SWAN") return spectra::parse_swan(file.bytes, file.name);
  if (line.find("TRIAXYS BUOY") != std::string_view::npos)
    return spectra::parse_triaxys(file.bytes, file.name);
  if (line.starts_with("Forecast valid for")) return spectra::parse_octopus(file.bytes, file.name);
  if (spectra::is_spotter(line)) return spectra::parse_spotter(file.bytes, file.name);
  if (is_ndbc(line)) return read_ndbc(file, path, trust);
  if (is_datawell(file, path)) return spectra::parse_datawell(file.bytes, file.name);
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected a wave spectrum file, got {}", spectra::printable_name(file.name),
                          file.bytes.empty() ? "an empty file" : "a file of unknown format"),
              "give NDBC .data_spec or historical text, WAVEWATCH III or SWAN text or NetCDF, "
              "wavespectra NetCDF, Datawell .spt, TRIAXYS, Octopus, or Spotter CSV or JSON");
}

}  // namespace

std::vector<WaveSpectrum> read_spectra(const std::filesystem::path& path, Trust trust) {
  try {
    return parse(load(path), spectra::unpacked_name(path), trust);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::out_of_memory,
                fmt::format("{}: not enough memory for its spectra", spectra::printable_name(path.string())),
                "extract the records that you need into a smaller file");
  }
}

}  // namespace offing
