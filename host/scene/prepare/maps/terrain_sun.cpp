#include "host/scene/prepare/maps/terrain_sun.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <glm/ext/vector_int2.hpp>
#include <glm/vec3.hpp>

#include "host/base/error.h"
#include "host/base/parallel_for.h"
#include "host/base/utc_time.h"
#include "host/terrain/analysis/sun_hours.h"

namespace offing::scene {

namespace {

using std::numbers::pi;

constexpr double radian_per_degree = pi / 180.0;
// Of the disc, at the mean distance. The Astronomical Almanac: 15' 59.64".
constexpr double sun_radius_rad = 959.64 / 3600.0 * radian_per_degree;
// Nobody asks how far air lifts what is below: there its lift stays, so that sunrise is linear between
// moments.
constexpr double lowest_lifted_rad = -1.0 * radian_per_degree;
constexpr double highest_tangent_at_rad = 89.5 * radian_per_degree;
constexpr int block_columns = 128;
// How far apart places are that say how a map lies, in posts.
constexpr double north_step_posts = 0.5;

/// The sun seen from a place, in the map's frame.
struct SeenSun {
  double tangent = 0.0;        // of the elevation of its edge, lifted
  double azimuth_rad = 0.0;    // clockwise from the map's north
  double elevation_rad = 0.0;  // of its middle, lifted
  glm::dvec3 direction{};      // to its middle
};

/// A moment at which the sun is looked at.
struct SunMoment {
  std::int64_t time_s = 0;
  sky::MomentOfSun sun;
  double hours = 0.0;  // since the one before; 0 where none precedes it
};

double lifted(double elevation_rad) {
  return elevation_rad + sky::refraction_rad(std::max(elevation_rad, lowest_lifted_rad), {});
}

SeenSun seen_sun(const SunMoment& moment, const SunPlace& place) {
  const sky::SunPosition sun = sky::sun_position_at(moment.sun, place.position);
  SeenSun seen;
  seen.azimuth_rad = sun.azimuth_rad - place.north_rad;
  seen.elevation_rad = lifted(sun.elevation_rad);
  const double edge_rad = lifted(sun.elevation_rad + sun_radius_rad / sun.distance_au);
  seen.tangent = std::tan(std::min(edge_rad, highest_tangent_at_rad));
  const std::array<double, 3> direction = sky::direction_of(seen.azimuth_rad, seen.elevation_rad);
  seen.direction = {direction[0], direction[1], direction[2]};
  return seen;
}

/// The turn that is nearest to another one.
double near_turn(double angle_rad, double other_rad) {
  return other_rad + std::remainder(angle_rad - other_rad, 2.0 * pi);
}

/// A block of columns of a band, and where the sun is computed for it: corners in the order (west, north),
/// (east, north), (west, south), (east, south).
struct SunCorners {
  int west = 0, east = 0, north = 0, south = 0;
};

BlockPlane plane_of(const SunCorners& block, const std::array<double, 4>& values) {
  const auto slope = [](double difference, int posts) {
    return posts == 0 ? 0.0f : static_cast<float>(0.5 * difference / posts);
  };
  return {.middle = static_cast<float>(0.25 * (values[0] + values[1] + values[2] + values[3])),
          .per_column = slope(values[1] + values[3] - values[0] - values[2], block.east - block.west),
          .per_row = slope(values[2] + values[3] - values[0] - values[1], block.south - block.north)};
}

/// The heights of a block: their middle, and how far from it they reach.
struct BlockHeights {
  double middle_m = 0.0, reach_m = 1.0;
};

BlockHeights heights_of(const HeightMap& map, const SunCorners& block) {
  float low_m = map.heights_m[map.index(block.west, block.north)], high_m = low_m;
  for (int row = block.north; row <= block.south; ++row) {
    const auto begin = map.heights_m.begin() + static_cast<std::ptrdiff_t>(map.index(block.west, row));
    const auto [low, high] = std::minmax_element(begin, begin + (block.east - block.west + 1));
    low_m = std::min(low_m, *low);
    high_m = std::max(high_m, *high);
  }
  const double middle_m = 0.5 * (static_cast<double>(low_m) + static_cast<double>(high_m));
  return {middle_m, std::max(1.0, static_cast<double>(high_m) - middle_m)};
}

Error nowhere(const Error& error) {
  return {error.kind(), error.what(),
          "give the latitude and longitude of the map (--latitude-deg, --longitude-deg), or place it with "
          "gdal_edit.py"};
}

}  // namespace

void require_valid(const SunSettings& settings) {
  const auto refuse = [](const std::string& what, const char* hint) {
    throw Error(ErrorKind::bad_input, "sun: " + what, hint);
  };
  const std::int64_t first_s = unix_seconds({.year = 1900, .month = 1, .day = 1, .hour = 0}),
                     past_s = unix_seconds({.year = 2101, .month = 1, .day = 1, .hour = 0});
  for (const std::int64_t time_s : {settings.from_s, settings.to_s}) {
    if (time_s >= first_s && time_s < past_s) continue;
    refuse(fmt::format("expected times of the years 1900 to 2100, found {} s since 1970", time_s),
           "give seconds since 1970-01-01T00:00Z");
  }
  if (settings.step_s < 1) {
    refuse(fmt::format("step_s: expected at least 1, found {}", settings.step_s), "3600 are usual");
  }
  if (settings.to_s <= settings.from_s) {
    refuse(fmt::format("expected an end after the start {}, found {}",
                       iso_time(from_unix_seconds(settings.from_s)).value_or("?"),
                       iso_time(from_unix_seconds(settings.to_s)).value_or("?")),
           "give the earlier time first");
  }
  const std::int64_t moments = (settings.to_s - settings.from_s - 1) / settings.step_s + 2;
  if (moments > most_moments) {
    refuse(fmt::format("expected at most {} steps, found {}", most_moments, moments),
           "give a longer step, or fewer days");
  }
  if (!(settings.linke_turbidity >= 1.0 && settings.linke_turbidity <= 20.0)) {
    refuse(fmt::format("linke_turbidity: expected 1 ... 20, found {:g}", settings.linke_turbidity),
           "3 is usual in clear air");
  }
  terrain::require_azimuths(settings.azimuths);
  terrain::require_valid(settings.curve);
}

void require_place(const MapFrame& map) {
  const glm::dvec2 first(0.0);
  sun_places(map, std::span(&first, 1));
}

std::vector<SunPlace> sun_places(const MapFrame& map, std::span<const glm::dvec2> places_m) {
  std::unique_ptr<MapCoordinates> lonlat;
  try {
    lonlat = map_coordinates(map, lonlat_places, "");
  } catch (const Error& error) {
    throw nowhere(error);
  }
  std::vector<glm::dvec2> places(places_m.begin(), places_m.end());
  for (const glm::dvec2& place_m : places_m) {
    for (const double posts : {-north_step_posts, north_step_posts}) {
      places.push_back({place_m.x, place_m.y + posts * map.spacing_z_m});
    }
  }
  const std::vector<glm::dvec2> degrees = lonlat->from_local(places);
  std::vector<SunPlace> found;
  for (std::size_t i = 0; i < places_m.size(); ++i) {
    const glm::dvec2 &at = degrees[i], &north = degrees[places_m.size() + 2 * i],
                     &south = degrees[places_m.size() + 2 * i + 1];
    if (std::isnan(at.x + north.x + south.x)) {
      throw Error(
          ErrorKind::bad_input,
          fmt::format("{}: expected a map on the Earth, found a place on it without a longitude",
                      printable(map.file)),
          "give the latitude and longitude of the map (--latitude-deg, --longitude-deg), or --reproject utm");
    }
    const double latitude_rad = at.y * radian_per_degree;
    // A degree of longitude beside one of latitude, on the ellipsoid of WGS 84.
    constexpr double e2 = 6.69437999014e-3;
    const double sine = std::sin(latitude_rad);
    const double shrink = std::cos(latitude_rad) * (1.0 - e2 * sine * sine) / (1.0 - e2);
    const double east = std::remainder(north.x - south.x, 360.0) * shrink;
    found.push_back({{latitude_rad, std::remainder(at.x, 360.0) * radian_per_degree},
                     std::atan2(east, north.y - south.y)});
  }
  return found;
}

struct TerrainSun::State {
  ocl::Device device;
  const terrain::HeightField& field;
  const HeightMap& map;
  MapFrame frame;
  std::optional<sky::GeoPosition> place;
  SunSettings settings;
  std::vector<SunMoment> moments{};
  std::vector<std::int64_t> up_s{};
  std::vector<int> up_moments{};  // numbers in `moments`
  // Where there are moments.
  std::optional<terrain::Horizons> horizons{};
  std::optional<terrain::SunHours> hours{};
  std::vector<int> slots{};  // [azimuths] numbers among the horizons; -1 where there is none
  // Of the band that was last read.
  std::vector<SunBlock> blocks{};
  std::vector<BlockSun> suns{};

  std::vector<SunPlace> places_at(const std::vector<glm::ivec2>& posts) const {
    if (place) return std::vector<SunPlace>(posts.size(), SunPlace{*place, 0.0});
    std::vector<glm::dvec2> places_m;
    for (const glm::ivec2& post : posts) {
      places_m.emplace_back(post.x * map.spacing_x_m, post.y * map.spacing_z_m);
    }
    return sun_places(frame, places_m);
  }

  /// A net over the map, from edge to edge.
  std::vector<SunPlace> places_over_map() const {
    std::vector<glm::ivec2> posts;
    for (const int part_z : {0, 1, 2}) {
      for (const int part_x : {0, 1, 2}) {
        posts.emplace_back(part_x * (map.columns - 1) / 2, part_z * (map.rows - 1) / 2);
      }
    }
    return places_at(posts);
  }

  /// Keeps the moments at which the sun is up somewhere, and those before and after.
  void choose_moments() {
    const std::vector<SunPlace> places = places_over_map();
    std::vector<SunMoment> all;
    for (std::int64_t time_s = settings.from_s;; time_s = std::min(time_s + settings.step_s, settings.to_s)) {
      all.push_back({time_s, sky::sun_at(from_unix_seconds(time_s)), 0.0});
      if (time_s == settings.to_s) break;
    }
    std::vector<bool> is_up(all.size() + 2, false);  // one moment later
    for (std::size_t i = 0; i < all.size(); ++i) {
      is_up[i + 1] = std::ranges::any_of(
          places, [&](const SunPlace& from) { return seen_sun(all[i], from).tangent > 0.0; });
    }
    std::size_t last = all.size();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!is_up[i] && !is_up[i + 1] && !is_up[i + 2]) continue;
      if (is_up[i + 1]) {
        up_s.push_back(all[i].time_s);
        up_moments.push_back(static_cast<int>(moments.size()));
      }
      if (i > 0 && last == i - 1) {
        constexpr double seconds_per_hour = 3600.0;
        all[i].hours = static_cast<double>(all[i].time_s - all[i - 1].time_s) / seconds_per_hour;
      }
      last = i;
      moments.push_back(all[i]);
    }
  }

  /// The azimuths between which the sun is, from somewhere on the map.
  std::vector<int> used_azimuths() const {
    const std::vector<SunPlace> places = places_over_map();
    const double per_rad = settings.azimuths / (2.0 * pi);
    std::vector<bool> is_used(static_cast<std::size_t>(settings.azimuths), false);
    for (const SunMoment& moment : moments) {
      const double middle_rad = seen_sun(moment, places[places.size() / 2]).azimuth_rad;
      double low_rad = middle_rad, high_rad = middle_rad;
      for (const SunPlace& from : places) {
        const double azimuth_rad = near_turn(seen_sun(moment, from).azimuth_rad, middle_rad);
        low_rad = std::min(low_rad, azimuth_rad);
        high_rad = std::max(high_rad, azimuth_rad);
      }
      // Over a sun in the zenith every azimuth is used.
      constexpr double beside = 0.1;  // between the places
      const bool is_all = high_rad - low_rad > 0.5 * pi;
      const int first = is_all ? 0 : static_cast<int>(std::floor(low_rad * per_rad - beside));
      const int past =
          is_all ? settings.azimuths : static_cast<int>(std::floor(high_rad * per_rad + beside)) + 2;
      for (int i = first; i < past; ++i) is_used[static_cast<std::size_t>(azimuth_number(i))] = true;
    }
    std::vector<int> used;
    for (int i = 0; i < settings.azimuths; ++i) {
      if (is_used[static_cast<std::size_t>(i)]) used.push_back(i);
    }
    return used;
  }

  int azimuth_number(int turned) const {
    return (turned % settings.azimuths + settings.azimuths) % settings.azimuths;
  }

  /// The horizon of an azimuth, or of the nearest one that is looked at.
  int slot_of(int turned) const {
    for (int away = 0;; ++away) {
      for (const int number : {azimuth_number(turned - away), azimuth_number(turned + away)}) {
        if (slots[static_cast<std::size_t>(number)] >= 0) return slots[static_cast<std::size_t>(number)];
      }
    }
  }

  BlockSun block_sun(const SunCorners& block, const BlockHeights& heights, const SunMoment& moment,
                     const std::array<const SeenSun*, 4>& corners) const {
    const auto plane = [&](auto value_of) {
      return plane_of(block, {value_of(*corners[0]), value_of(*corners[1]), value_of(*corners[2]),
                              value_of(*corners[3])});
    };
    BlockSun sun{};
    sun.tangent = plane([](const SeenSun& seen) { return seen.tangent; });
    sun.x = plane([](const SeenSun& seen) { return seen.direction.x; });
    sun.y = plane([](const SeenSun& seen) { return seen.direction.y; });
    sun.z = plane([](const SeenSun& seen) { return seen.direction.z; });
    const double first_rad = corners[0]->azimuth_rad, per_rad = settings.azimuths / (2.0 * pi);
    double middle = 0.0, elevation_rad = 0.0;
    for (const SeenSun* corner : corners) {
      middle += 0.25 * per_rad * near_turn(corner->azimuth_rad, first_rad);
      elevation_rad += 0.25 * corner->elevation_rad;
    }
    const double before = std::floor(middle);
    sun.share =
        plane([&](const SeenSun& seen) { return per_rad * near_turn(seen.azimuth_rad, first_rad) - before; });
    sun.horizon = slot_of(static_cast<int>(before));
    sun.next = slot_of(static_cast<int>(before) + 1);
    const auto beam_kw = [&](double above_m) {
      return 1e-3 * sky::direct_sunlight_w_per_m2(elevation_rad, heights.middle_m + above_m,
                                                  moment.sun.sun.distance_au, settings.linke_turbidity);
    };
    const double reach_m = heights.reach_m;
    const double low = beam_kw(-reach_m), mid = beam_kw(0.0), high = beam_kw(reach_m);
    sun.beam_0 = static_cast<float>(mid);
    sun.beam_1 = static_cast<float>(0.5 * (high - low) / reach_m);
    sun.beam_2 = static_cast<float>((0.5 * (high + low) - mid) / (reach_m * reach_m));
    sun.hours = static_cast<float>(moment.hours);
    return sun;
  }

  /// The suns of a band's blocks.
  void look_from(const terrain::RowBand& band) {
    const int block_count = (map.columns - 1) / block_columns + 1;
    const int north = band.first_row, south = std::min(band.first_row + band.rows, map.rows - 1);
    std::vector<glm::ivec2> posts;
    for (const int row : {north, south}) {
      for (int i = 0; i <= block_count; ++i) {
        posts.emplace_back(std::min(i * block_columns, map.columns - 1), row);
      }
    }
    const std::vector<SunPlace> places = places_at(posts);
    const std::size_t moment_count = moments.size();
    std::vector<SeenSun> seen(places.size() * moment_count);
    parallel_rows(static_cast<int>(places.size()), [&](int number) {
      const auto at = static_cast<std::size_t>(number);
      for (std::size_t i = 0; i < moment_count; ++i)
        seen[at * moment_count + i] = seen_sun(moments[i], places[at]);
    });
    blocks.resize(static_cast<std::size_t>(block_count));
    suns.resize(blocks.size() * moment_count);
    parallel_rows(block_count, [&](int number) {
      const auto west = static_cast<std::size_t>(number), row = blocks.size() + 1;
      const SunCorners block{posts[west].x, posts[west + 1].x, north, south};
      const BlockHeights heights = heights_of(map, block);
      blocks[west] = {.middle_column = 0.5f * static_cast<float>(block.west + block.east),
                      .middle_row = 0.5f * static_cast<float>(block.north + block.south),
                      .middle_m = static_cast<float>(heights.middle_m)};
      for (std::size_t i = 0; i < moment_count; ++i) {
        const auto corner = [&](std::size_t place_number) { return &seen[place_number * moment_count + i]; };
        suns[west * moment_count + i] =
            block_sun(block, heights, moments[i],
                      {corner(west), corner(west + 1), corner(row + west), corner(row + west + 1)});
      }
    });
  }

  terrain::SunsOfBand suns_of_band() const { return {block_columns, blocks, suns}; }
};

TerrainSun::TerrainSun(const ocl::Device& device, const terrain::HeightField& field, const HeightMap& map,
                       MapFrame frame, const std::optional<sky::GeoPosition>& place,
                       const SunSettings& settings)
    : state_(std::make_unique<State>(State{device, field, map, std::move(frame), place, settings})) {
  require_valid(settings);
  state_->choose_moments();
  if (state_->moments.empty()) return;
  std::vector<int> used = state_->used_azimuths();
  state_->slots.assign(static_cast<std::size_t>(settings.azimuths), -1);
  for (std::size_t i = 0; i < used.size(); ++i) {
    state_->slots[static_cast<std::size_t>(used[i])] = static_cast<int>(i);
  }
  state_->horizons.emplace(device, field, settings.azimuths, std::move(used), settings.curve);
  state_->hours.emplace(device, *state_->horizons);
}

TerrainSun::TerrainSun(TerrainSun&&) noexcept = default;
TerrainSun& TerrainSun::operator=(TerrainSun&&) noexcept = default;
TerrainSun::~TerrainSun() = default;

const std::vector<std::int64_t>& TerrainSun::up_s() const {
  return state_->up_s;
}

std::vector<terrain::RowBand> TerrainSun::bands() const {
  if (state_->horizons) return state_->horizons->bands();
  return {{0, state_->map.rows}};
}

void TerrainSun::read(const terrain::RowBand& band, std::span<float> hours, std::span<float> energy_kwh) {
  if (state_->moments.empty()) {
    std::ranges::fill(hours, 0.0f);
    std::ranges::fill(energy_kwh, 0.0f);
    return;
  }
  state_->horizons->at(band);
  state_->look_from(band);
  state_->hours->read(band, state_->suns_of_band(), hours, energy_kwh);
}

void TerrainSun::read_mask(const terrain::RowBand& band, std::size_t number, std::span<std::uint8_t> lit) {
  state_->hours->read_mask(band, state_->suns_of_band(), state_->up_moments.at(number), lit);
}

}  // namespace offing::scene
