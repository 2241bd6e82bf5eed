// Which rasters GDAL may open, and what they may lead to. GDAL alone would open, whatever a file's extension,
// descriptions of servers (WMS, WCS), of any bytes of any file and of programs (VRT).
#include "host/io/height_maps/raster_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <cpl_string.h>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/file_mark.h"
#include "host/io/file_trust.h"

namespace offing::height_maps {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 2> vrt_format{"VRT", nullptr}, tiff_format{"GTiff", nullptr};

bool is_of(const fs::path& path, const char* const* formats) {
  return GDALIdentifyDriverEx(path.c_str(), GDAL_OF_RASTER, formats, nullptr) != nullptr;
}

Dataset open_as(const fs::path& path, const char* const* formats, const char* const* options = nullptr) {
  return Dataset(GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, formats,
                            options, nullptr));
}

std::string lower(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

/// Masks, overviews and metadata of a raster, as GDAL finds them: in folders of up to 1000 files in letters
/// of any case.
std::vector<fs::path> sidecars_of(const fs::path& path) {
  std::vector<fs::path> found;
  std::error_code status;
  for (const char* const ending : {".msk", ".MSK", ".ovr", ".OVR", ".aux.xml"}) {
    const fs::path exact = path.string() + ending;
    if (fs::exists(exact, status)) found.push_back(exact);
  }
  const std::string own = lower(path.filename().string());
  fs::directory_iterator entry(path.parent_path(), status);
  for (int count = 0; !status && count <= 1000 && entry != fs::directory_iterator();
       ++count, entry.increment(status)) {
    const std::string name = lower(entry->path().filename().string());
    if (name == own + ".msk" || name == own + ".ovr" || name == own + ".aux.xml")
      found.push_back(entry->path());
  }
  return found;
}

/// GDAL would open masks and overviews as any format.
void check_beside(const fs::path& path, Trust trust) {
  for (const fs::path& beside : sidecars_of(path)) {
    require_beside(path, beside, trust);
    std::error_code status;
    const bool is_metadata = lower(beside.string()).ends_with(".xml");
    if (fs::is_regular_file(beside, status) && (is_metadata || is_of(beside, tiff_format.data()))) continue;
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a {}, because it lies beside {}, found something else",
                            one_line(beside.string()), is_metadata ? "file" : "GeoTIFF",
                            one_line(path.filename().string())),
                "move it to another folder");
  }
}

/// Of a raster that is open: the files that GDAL has read for it, and the one that it would open for
/// overviews.
void check_parts(GDALDatasetH raster, const fs::path& path, Trust trust) {
  if (const char* const overviews = GDALGetMetadataItem(raster, "OVERVIEW_FILE", "OVERVIEWS")) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a self-contained raster, found overviews in another file, {}",
                            one_line(path.string()), printable(overviews)),
                "make a copy without them: gdal_translate -co COPY_SRC_OVERVIEWS=NO MAP.tif COPY.tif");
  }
  if (trust == Trust::trusted) return;
  for (const fs::path& file : files_of_dataset(raster)) {
    // The content of a .hgt.zip.
    if (file.string().starts_with("/vsizip/" + path.string())) continue;
    require_beside(path, file, trust);
  }
}

bool is_of_driver(GDALDatasetH raster, std::string_view name) {
  return GDALGetDriverShortName(GDALGetDatasetDriver(raster)) == name;
}

bool is_of_integers(GDALDatasetH raster) {
  return GDALGetRasterCount(raster) == 1 && GDALGetRasterDataType(GDALGetRasterBand(raster, 1)) == GDT_Int32;
}

/// GDAL reads a block of all bands at once where they lie pixel by pixel: a file of 300 bytes can ask for 4
/// GB.
void require_readable_blocks(GDALDatasetH raster, const fs::path& path) {
  constexpr double most_bytes = 1 << 30;
  const int bands = GDALGetRasterCount(raster);
  if (bands < 2) return;  // GDAL itself refuses blocks of one band above 2 GB
  const GDALRasterBandH band = GDALGetRasterBand(raster, 1);
  int columns = 0, rows = 0;
  GDALGetBlockSize(band, &columns, &rows);
  const double bytes = 1.0 * columns * rows * bands * GDALGetDataTypeSizeBytes(GDALGetRasterDataType(band));
  if (bytes <= most_bytes) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected blocks of at most 1 GB, found {} x {} pixels of {} bands: {:.1f} GB",
                          one_line(path.string()), columns, rows, bands, bytes / most_bytes),
              "keep one band: gdal_translate -b 1 MAP.tif NEW.tif");
}

/// GDAL reads an ASCII grid in which it finds no decimal point as integers: "nan" and "inf" would be 0.
enum class IntegerGrids {
  as_real,     ///< read as real numbers
  of_integers  ///< refused if they hold anything else: GDAL itself opens the sources of a VRT
};

Dataset open_plain(const fs::path& path, const FileTrust& trust, IntegerGrids integer_grids) {
  if ((trust.trust == Trust::untrusted || trust.is_named_by_scene) && is_hdf5_file(path)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a self-contained raster, found HDF5 (NetCDF-4), which can name "
                            "other files as its data",
                            one_line(path.string())),
                "convert it to a GeoTIFF: gdal_translate MAP.nc MAP.tif");
  }
  check_beside(path, trust.trust);
  Dataset raster = open_as(path, plain_formats());
  if (!raster) return raster;
  require_readable_blocks(raster.get(), path);
  if (integer_grids == IntegerGrids::as_real && is_of_driver(raster.get(), "AAIGrid") &&
      is_of_integers(raster.get())) {
    constexpr std::array<const char*, 2> as_real{"DATATYPE=Float64", nullptr};
    raster.reset();
    raster = open_as(path, plain_formats(), as_real.data());
    if (!raster) return raster;
  }
  check_parts(raster.get(), path, trust.trust);
  if (is_of_driver(raster.get(), "AAIGrid") || is_of_driver(raster.get(), "GRASSASCIIGrid")) {
    check_ascii_grid(path,
                     static_cast<std::size_t>(GDALGetRasterXSize(raster.get())) *
                         static_cast<std::size_t>(GDALGetRasterYSize(raster.get())),
                     is_of_integers(raster.get()) ? AsciiNumbers::integers : AsciiNumbers::real);
  }
  return raster;
}

[[noreturn]] void refuse_part(const fs::path& path, const GdalSession& session) {
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected a raster, found a file that cannot be opened as one: {}",
                          one_line(path.string()), session.failure()),
              "leave it out, or copy it again");
}

}  // namespace

std::vector<fs::path> files_of_dataset(GDALDatasetH raster) {
  const std::unique_ptr<char*, void (*)(char**)> names(GDALGetFileList(raster), CSLDestroy);
  std::vector<fs::path> files;
  for (char** name = names.get(); name != nullptr && *name != nullptr; ++name) files.emplace_back(*name);
  return files;
}

bool is_plain_raster(const fs::path& path) {
  return is_of(path, plain_formats());
}

int check_raster(const fs::path& path, Trust trust, CheckedRasters& checked, int depth) {
  const GdalSession session;
  if (is_of(path, vrt_format.data())) {
    check_beside(path, trust);
    return check_vrt(path, trust, checked, depth);
  }
  if (!open_plain(path, {.trust = trust}, IntegerGrids::of_integers)) refuse_part(path, session);
  return 0;
}

bool is_real_grid(const fs::path& path, Trust trust) {
  const GdalSession session;
  const Dataset raster = open_plain(path, {.trust = trust}, IntegerGrids::as_real);
  if (!raster) refuse_part(path, session);
  return is_of_driver(raster.get(), "AAIGrid") &&
         GDALGetRasterDataType(GDALGetRasterBand(raster.get(), 1)) == GDT_Float64;
}

Dataset open_raster(const fs::path& path, const FileTrust& trust) {
  if (path.string().starts_with(own_memory)) return open_as(path, vrt_format.data());
  // No part of an absolute path is taken for the name of a format.
  const fs::path file = fs::absolute(path);
  if (!is_of(file, vrt_format.data())) return open_plain(file, trust, IntegerGrids::as_real);
  if (trust.is_named_by_scene) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a self-contained raster, found a VRT, which a scene may not name",
                            one_line(path.string())),
                "convert it to a GeoTIFF: gdal_translate MAP.vrt MAP.tif");
  }
  // GDAL, too, takes sources to be relative to where links lead.
  const fs::path real = fs::canonical(file);
  CheckedRasters checked;
  check_raster(real, trust.trust, checked);
  return open_as(real, vrt_format.data());
}

}  // namespace offing::height_maps
