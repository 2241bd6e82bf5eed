#include "host/bodies/excitation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/bodies/panel_method.h"
#include "kernels/shared/query_params.h"

namespace offing::bodies {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr std::size_t most_modes = 16384;
constexpr double kept_energy = 0.999;

struct Corner {
  glm::dvec3 place_m{0.0};  // from the mass centre
  double depth_m = 0.0;
  glm::dvec3 shares{0.0};  // of the face's vertices in what is linear over it
};

/// A vertex of the wetted hull, and the force of a rise of 1 m of the water there, linear over each face.
struct WetVertex {
  glm::dvec3 place_m{0.0};
  std::array<double, hull_motions> force{};
};

Corner between(const Corner& a, const Corner& b) {
  const double share = a.depth_m / (a.depth_m - b.depth_m);
  return {a.place_m + share * (b.place_m - a.place_m), 0.0, a.shares + share * (b.shares - a.shares)};
}

/// The pressure of rises on a triangle, all of it below the water.
void add_triangle(const std::array<const Corner*, 3>& corners, double weight,
                  const std::array<WetVertex*, 3>& vertices) {
  const glm::dvec3 from = corners[0]->place_m;
  const glm::dvec3 area = 0.5 * glm::cross(corners[1]->place_m - from, corners[2]->place_m - from);
  const glm::dvec3 shares = corners[0]->shares + corners[1]->shares + corners[2]->shares;
  for (int vertex = 0; vertex < 3; ++vertex) {
    std::array<double, hull_motions>& force = vertices[static_cast<std::size_t>(vertex)]->force;
    glm::dvec3 moment(0.0);
    // The integral of a product of linear functions.
    for (const Corner* corner : corners) {
      moment += (shares[vertex] + corner->shares[vertex]) / 12.0 * glm::cross(corner->place_m, area);
    }
    for (int axis = 0; axis < 3; ++axis) {
      force[static_cast<std::size_t>(axis)] -= weight / 3.0 * shares[vertex] * area[axis];
      force[static_cast<std::size_t>(axis) + 3] -= weight * moment[axis];
    }
  }
}

void add_face(const std::array<Corner, 3>& face, double weight, const std::array<WetVertex*, 3>& vertices) {
  std::vector<Corner> wet;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner &from = face[i], &to = face[(i + 1) % 3];
    if (from.depth_m > 0.0) wet.push_back(from);
    if ((from.depth_m > 0.0) != (to.depth_m > 0.0)) wet.push_back(between(from, to));
  }
  for (std::size_t i = 2; i < wet.size(); ++i) {
    add_triangle({&wet[0], &wet[i - 1], &wet[i]}, weight, vertices);
  }
}

std::vector<WetVertex> wet_vertices(const FloatingBody& body, double weight) {
  std::vector<WetVertex> vertices;
  for (const glm::dvec3& place_m : body.hull.positions_m) {
    vertices.push_back({.place_m = place_m - body.mass_centre_m});
  }
  const double level_m = body.hydrodynamics->water_level_m - body.mass_centre_m.y;
  for (const TriangleIndices& face : body.hull.faces) {
    std::array<Corner, 3> corners;
    std::array<WetVertex*, 3> of_face{};
    for (std::size_t i = 0; i < 3; ++i) {
      of_face[i] = &vertices[face[i]];
      corners[i] = {of_face[i]->place_m, level_m - of_face[i]->place_m.y};
      corners[i].shares[static_cast<int>(i)] = 1.0;
    }
    add_face(corners, weight, of_face);
  }
  std::erase_if(vertices, [](const WetVertex& vertex) {
    return std::ranges::all_of(vertex.force, [](double value) { return value == 0.0; });
  });
  return vertices;
}

HullWrench excitation_of(const std::vector<WetVertex>& vertices, double wavenumber_radpm,
                         double direction_rad) {
  const double along = wavenumber_radpm * std::cos(direction_rad);
  const double across = wavenumber_radpm * std::sin(direction_rad);
  HullWrench sum{};
  for (const WetVertex& vertex : vertices) {
    const Complex rise = std::polar(1.0, along * vertex.place_m.x + across * vertex.place_m.z);
    for (std::size_t i = 0; i < hull_motions; ++i) sum[i] += vertex.force[i] * rise;
  }
  return sum;
}

std::uint32_t turns_of(double angle_rad) {
  const double turns = angle_rad / (2.0 * pi);
  return static_cast<std::uint32_t>(
      static_cast<std::uint64_t>(std::llround((turns - std::floor(turns)) * 4294967296.0)));
}

}  // namespace

HullWrench hydrostatic_excitation(const FloatingBody& body, double wavenumber_radpm, double direction_rad,
                                  double density_kgpm3, double gravity_mps2) {
  return excitation_of(wet_vertices(body, density_kgpm3 * gravity_mps2), wavenumber_radpm, direction_rad);
}

WaveTable wave_table(const FloatingBody& body, double density_kgpm3, double gravity_mps2) {
  const HydrodynamicData& data = *body.hydrodynamics;
  if (data.excitation.size() != data.frequencies_radps.size() * data.directions_rad.size()) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected the excitation of {} frequencies and {} directions, found {} values",
                    data.source, data.frequencies_radps.size(), data.directions_rad.size(),
                    data.excitation.size()),
        "compute the hydrodynamic data again");
  }
  if (data.excitation.empty()) {
    return {.values = std::vector<float>(
                std::size_t{BODY_WAVE_DIRECTIONS} * BODY_WAVE_FREQUENCIES * BODY_WAVE_FLOATS, 0.0f)};
  }
  const glm::dvec3 arm_m = body.mass_centre_m - data.about_m;
  // Hulls' data may be of another density and gravity than the water's.
  const double scale = density_kgpm3 * gravity_mps2 / (data.density_kgpm3 * data.gravity_mps2);
  const std::vector<WetVertex> vertices = wet_vertices(body, density_kgpm3 * gravity_mps2);
  WaveTable table;
  table.step_radps = data.frequencies_radps.back() / BODY_WAVE_FREQUENCIES;
  table.values.reserve(std::size_t{BODY_WAVE_DIRECTIONS} * BODY_WAVE_FREQUENCIES * BODY_WAVE_FLOATS);
  for (int side = 0; side < BODY_WAVE_DIRECTIONS; ++side) {
    const double direction_rad = 2.0 * pi * side / BODY_WAVE_DIRECTIONS;
    for (int row = 1; row <= BODY_WAVE_FREQUENCIES; ++row) {
      const double frequency_radps = row * table.step_radps;
      const double wavenumber_radpm = frequency_radps * frequency_radps / data.gravity_mps2;
      HullWrench whole = excitation_at(data, frequency_radps, direction_rad);
      // From a crest at about_m to one at the mass centre, and moments about it.
      const Complex later = scale * std::polar(1.0, -wavenumber_radpm * (arm_m.x * std::cos(direction_rad) +
                                                                         arm_m.z * std::sin(direction_rad)));
      for (Complex& value : whole) value *= later;
      whole[3] -= arm_m.y * whole[2] - arm_m.z * whole[1];
      whole[4] -= arm_m.z * whole[0] - arm_m.x * whole[2];
      whole[5] -= arm_m.x * whole[1] - arm_m.y * whole[0];
      const HullWrench there = excitation_of(vertices, wavenumber_radpm, direction_rad);
      // Below its lowest frequency data have none: what is missing there rises as the square of it.
      const double known = std::min(1.0, std::pow(frequency_radps / data.frequencies_radps.front(), 2.0));
      for (std::size_t i = 0; i < hull_motions; ++i) whole[i] = known * (whole[i] - there[i]);
      for (const Complex& value : whole) table.values.push_back(static_cast<float>(value.real()));
      for (const Complex& value : whole) table.values.push_back(static_cast<float>(value.imag()));
    }
  }
  return table;
}

std::vector<SeaMode> leading_modes(const ModalSea& sea) {
  std::vector<SeaMode> kept, of_patches;
  for (const SeaMode& mode : sea.modes) {
    if (mode.amplitude_m == 0.0 || !(mode.omega_radps > 0.0)) continue;
    (mode.patch == SeaMode::alone ? kept : of_patches).push_back(mode);
  }
  const auto energy = [](const SeaMode& mode) { return mode.amplitude_m * mode.amplitude_m; };
  std::ranges::stable_sort(of_patches, std::ranges::greater{}, energy);
  double whole = 0.0, sum = 0.0;
  for (const SeaMode& mode : of_patches) whole += energy(mode);
  for (const SeaMode& mode : of_patches) {
    if (sum >= kept_energy * whole || kept.size() >= most_modes) break;
    sum += energy(mode);
    kept.push_back(mode);
  }
  return kept;
}

std::vector<BodyWave> device_waves(const std::vector<SeaMode>& modes, double time_s, double question_s,
                                   double gravity_mps2) {
  std::vector<BodyWave> waves;
  for (const SeaMode& mode : modes) {
    const double wavenumber_radpm = std::hypot(mode.kx_radpm, mode.kz_radpm);
    const double tile_m = SURFACE_QUERY_TILE_M;
    waves.push_back({.phase = turns_of(mode.phase_rad - mode.omega_radps * time_s),
                     .phase_by_question = turns_of(-mode.omega_radps * question_s),
                     .phase_by_tile_x = turns_of(mode.kx_radpm * tile_m),
                     .phase_by_tile_z = turns_of(mode.kz_radpm * tile_m),
                     .amplitude_m = static_cast<float>(mode.amplitude_m),
                     .kx_radpm = static_cast<float>(mode.kx_radpm),
                     .kz_radpm = static_cast<float>(mode.kz_radpm),
                     .frequency_radps = static_cast<float>(std::sqrt(gravity_mps2 * wavenumber_radpm)),
                     .direction_rad = static_cast<float>(std::atan2(mode.kz_radpm, mode.kx_radpm))});
  }
  return waves;
}

}  // namespace offing::bodies
