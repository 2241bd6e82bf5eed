#include "host/io/hydrodynamics/hydrodynamic_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::hydrodynamics {
namespace {

using std::numbers::pi;

constexpr double most_radps = 1e3, least_radps = 1e-4;
constexpr double degrees = 180.0 / pi;

constexpr std::array<const char*, hull_motions> names{"surge", "sway", "heave", "roll", "pitch", "yaw"};

// Motion of the hull's axes i is that of the file from[i], times sign[i]: y up is the file's z, z to
// starboard its -y. The turn between both is proper, so that rotations change as places do.
constexpr std::array<std::size_t, hull_motions> from{0, 2, 1, 3, 5, 4};
constexpr std::array<double, hull_motions> sign{1, 1, -1, 1, 1, -1};

/// The symmetric part, as theory asks of hulls without forward speed: panel methods miss it by their error.
HullMatrix turned(const HullMatrix& matrix) {
  HullMatrix result{};
  for (std::size_t i = 0; i < hull_motions; ++i) {
    for (std::size_t j = 0; j < hull_motions; ++j) {
      result[hull_motions * i + j] =
          0.5 * sign[i] * sign[j] *
          (matrix[hull_motions * from[i] + from[j]] + matrix[hull_motions * from[j] + from[i]]);
    }
  }
  return result;
}

HullWrench turned(const HullWrench& wrench) {
  HullWrench result{};
  for (std::size_t i = 0; i < hull_motions; ++i) result[i] = sign[i] * wrench[from[i]];
  return result;
}

[[noreturn]] void fail(const HydrodynamicTable& table, const std::string& what, const char* hint) {
  throw Error(ErrorKind::bad_input, fmt::format("{}: {}", spectra::printable_name(table.name), what), hint);
}

constexpr const char* write_again = "compute the data again, and write a new file";

void require_finite(const HydrodynamicTable& table, const HullMatrix& matrix, const char* what,
                    double frequency_radps) {
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    // Squares and products must stay within double precision.
    if (std::abs(matrix[i]) < 1e30) continue;
    fail(table,
         fmt::format("expected a finite {} of {} by {} at {:g} rad/s, got {:g}", what,
                     names[i / hull_motions], names[i % hull_motions], frequency_radps, matrix[i]),
         write_again);
  }
}

void require_in_range(const HydrodynamicTable& table, const char* what, double value, double low,
                      double high) {
  if (value >= low && value <= high) return;
  fail(table, fmt::format("expected {} from {:g} to {:g}, got {:g}", what, low, high, value), write_again);
}

/// Indices in rising order of the values.
std::vector<std::size_t> rising(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
  return order;
}

/// Whether motions in the plane of symmetry and those across it are uncoupled, as for a hull with port and
/// starboard alike.
bool is_symmetric(const HydrodynamicData& data) {
  constexpr std::array<bool, hull_motions> is_across{false, false, true, true, true, false};
  for (const HullMatrix& a : data.added_mass) {
    for (std::size_t i = 0; i < hull_motions; ++i) {
      for (std::size_t j = 0; j < hull_motions; ++j) {
        const double own = std::sqrt(std::abs(a[7 * i] * a[7 * j]));
        if (is_across[i] != is_across[j] && std::abs(a[hull_motions * i + j]) > 0.01 * own) return false;
      }
    }
  }
  return true;
}

/// Adds the images of waves from one side.
void mirror(HydrodynamicData& data) {
  const double low = data.directions_rad.front(), high = data.directions_rad.back();
  const bool is_one_side =
      high - low > 0.0 && ((low > -1e-6 && high < pi + 1e-6) || (low > -pi - 1e-6 && high < 1e-6));
  if (!is_one_side || !is_symmetric(data)) return;
  struct Source {
    double direction_rad;
    std::size_t index;
    bool is_image;
  };
  std::vector<Source> sources;
  const std::size_t count = data.directions_rad.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double direction = data.directions_rad[i];
    sources.push_back({direction, i, false});
    const bool is_own_image = std::abs(std::sin(direction)) < 1e-6;
    if (!is_own_image) sources.push_back({-direction, i, true});
  }
  std::ranges::sort(sources, {}, &Source::direction_rad);
  std::vector<HullWrench> excitation;
  for (std::size_t k = 0; k < data.frequencies_radps.size(); ++k) {
    for (const Source& source : sources) {
      HullWrench wrench = data.excitation[k * count + source.index];
      if (source.is_image) {
        for (const std::size_t across : {2u, 3u, 4u}) wrench[across] = -wrench[across];
      }
      excitation.push_back(wrench);
    }
  }
  data.directions_rad.clear();
  for (const Source& source : sources) data.directions_rad.push_back(source.direction_rad);
  data.excitation = std::move(excitation);
}

}  // namespace

HydrodynamicFile in_hull_axes(const HydrodynamicTable& table) {
  require_in_range(table, "a density in kg/m3", table.density_kgpm3, 1.0, 1e5);
  require_in_range(table, "a gravity in m/s2", table.gravity_mps2, 0.01, 1e3);
  require_in_range(table, "a depth of water in m", table.depth_m, 1e-3,
                   std::numeric_limits<double>::infinity());
  for (int axis = 0; axis < 3; ++axis)
    require_in_range(table, "a point of rotation in m", table.about_m[axis], -1e6, 1e6);

  HydrodynamicFile file;
  HydrodynamicData& data = file.data;
  data.source = table.name;
  data.about_m = {table.about_m.x, table.about_m.z, -table.about_m.y};
  data.density_kgpm3 = table.density_kgpm3;
  data.gravity_mps2 = table.gravity_mps2;
  data.depth_m = table.depth_m;

  // A wave toward b in the file goes toward -b here.
  std::vector<double> directions = table.directions_rad;
  for (double& direction : directions) {
    require_in_range(table, "a direction in degrees", direction * degrees, -720.0, 720.0);
    direction = direction == 0.0 ? 0.0 : -direction;
  }
  std::vector<std::size_t> columns = rising(directions);
  // 360 degrees are 0.
  if (columns.size() > 1 &&
      std::abs(directions[columns.back()] - directions[columns.front()] - 2.0 * pi) < 1e-6)
    columns.pop_back();
  if (columns.empty()) fail(table, "expected waves of one direction or more, got none", write_again);
  for (std::size_t i = 1; i < columns.size(); ++i) {
    const double step = directions[columns[i]] - directions[columns[i - 1]];
    if (step < 1e-6) {
      fail(table,
           fmt::format("expected each direction once, got {:g} degrees twice",
                       0.0 - degrees * directions[columns[i]]),
           write_again);
    }
  }
  if (directions[columns.back()] - directions[columns.front()] >= 2.0 * pi - 1e-6) {
    fail(table,
         fmt::format("expected directions within one turn, got {:g} to {:g} degrees",
                     -degrees * directions[columns.back()], -degrees * directions[columns.front()]),
         write_again);
  }
  for (const std::size_t column : columns) data.directions_rad.push_back(directions[column]);

  for (const std::size_t row : rising(table.frequencies_radps)) {
    const double frequency = table.frequencies_radps[row];
    if (frequency == 0.0) continue;  // there are no waves
    require_finite(table, table.added_mass[row], "added mass", frequency);
    if (frequency == std::numeric_limits<double>::infinity()) {
      file.has_infinite_frequency = true;
      data.added_mass_at_infinity = turned(table.added_mass[row]);
      continue;
    }
    require_in_range(table, "a frequency in rad/s", frequency, least_radps, most_radps);
    if (!data.frequencies_radps.empty() && frequency < data.frequencies_radps.back() * (1.0 + 1e-6)) {
      fail(table, fmt::format("expected each frequency once, got {:g} rad/s twice", frequency), write_again);
    }
    require_finite(table, table.damping[row], "damping", frequency);
    for (std::size_t i = 0; i < hull_motions; ++i) {
      // Panel methods that lose precision give a little less than none.
      const double most = *std::ranges::max_element(table.damping[row]);
      const double value = table.damping[row][7 * i];
      if (value < -0.05 * std::abs(most) &&
          value < -0.05 * frequency * std::abs(table.added_mass[row][7 * i])) {
        fail(table,
             fmt::format("expected a damping of {} above 0 at {:g} rad/s, got {:g}", names[i], frequency,
                         value),
             "use finer panels, or leave this frequency out");
      }
    }
    data.frequencies_radps.push_back(frequency);
    data.added_mass.push_back(turned(table.added_mass[row]));
    data.damping.push_back(turned(table.damping[row]));
    for (const std::size_t column : columns) {
      const HullWrench& wrench = table.excitation[row * table.directions_rad.size() + column];
      for (std::size_t i = 0; i < hull_motions; ++i) {
        if (std::abs(wrench[i]) < 1e30) continue;
        fail(table,
             fmt::format("expected a finite excitation of {} at {:g} rad/s and {:g} degrees", names[i],
                         frequency, degrees * table.directions_rad[column]),
             write_again);
      }
      data.excitation.push_back(turned(wrench));
    }
  }
  if (data.frequencies_radps.size() < 2) {
    fail(table, fmt::format("expected two frequencies or more, got {}", data.frequencies_radps.size()),
         "compute some 20 or more, from the longest to the shortest waves of the sea");
  }
  if (!file.has_infinite_frequency) data.added_mass_at_infinity = data.added_mass.back();
  if (table.restoring) {
    require_finite(table, *table.restoring, "restoring force", 0.0);
    file.restoring = turned(*table.restoring);
  }
  mirror(data);
  return file;
}

}  // namespace offing::hydrodynamics
