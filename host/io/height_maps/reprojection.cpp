#include "host/io/height_maps/reprojection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_utils.h>

#include "host/base/error.h"
#include "host/io/height_maps/gdal_session.h"

namespace offing::height_maps {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

double centre_x(const SourceHeights& source) {
  return source.georeference->origin_x + 0.5 * source.georeference->step_x * (source.columns - 1);
}
double centre_y(const SourceHeights& source) {
  return source.georeference->origin_y + 0.5 * source.georeference->step_y * (source.rows - 1);
}

/// EPSG code of the WGS 84 / UTM zone of the map's centre.
std::string utm_zone(const std::filesystem::path& path, const SourceHeights& source) {
  constexpr double northernmost_deg = 84.0, southernmost_deg = -80.0;
  const auto centre =
      geographic_place(source.georeference->coordinate_system, centre_x(source), centre_y(source));
  if (!centre || centre->latitude_deg > northernmost_deg || centre->latitude_deg < southernmost_deg) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected a map within the zones of UTM, 80 S to 84 N, found another", path.string()),
        "name a coordinate system in metres, such as --reproject EPSG:3413");
  }
  const int zone = std::clamp(static_cast<int>(std::floor((centre->longitude_deg + 180.0) / 6.0)) + 1, 1, 60);
  return fmt::format("EPSG:{}{:02}", centre->latitude_deg >= 0.0 ? 326 : 327, zone);
}

std::string target_system(const std::filesystem::path& path, const SourceHeights& source,
                          const std::string& target) {
  const SpatialReference reference = spatial_reference(target == "utm" ? utm_zone(path, source) : target);
  if (!reference || !OSRIsProjected(reference.get())) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: --reproject: expected a coordinate system in metres, got \"{}\"{}", path.string(),
                    target, reference ? ", which is not in metres" : ", which PROJ does not know"),
        "write --reproject utm, or a projected system such as --reproject EPSG:32719");
  }
  return wkt_of(reference.get());
}

/// The heights as a raster in memory, voids as NaN.
Dataset memory_raster(const SourceHeights& source) {
  Dataset raster(
      GDALCreate(GDALGetDriverByName("MEM"), "", source.columns, source.rows, 1, GDT_Float32, nullptr));
  if (!raster) {
    return raster;
  }
  const Georeference& place = *source.georeference;
  std::array<double, 6> corner{place.origin_x - 0.5 * place.step_x, place.step_x, 0.0,
                               place.origin_y - 0.5 * place.step_y, 0.0,          place.step_y};
  GDALSetGeoTransform(raster.get(), corner.data());
  GDALSetProjection(raster.get(), place.coordinate_system.c_str());
  const GDALRasterBandH band = GDALGetRasterBand(raster.get(), 1);
  GDALSetRasterNoDataValue(band, nan);
  std::vector<float> row(static_cast<std::size_t>(source.columns));
  for (int r = 0; r < source.rows; ++r) {
    const std::size_t first = static_cast<std::size_t>(r) * row.size();
    for (std::size_t c = 0; c < row.size(); ++c) {
      row[c] = source.is_void[first + c] != 0 ? nan : source.heights_m[first + c];
    }
    if (GDALRasterIO(band, GF_Write, 0, r, source.columns, 1, row.data(), source.columns, 1, GDT_Float32, 0,
                     0) != CE_None) {
      return nullptr;
    }
  }
  return raster;
}

Dataset warp(GDALDatasetH source, const std::string& system) {
  char** arguments = nullptr;
  for (const char* const word : {"-of", "MEM", "-r", "bilinear", "-dstnodata", "nan", "-t_srs"}) {
    arguments = CSLAddString(arguments, word);
  }
  arguments = CSLAddString(arguments, system.c_str());
  GDALWarpAppOptions* const options = GDALWarpAppOptionsNew(arguments, nullptr);
  CSLDestroy(arguments);
  Dataset result(GDALWarp("", nullptr, 1, &source, options, nullptr));
  GDALWarpAppOptionsFree(options);
  return result;
}

}  // namespace

CoordinateUnits coordinate_units(const std::filesystem::path& path, const std::string& coordinate_system) {
  const GdalSession session;
  const SpatialReference reference = spatial_reference(coordinate_system);
  if (!reference) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a coordinate system, found one that cannot be understood: {}",
                            path.string(), session.failure()),
                "give it another, as with gdal_edit.py -a_srs EPSG:32719");
  }
  CoordinateUnits units;
  units.name = OSRGetName(reference.get());
  units.is_geographic = OSRIsGeographic(reference.get()) != 0;
  if (units.is_geographic) {
    constexpr double degree_rad = 0.017453292519943295;
    units.degrees_a_unit = OSRGetAngularUnits(reference.get(), nullptr) / degree_rad;
    units.equatorial_radius_m = OSRGetSemiMajor(reference.get(), nullptr);
    const double inverse = OSRGetInvFlattening(reference.get(), nullptr);
    units.flattening = inverse > 0.0 ? 1.0 / inverse : 0.0;
  } else {
    units.metres_a_unit = OSRGetLinearUnits(reference.get(), nullptr);
    const char* const projection = OSRGetAttrValue(reference.get(), "PROJECTION", 0);
    const std::string_view method = projection == nullptr ? "" : projection;
    units.is_mercator = method.starts_with("Mercator") || method == "Popular_Visualisation_Pseudo_Mercator";
  }
  return units;
}

std::optional<GeographicPlace> geographic_place(const std::string& coordinate_system, double x, double y) {
  const GdalSession session;
  const SpatialReference from = spatial_reference(coordinate_system), to = spatial_reference("EPSG:4326");
  if (!from || !to) {
    return std::nullopt;
  }
  const OGRCoordinateTransformationH way = OCTNewCoordinateTransformation(from.get(), to.get());
  if (way == nullptr) {
    return std::nullopt;
  }
  const bool is_there = OCTTransform(way, 1, &x, &y, nullptr) != 0 && std::isfinite(x) && std::isfinite(y);
  OCTDestroyCoordinateTransformation(way);
  return is_there && std::abs(y) <= 90.0 ? std::optional(GeographicPlace{y, x}) : std::nullopt;
}

SourceHeights reproject(const std::filesystem::path& path, const SourceHeights& source,
                        const std::string& target) {
  if (!source.georeference || source.georeference->coordinate_system.empty()) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: --reproject: expected a file with a coordinate system, found none", path.string()),
        "set the spacing instead, as with --spacing-m 30, or give the file its system with gdal_edit.py "
        "-a_srs");
  }
  const GdalSession session;
  const std::string system = target_system(path, source, target);
  const Dataset from = memory_raster(source);
  const Dataset to = from ? warp(from.get(), system) : nullptr;
  if (!to) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: cannot be resampled to \"{}\": {}", path.string(), target, session.failure()),
        "choose a coordinate system that covers the map, such as --reproject utm");
  }
  SourceHeights result = begin_heights(path, GDALGetRasterXSize(to.get()), GDALGetRasterYSize(to.get()));
  result.format = source.format;
  result.sample_type = source.sample_type;
  result.sample_extent = source.sample_extent;
  std::vector<float> row(static_cast<std::size_t>(result.columns));
  for (int r = 0; r < result.rows; ++r) {
    if (GDALRasterIO(GDALGetRasterBand(to.get(), 1), GF_Read, 0, r, result.columns, 1, row.data(),
                     result.columns, 1, GDT_Float32, 0, 0) != CE_None) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: resampled row {} is lost: {}", path.string(), r, session.failure()));
    }
    for (const float height_m : row) {
      if (std::isnan(height_m)) {
        append_void(result);
      } else {
        append_height(path, result, height_m);
      }
    }
  }
  std::array<double, 6> corner{};
  GDALGetGeoTransform(to.get(), corner.data());
  result.georeference =
      Georeference{system, corner[0] + 0.5 * corner[1], corner[3] + 0.5 * corner[5], corner[1], corner[5]};
  return result;
}

}  // namespace offing::height_maps
