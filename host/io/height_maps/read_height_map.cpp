#include "host/io/height_maps/read_height_map.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "host/base/error.h"
#include "host/io/height_maps/mosaic.h"
#include "host/io/height_maps/readable_file.h"
#include "host/io/height_maps/reprojection.h"
#include "host/io/height_maps/source_heights.h"
#include "host/io/height_maps/void_fill.h"

namespace offing {
namespace {

constexpr double wgs84_radius_m = 6378137.0, wgs84_flattening = 1.0 / 298.257223563;

/// Length of a degree on the ground.
struct DegreeLength {
  double east_m = 0.0;   ///< along the parallel
  double north_m = 0.0;  ///< along the meridian
};

/// On an ellipsoid of that equatorial radius and flattening, at a geodetic latitude: the prime vertical and
/// meridian radii of curvature, times pi / 180. Torge & Mueller 2012, Geodesy, section 4.1.3.
DegreeLength degree_length(double latitude_deg, double equatorial_radius_m, double flattening) {
  constexpr double degree_rad = std::numbers::pi / 180.0;
  const double eccentricity_squared = flattening * (2.0 - flattening);
  const double sine = std::sin(latitude_deg * degree_rad);
  const double w = std::sqrt(1.0 - eccentricity_squared * sine * sine);
  const double prime_vertical_m = equatorial_radius_m / w;
  const double meridian_m = equatorial_radius_m * (1.0 - eccentricity_squared) / (w * w * w);
  return {prime_vertical_m * std::cos(latitude_deg * degree_rad) * degree_rad, meridian_m * degree_rad};
}

using height_maps::SourceHeights;

// Of posts that somebody could have measured.
constexpr double least_spacing_m = 1e-3, most_spacing_m = 1e5;

void check_options(const std::filesystem::path& path, const HeightMapOptions& options) {
  const auto check_spacing = [&](const std::optional<double>& spacing_m) {
    if (spacing_m && !(*spacing_m >= least_spacing_m && *spacing_m <= most_spacing_m)) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: expected a spacing of posts within {:g} ... {:g} m, found {:g}",
                              path.string(), least_spacing_m, most_spacing_m, *spacing_m),
                  "write the metres between two posts, such as --spacing-m 30");
    }
  };
  check_spacing(options.spacing_x_m);
  check_spacing(options.spacing_z_m);
  if (!std::isfinite(options.vertical_scale) || options.vertical_scale == 0.0 ||
      !std::isfinite(options.offset_m)) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected a finite scale of heights other than 0 and a finite offset, found {:g} and "
                    "{:g} m",
                    path.string(), options.vertical_scale, options.offset_m),
        "write the metres per unit, such as --scale 0.1");
  }
  if (options.void_height_m && !(std::abs(*options.void_height_m) <= height_maps::farthest_height_m)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a height of voids within {:g} m, found {:g}", path.string(),
                            height_maps::farthest_height_m, *options.void_height_m),
                "write the metres, such as --void-height-m 0");
  }
}

SourceHeights read_any(const std::filesystem::path& path, const HeightMapOptions& options,
                       const height_maps::RowTaker& taker) {
  if (height_maps::is_raw_name(path)) {
    return height_maps::read_raw_heights(path, options, taker);
  }
  const std::string extension = path.extension().string();
  if (extension != ".exr" && extension != ".EXR") {
    return height_maps::read_gdal_heights(path, options, taker);
  }
  SourceHeights source = height_maps::read_exr_heights(path, options);
  source.taker = taker;
  if (taker.begin) taker.begin(source);
  height_maps::hand_over_rows(source);
  return source;
}

SourceHeights read_source(const std::filesystem::path& path, const HeightMapOptions& options,
                          const height_maps::RowTaker& taker = {}) {
  SourceHeights source = read_any(path, options, taker);
  if (source.likely_voids > 0 && !source.declares_voids && !options.nodata) {
    spdlog::warn(
        "{}: {} post{} of {:g} m: this often marks voids, but the file does not say so; if they are voids, "
        "give --nodata {:g}, or nodata = {:g} in a scene",
        one_line(path.string()), source.likely_voids, source.likely_voids == 1 ? "" : "s", source.likely_void,
        source.likely_void, source.likely_void);
  }
  return source;
}

/// Without a coordinate system: whether the numbers look like degrees, which would make metres a bad guess.
bool may_be_degrees(const SourceHeights& source) {
  const Georeference& place = *source.georeference;
  const double far_x = place.origin_x + place.step_x * (source.columns - 1);
  const double far_y = place.origin_y + place.step_y * (source.rows - 1);
  constexpr double widest_step_deg = 0.1;
  return std::max(std::abs(place.origin_x), std::abs(far_x)) <= 360.0 &&
         std::max(std::abs(place.origin_y), std::abs(far_y)) <= 90.0 && place.step_x < widest_step_deg;
}

height_maps::CoordinateUnits units_of(const std::filesystem::path& path, const SourceHeights& source,
                                      HorizontalUnit wanted) {
  if (!source.georeference->coordinate_system.empty()) {
    return height_maps::coordinate_units(path, source.georeference->coordinate_system);
  }
  if (wanted == HorizontalUnit::of_file && may_be_degrees(source)) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected a coordinate system, found none and a spacing of {:g}: metres or degrees?",
                    path.string(), source.georeference->step_x),
        "give --unit degree or --unit metre, or the spacing with --spacing-m");
  }
  height_maps::CoordinateUnits units;
  units.is_geographic = wanted == HorizontalUnit::degree;
  units.equatorial_radius_m = wgs84_radius_m;
  units.flattening = wgs84_flattening;
  return units;
}

/// Throws Error(bad_input) where one spacing along x will not do for the whole of a map.
void require_one_spacing(const std::filesystem::path& path, const char* units, double south_deg,
                         double north_deg, double worst) {
  constexpr double most = 0.05;
  if (worst <= most) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: in {} from {:.4g} to {:.4g} N, where the spacing along x changes by {:.0f} %, "
                          "expected at most {:.0f} %",
                          one_line(path.string()), units, south_deg, north_deg, 100.0 * worst, 100.0 * most),
              "resample it to metres with --reproject utm or --reproject EPSG:CODE, or cut out a part");
}

/// Spacing of a geographic map at its middle latitude.
std::pair<double, double> spacing_of_degrees(const std::filesystem::path& path, const SourceHeights& source,
                                             const height_maps::CoordinateUnits& units) {
  const Georeference& place = *source.georeference;
  const double north_deg = place.origin_y * units.degrees_a_unit;
  const double south_deg = north_deg + place.step_y * units.degrees_a_unit * (source.rows - 1);
  constexpr double rounding_deg = 1e-6;
  if (!(std::max(std::abs(north_deg), std::abs(south_deg)) <= 90.0 + rounding_deg)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected latitudes within 90 degrees, found {:.6g} to {:.6g}",
                            one_line(path.string()), south_deg, north_deg),
                "repair the header, as with gdal_edit.py -a_ullr, or set the spacing: --spacing-m 30");
  }
  const auto length_at = [&](double latitude_deg) {
    return degree_length(std::clamp(latitude_deg, -90.0, 90.0), units.equatorial_radius_m, units.flattening);
  };
  const DegreeLength middle = length_at(0.5 * (north_deg + south_deg));
  require_one_spacing(path, "degrees", south_deg, north_deg,
                      std::max(std::abs(length_at(north_deg).east_m - middle.east_m),
                               std::abs(length_at(south_deg).east_m - middle.east_m)) /
                          middle.east_m);
  return {place.step_x * units.degrees_a_unit * middle.east_m,
          -place.step_y * units.degrees_a_unit * middle.north_m};
}

/// Metres on the ground between two columns, and two rows, of a map in Mercator.
struct GroundStep {
  double east_m = 0.0, south_m = 0.0, latitude_deg = 0.0;
};

GroundStep ground_step(const std::filesystem::path& path, const SourceHeights& source, double row) {
  const Georeference& place = *source.georeference;
  const double column = 0.5 * (source.columns - 1);
  const auto at = [&](double of_column, double of_row) {
    const auto found =
        height_maps::geographic_place(place.coordinate_system, place.origin_x + place.step_x * of_column,
                                      place.origin_y + place.step_y * of_row);
    if (found) return *found;
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a map in Mercator, found coordinates that are not on the earth",
                            one_line(path.string())),
                "repair the header, as with gdal_edit.py -a_ullr, or set the spacing: --spacing-m 30");
  };
  const height_maps::GeographicPlace middle = at(column, row);
  const DegreeLength degree = degree_length(middle.latitude_deg, wgs84_radius_m, wgs84_flattening);
  const double east_deg = at(column + 0.5, row).longitude_deg - at(column - 0.5, row).longitude_deg;
  const double south_deg = at(column, row - 0.5).latitude_deg - at(column, row + 0.5).latitude_deg;
  return {east_deg * degree.east_m, south_deg * degree.north_m, middle.latitude_deg};
}

/// Spacing of a map in Mercator on the ground of its middle row.
std::pair<double, double> spacing_of_mercator(const std::filesystem::path& path,
                                              const SourceHeights& source) {
  const GroundStep north = ground_step(path, source, 0.0),
                   south = ground_step(path, source, source.rows - 1.0),
                   middle = ground_step(path, source, 0.5 * (source.rows - 1));
  require_one_spacing(
      path, "Mercator", south.latitude_deg, north.latitude_deg,
      std::max(std::abs(north.east_m - middle.east_m), std::abs(south.east_m - middle.east_m)) /
          middle.east_m);
  return {middle.east_m, middle.south_m};
}

/// Size, spacing, where it comes from, and the centre.
void settle_spacing(const std::filesystem::path& path, const SourceHeights& source,
                    const HeightMapOptions& options, HeightMapFile& file) {
  file.source.format = source.format;
  file.source.sample_type = source.sample_type;
  file.source.sample_extent = source.sample_extent;
  HeightMap& map = file.map;
  map.columns = source.columns;
  map.rows = source.rows;
  if (source.georeference) {
    map.georeference = *source.georeference;
  }
  const bool is_stated = options.spacing_x_m && options.spacing_z_m;
  if (source.georeference && !is_stated) {
    const height_maps::CoordinateUnits units = units_of(path, source, options.horizontal_unit);
    file.source.coordinate_system = units.name;
    if (units.is_geographic) {
      std::tie(map.spacing_x_m, map.spacing_z_m) = spacing_of_degrees(path, source, units);
      file.source.spacing_source = SpacingSource::latitude;
    } else if (units.is_mercator) {
      std::tie(map.spacing_x_m, map.spacing_z_m) = spacing_of_mercator(path, source);
      file.source.spacing_source = SpacingSource::mercator;
      file.source.projection_scale = source.georeference->step_x * units.metres_a_unit / map.spacing_x_m;
    } else {
      map.spacing_x_m = source.georeference->step_x * units.metres_a_unit;
      map.spacing_z_m = -source.georeference->step_y * units.metres_a_unit;
      file.source.spacing_source =
          options.reproject_to.empty() ? SpacingSource::file : SpacingSource::reprojected;
    }
  }
  const auto check_spacing = [&](double spacing_m) {
    if (spacing_m >= least_spacing_m && spacing_m <= 10.0 * most_spacing_m) return;
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a spacing of posts within {:g} ... {:g} m, found {:g} m in its "
                            "georeference",
                            one_line(path.string()), least_spacing_m, 10.0 * most_spacing_m, spacing_m),
                "repair the header, as with gdal_edit.py -tr 30 30, or set the spacing: --spacing-m 30");
  };
  if (source.georeference && !is_stated) {
    check_spacing(map.spacing_x_m);
    check_spacing(map.spacing_z_m);
  }
  if (options.spacing_x_m || options.spacing_z_m) {
    map.spacing_x_m = options.spacing_x_m.value_or(map.spacing_x_m);
    map.spacing_z_m = options.spacing_z_m.value_or(map.spacing_z_m);
    file.source.spacing_source = SpacingSource::options;
  }
  if (source.georeference && !source.georeference->coordinate_system.empty()) {
    const Georeference& place = *source.georeference;
    const auto centre = height_maps::geographic_place(
        place.coordinate_system, place.origin_x + 0.5 * place.step_x * (source.columns - 1),
        place.origin_y + 0.5 * place.step_y * (source.rows - 1));
    if (centre) {
      file.source.centre_latitude_deg = centre->latitude_deg;
      file.source.centre_longitude_deg = centre->longitude_deg;
    }
  }
}

[[noreturn]] void refuse_all_voids(const std::filesystem::path& path, const HeightMap& map) {
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected heights, found nothing but voids at its {}x{} posts", path.string(),
                          map.columns, map.rows),
              "check the nodata value of the file, and that it covers the part you want");
}

/// Range and voids; fills them.
void settle_voids(const std::filesystem::path& path, const HeightMapOptions& options, HeightMapFile& file) {
  HeightMap& map = file.map;
  HeightMapSource& source = file.source;
  source.void_posts = static_cast<std::size_t>(std::count(map.is_void.begin(), map.is_void.end(), 1));
  if (source.void_posts == map.heights_m.size()) {
    refuse_all_voids(path, map);
  }
  source.void_area_m2 = static_cast<double>(source.void_posts) * map.spacing_x_m * map.spacing_z_m;
  bool is_first = true;
  for (std::size_t i = 0; i < map.heights_m.size(); ++i) {
    if (map.is_void[i] == 0) {
      source.lowest_m = is_first ? map.heights_m[i] : std::min(source.lowest_m, map.heights_m[i]);
      source.highest_m = is_first ? map.heights_m[i] : std::max(source.highest_m, map.heights_m[i]);
      is_first = false;
    }
  }
  if (source.void_posts == 0) {
    map.is_void = {};
    return;
  }
  if (!options.void_height_m) {
    height_maps::fill_voids(map.columns, map.rows, map.heights_m, map.is_void);
    return;
  }
  for (std::size_t i = 0; i < map.heights_m.size(); ++i) {
    if (map.is_void[i] != 0) {
      map.heights_m[i] = static_cast<float>(*options.void_height_m);
    }
  }
}

}  // namespace

HeightMapFile read_height_map(const std::filesystem::path& path, const HeightMapOptions& options) {
  height_maps::require_readable_file(path, "a height map",
                                     "give the path of a file; `offing terrain tile` makes a store of a "
                                     "folder of height maps, and resumes an interrupted one");
  check_options(path, options);
  SourceHeights source = read_source(path, options);
  if (!options.reproject_to.empty()) {
    source = height_maps::reproject(path, source, options.reproject_to);
  }
  HeightMapFile file;
  settle_spacing(path, source, options, file);
  file.map.heights_m = std::move(source.heights_m);
  file.map.is_void = std::move(source.is_void);
  settle_voids(path, options, file);
  return file;
}

void warn_of_assumed_spacing(const std::filesystem::path& path, const HeightMapSource& source) {
  if (source.spacing_source != SpacingSource::assumed) return;
  spdlog::warn(
      "{}: the file gives no spacing of its posts, so 1 m is assumed: set --spacing-m; in a scene, "
      "spacing_x_m and spacing_z_m",
      path.string());
}

HeightMapSource stream_height_map(const std::filesystem::path& path, const HeightMapOptions& options,
                                  const std::function<void(const HeightMapFile&)>& begin,
                                  const TakeRow& row) {
  std::optional<height_maps::Mosaic> mosaic;
  std::error_code status;
  if (std::filesystem::is_directory(path, status)) {
    mosaic.emplace(path, options.trust.trust);
  } else {
    height_maps::require_readable_file(path, "a height map");
  }
  check_options(path, options);
  if (!options.reproject_to.empty()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: a map that is read row by row cannot be resampled to \"{}\"", path.string(),
                            options.reproject_to),
                "resample it first, as with gdalwarp -t_srs EPSG:32719, and leave --reproject out");
  }
  HeightMapFile about;
  std::optional<height_maps::VoidBands> bands;
  height_maps::RowTaker taker;
  taker.begin = [&](const SourceHeights& source) {
    settle_spacing(path, source, options, about);
    begin(about);
    bands.emplace(source.columns, options.void_height_m, row);
  };
  taker.rows = [&](std::span<const float> heights_m, std::span<const std::uint8_t> is_void) {
    bands->add(heights_m, is_void);
  };
  read_source(mosaic ? mosaic->path() : path, options, taker);
  bands->finish();
  about.source.void_posts = bands->void_posts();
  if (bands->void_posts() == bands->posts()) refuse_all_voids(path, about.map);
  about.source.void_area_m2 =
      static_cast<double>(bands->void_posts()) * about.map.spacing_x_m * about.map.spacing_z_m;
  about.source.lowest_m = bands->lowest_m();
  about.source.highest_m = bands->highest_m();
  return about.source;
}

}  // namespace offing
