#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/height_maps/gdal_session.h"
#include "host/io/height_maps/height_map_options.h"
#include "host/io/height_maps/raster_file.h"
#include "host/io/height_maps/source_heights.h"

namespace offing::height_maps {
namespace {

/// Height in m that three bytes stand for; none for black, which both encodings leave to places without data
/// (-10000 m and -32768 m). `encoding` is mapbox or terrarium.
/// Sources: Mapbox, "Access elevation data" (Terrain-RGB); Tilezen Joerd, docs/formats.md (terrarium).
std::optional<double> height_of_rgb(HeightEncoding encoding, std::uint8_t red, std::uint8_t green,
                                    std::uint8_t blue) {
  const int code = 65536 * red + 256 * green + blue;
  if (code == 0) {
    return std::nullopt;
  }
  return encoding == HeightEncoding::mapbox ? -10000.0 + 0.1 * code : code / 256.0 - 32768.0;
}

bool is_srtm_name(const std::filesystem::path& path) {
  const std::string name = path.string();
  return name.ends_with(".hgt") || name.ends_with(".hgt.zip");
}

/// An open raster, for the time of one reading.
class Raster {
 public:
  Raster(const std::filesystem::path& path, const FileTrust& trust)
      : path_(path), dataset_(open_raster(path, trust)) {
    if (!dataset_) {
      throw Error(
          ErrorKind::bad_input,
          fmt::format("{}: expected a height map, found a file that cannot be opened as one: {}",
                      path.string(), session_.failure()),
          is_srtm_name(path)
              ? "an .hgt has 1201 x 1201 or 3601 x 3601 posts and is named after its south-west corner, such "
                "as N42E001.hgt: rename it, or copy it again if it is cut short"
              : "give a GeoTIFF, HGT, DEM, ASCII grid, PNG or EXR; a file without a header needs the ending "
                ".r16, .r32, .raw or .bin; a file that is cut short must be copied again");
    }
    cache_.emplace(handle());
  }

  GDALDatasetH handle() const { return dataset_.get(); }
  int columns() const { return GDALGetRasterXSize(handle()); }
  int rows() const { return GDALGetRasterYSize(handle()); }
  int bands() const { return GDALGetRasterCount(handle()); }
  GDALRasterBandH band(int number) const { return GDALGetRasterBand(handle(), number); }
  const std::filesystem::path& path() const { return path_; }

  /// Rows first ... first + count of a band, as `type`.
  template <typename Sample>
  void read(GDALRasterBandH band, int first, int count, GDALDataType type,
            std::vector<Sample>& samples) const {
    samples.resize(static_cast<std::size_t>(count) * static_cast<std::size_t>(columns()));
    if (GDALRasterIO(band, GF_Read, 0, first, columns(), count, samples.data(), columns(), count, type, 0,
                     0) != CE_None) {
      throw Error(
          ErrorKind::bad_input,
          fmt::format("{}: expected {} rows of heights, found none that can be read from row {} on: {}",
                      path_.string(), rows(), first, session_.failure()),
          "the file is cut short or damaged: copy or download it again");
    }
  }

 private:
  std::filesystem::path path_;
  GdalSession session_;
  Dataset dataset_;
  std::optional<CacheBound> cache_;
};

/// Calls read(first, count) for all rows, so many at once that GDAL works on whole blocks and memory stays
/// small.
template <typename ReadRows>
void for_each_row_block(const Raster& raster, ReadRows read) {
  constexpr int samples_at_once = 1 << 21;
  const int rows_at_once = std::clamp(samples_at_once / raster.columns(), 1, 512);
  for (int first = 0; first < raster.rows(); first += rows_at_once) {
    read(first, std::min(rows_at_once, raster.rows() - first));
  }
}

/// A header may promise data that no block of the file holds.
void check_has_data(const Raster& raster, GDALRasterBandH band) {
  const int status = GDALGetDataCoverageStatus(band, 0, 0, raster.columns(), raster.rows(),
                                               GDAL_DATA_COVERAGE_STATUS_DATA, nullptr);
  constexpr int unknown = GDAL_DATA_COVERAGE_STATUS_UNIMPLEMENTED | GDAL_DATA_COVERAGE_STATUS_DATA;
  if ((status & unknown) == 0) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: a header for {}x{} posts, expected heights, found none",
                            raster.path().string(), raster.columns(), raster.rows()),
                "the file was never filled: make or download it again");
  }
}

/// Metres in the unit of height that a band names; 1 for metres, and where it names none.
double metres_of_unit(const Raster& raster, GDALRasterBandH band) {
  constexpr double us_survey_foot_m = 1200.0 / 3937.0;
  const std::string unit = GDALGetRasterUnitType(band);
  if (unit.empty() || unit == "m" || unit == "metre" || unit == "meter" || unit == "metres" ||
      unit == "meters") {
    return 1.0;
  }
  if (unit == "ft" || unit == "foot" || unit == "feet" || unit == "FOOT") {
    return 0.3048;
  }
  if (unit == "sfoot" || unit == "us-ft" || unit == "US survey foot" || unit == "ftUS") {
    return us_survey_foot_m;
  }
  if (unit == "cm" || unit == "dm" || unit == "km") {
    return unit == "cm" ? 0.01 : unit == "dm" ? 0.1 : 1000.0;
  }
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: heights in \"{}\", expected metres or feet", raster.path().string(), unit),
              "convert them, as with gdal_translate -scale, or remove the unit with gdal_edit.py -units m");
}

void read_rgb(const Raster& raster, HeightEncoding encoding, const HeightScale& scale,
              SourceHeights& source) {
  for (int number = 1; number <= 3; ++number) {
    if (raster.bands() < 3 || GDALGetRasterDataType(raster.band(number)) != GDT_Byte) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: expected red, green and blue of 8 bits each, found {} band{} of {}",
                              raster.path().string(), raster.bands(), raster.bands() == 1 ? "" : "s",
                              GDALGetDataTypeName(GDALGetRasterDataType(raster.band(1)))),
                  "drop --encoding if the file holds plain heights; expand a palette with gdal_translate "
                  "-expand rgb");
    }
  }
  std::array<std::vector<std::uint8_t>, 3> colours;
  std::vector<std::uint8_t> mask;
  for_each_row_block(raster, [&](int first, int count) {
    for (int i = 0; i < 3; ++i) {
      raster.read(raster.band(i + 1), first, count, GDT_Byte, colours[static_cast<std::size_t>(i)]);
    }
    raster.read(GDALGetMaskBand(raster.band(1)), first, count, GDT_Byte, mask);
    for (std::size_t i = 0; i < mask.size(); ++i) {
      const auto height_m = height_of_rgb(encoding, colours[0][i], colours[1][i], colours[2][i]);
      if (mask[i] == 0 || !height_m) {
        append_void(source);
      } else {
        append_height(raster.path(), source, scale.to_metres(*height_m));
      }
    }
    hand_over_rows(source);
  });
}

GDALRasterBandH band_of_heights(const Raster& raster, int number) {
  if (number < 1 || number > raster.bands()) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected a band {}, found {} bands", raster.path().string(), number, raster.bands()),
        "count bands from 1");
  }
  const GDALRasterBandH band = raster.band(number);
  const GDALColorInterp colour = GDALGetRasterColorInterpretation(band);
  if (raster.bands() >= 3 && colour >= GCI_RedBand && colour <= GCI_BlueBand) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected heights, found a colour picture", raster.path().string()),
                "if it packs heights into colours, give --encoding mapbox or terrarium; in a scene, encoding "
                "= \"mapbox\"");
  }
  if (GDALGetRasterColorTable(band) != nullptr || GDALDataTypeIsComplex(GDALGetRasterDataType(band))) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected heights, found {}", raster.path().string(),
                            GDALGetRasterColorTable(band) != nullptr ? "a palette" : "complex numbers"),
                "give the file that the heights came from");
  }
  return band;
}

void read_plain(const Raster& raster, const HeightMapOptions& options, SourceHeights& source) {
  const GDALRasterBandH band = band_of_heights(raster, options.band);
  check_has_data(raster, band);
  const double unit_m = options.vertical_scale * metres_of_unit(raster, band);
  const HeightScale scale{GDALGetRasterScale(band, nullptr) * unit_m,
                          GDALGetRasterOffset(band, nullptr) * unit_m + options.offset_m};
  int has_nodata = 0;
  GDALGetRasterNoDataValue(band, &has_nodata);
  // SRTM's void, which files that went through other hands no longer declare.
  constexpr double srtm_void = -32768.0;
  const bool may_be_srtm = has_nodata == 0 && GDALGetRasterDataType(band) == GDT_Int16;
  const bool has_mask = (GDALGetMaskFlags(band) & GMF_ALL_VALID) == 0;
  source.declares_voids = has_nodata != 0 || has_mask;
  std::vector<double> samples;
  std::vector<std::uint8_t> mask;
  for_each_row_block(raster, [&](int first, int count) {
    raster.read(band, first, count, GDT_Float64, samples);
    if (has_mask) {
      raster.read(GDALGetMaskBand(band), first, count, GDT_Byte, mask);
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if ((has_mask && mask[i] == 0) || (may_be_srtm && samples[i] == srtm_void)) {
        append_void(source);
      } else {
        append_sample(raster.path(), source, samples[i], scale, options.nodata);
      }
    }
    hand_over_rows(source);
  });
}

std::optional<Georeference> georeference_of(const Raster& raster) {
  std::array<double, 6> corner{};
  if (GDALGetGeoTransform(raster.handle(), corner.data()) != CE_None) {
    if (GDALGetGCPCount(raster.handle()) == 0) {
      return std::nullopt;
    }
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a regular grid, found one placed by control points",
                            raster.path().string()),
                "make a grid of it with gdalwarp");
  }
  if (corner[2] != 0.0 || corner[4] != 0.0 || corner[1] < 0.0) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected columns toward the east and rows along the meridian, found a {} grid",
                    raster.path().string(), corner[1] < 0.0 ? "mirrored" : "rotated"),
        "make a north-up grid of it with gdalwarp");
  }
  if (!(std::isnormal(corner[1]) && std::isnormal(corner[5]) && std::isfinite(corner[0]) &&
        std::isfinite(corner[3]))) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a spacing of posts other than 0, found {:g} by {:g}",
                            raster.path().string(), corner[1], corner[5]),
                "repair the header, as with gdal_edit.py -tr 30 30");
  }
  // GDAL places the corner of the first sample, of point grids too; a post stands at the centre.
  Georeference georeference{
      {}, corner[0] + 0.5 * corner[1], corner[3] + 0.5 * corner[5], corner[1], corner[5]};
  if (const OGRSpatialReferenceH reference = GDALGetSpatialRef(raster.handle())) {
    georeference.coordinate_system = wkt_of(reference);
  }
  return georeference;
}

SampleExtent sample_extent_of(const Raster& raster) {
  const char* const text = GDALGetMetadataItem(raster.handle(), GDALMD_AREA_OR_POINT, nullptr);
  if (text == nullptr) {
    return SampleExtent::unknown;
  }
  return std::strcmp(text, GDALMD_AOP_POINT) == 0 ? SampleExtent::point : SampleExtent::area;
}

/// Rows from north to south.
void turn_over(SourceHeights& source) {
  const auto columns = static_cast<std::ptrdiff_t>(source.columns);
  for (std::ptrdiff_t top = 0, bottom = source.rows - 1; top < bottom; ++top, --bottom) {
    const auto swap_rows = [&](auto& values) {
      std::swap_ranges(values.begin() + top * columns, values.begin() + (top + 1) * columns,
                       values.begin() + bottom * columns);
    };
    swap_rows(source.heights_m);
    swap_rows(source.is_void);
  }
  source.georeference->origin_y += source.georeference->step_y * (source.rows - 1);
  source.georeference->step_y = -source.georeference->step_y;
}

}  // namespace

SourceHeights read_gdal_heights(const std::filesystem::path& path, const HeightMapOptions& options,
                                const RowTaker& taker) {
  const Raster raster(path, options.trust);
  if (raster.bands() == 0) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a raster of heights, found none in it", path.string()),
                "if it holds several, extract one into its own file");
  }
  SourceHeights source = begin_heights(path, raster.columns(), raster.rows(), taker);
  source.georeference = georeference_of(raster);
  source.format = GDALGetDriverLongName(GDALGetDatasetDriver(raster.handle()));
  source.sample_type = GDALGetDataTypeName(GDALGetRasterDataType(raster.band(1)));
  source.sample_extent = sample_extent_of(raster);
  const bool is_south_up = source.georeference && source.georeference->step_y > 0.0;
  if (is_south_up && taker.rows) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected rows from north to south, found a south-up raster", path.string()),
                "flip it with gdalwarp, which writes north-up rasters");
  }
  if (taker.begin) taker.begin(source);
  if (options.encoding == HeightEncoding::plain) {
    read_plain(raster, options, source);
  } else {
    read_rgb(raster, options.encoding, {options.vertical_scale, options.offset_m}, source);
  }
  if (is_south_up) {
    turn_over(source);
  }
  return source;
}

}  // namespace offing::height_maps
