// The panel method against closed forms, its own reciprocities, and numbers of Capytaine 3.0.
#include "host/bodies/panel_method.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/bodies/panel_hull.h"
#include "host/mesh_shapes/shape.h"
#include "tests/bodies/example_bodies.h"

namespace offing::bodies {
namespace {

constexpr double gravity_mps2 = 9.81;
using std::numbers::pi;

HydrodynamicData data_of(const TriangleMesh& mesh, double level_m, const PanelOptions& options = {}) {
  return panel_method(mesh, level_m, {0.0, level_m, 0.0}, test::sea_density_kgpm3, gravity_mps2, options);
}

struct Loaded {
  HydrodynamicData data;
  HullMatrix mass, restoring;
};

/// A box with its mass centre this far below its middle, of uniform inertia.
Loaded loaded_box(const glm::dvec3& sides_m, double draught_m, double below_m) {
  const TriangleMesh mesh = test::box(sides_m);
  const double level_m = draught_m - 0.5 * sides_m.y;
  const Submerged below = submerged_below(mesh, level_m);
  const double mass = test::sea_density_kgpm3 * below.volume_m3;
  const glm::dvec3 centre(0.0, -below_m, 0.0), s = sides_m * sides_m * (mass / 12.0);
  return {panel_method(mesh, level_m, centre, test::sea_density_kgpm3, gravity_mps2),
          mass_matrix(mass, {s.y + s.z, 0, 0, 0, s.x + s.z, 0, 0, 0, s.x + s.y}, centre, centre),
          restoring_matrix(below, centre, centre, test::sea_density_kgpm3, gravity_mps2)};
}

double heave_of(const Loaded& box, double period_s) {
  return std::abs(linear_response(box.data, box.mass, box.restoring, 2.0 * pi / period_s, 0.0)[1]);
}

/// Of the triangles: 1 if equilateral, 0 if flat.
double worst_shape(const PanelHull& hull) {
  double worst = 1.0;
  for (std::size_t i = 0; i < hull.wetted_count; ++i) {
    const auto& c = hull.panels[i].corners_m;
    double squares = 0.0;
    for (std::size_t k = 0; k < 3; ++k) squares += glm::dot(c[(k + 1) % 3] - c[k], c[(k + 1) % 3] - c[k]);
    worst = std::min(worst, 4.0 * std::sqrt(3.0) * hull.panels[i].area_m2 / squares);
  }
  return worst;
}

// Fails if panels are lost, doubled or turned, or if a coarser hull displaces less.
TEST(PanelHullTest, PanelsCloseTheHull) {
  const TriangleMesh ship = test::ship(24.0);
  for (const TriangleMesh& mesh : {test::box({10.0, 4.0, 6.0}), test::ball(3.0, 5), ship}) {
    const double level_m = -0.3;
    const PanelHull hull = panel_hull(mesh, level_m, 250);
    const double images = static_cast<double>(hull.images.size());
    EXPECT_EQ(images, mesh.positions_m.size() == ship.positions_m.size() ? 2.0 : 4.0);
    EXPECT_NEAR(static_cast<double>(hull.wetted_count), 250.0 / std::sqrt(images), 25.0);
    double volume = 0.0, cover = 0.0;
    for (std::size_t i = 0; i < hull.panels.size(); ++i) {
      const Panel& panel = hull.panels[i];
      if (i < hull.wetted_count)
        volume += images / 3.0 * panel.area_m2 * glm::dot(panel.centre_m, panel.normal);
      else
        cover += images * panel.area_m2;
      EXPECT_LT(panel.centre_m.y, 0.0);
    }
    const Submerged below = submerged_below(mesh, level_m);
    EXPECT_NEAR(volume / below.volume_m3, 1.0, 1e-3);
    EXPECT_GT(cover, 0.6 * below.plane_m2);
    EXPECT_LT(cover, 1.05 * below.plane_m2);
  }
  EXPECT_THROW(panel_hull(test::box({1.0, 1.0, 1.0}), -0.6, 250), Error);
}

// Long faces, as those of a cylinder of few vertices, and large ones become panels of even shape. Fails if
// remeshing leaves thin panels, loses a crease, or cuts thin faces off at the water line: those gave pitch
// 26 % too small. Worst shape of these 0.7, limit 0.5.
TEST(PanelHullTest, PanelsAreEven) {
  const TriangleMesh column = mesh_shapes::make_cylinder(5.0, 20.0, {.u_cells = 3, .v_cells = 32}).mesh;
  for (const double level_m : {0.0, 9.9999}) {
    const PanelHull hull = panel_hull(column, level_m, 400);
    EXPECT_GT(worst_shape(hull), 0.5) << level_m;
    double bottom_m2 = 0.0;
    for (std::size_t i = 0; i < hull.wetted_count; ++i) {
      const Panel& panel = hull.panels[i];
      EXPECT_TRUE(panel.normal.y < -0.99 || std::abs(panel.normal.y) < 0.1) << panel.normal.y;
      if (panel.normal.y < -0.99) bottom_m2 += 4.0 * panel.area_m2;
    }
    // 8 chords of the bottom, 9 at the water line.
    EXPECT_NEAR(bottom_m2 / submerged_below(column, level_m).plane_m2, 1.0, 0.02);
  }
  EXPECT_GT(worst_shape(panel_hull(test::box({30.0, 6.0, 12.0}), 0.0, 300)), 0.5);
  EXPECT_GT(worst_shape(panel_hull(test::ship(24.0), -0.1, 250)), 0.5);
}

// On a surface rougher than the panels, edges that go back onto it get longer each time. Fails if they are
// then split without end.
TEST(PanelHullTest, RoughHullsHaveAboutAsManyPanels) {
  TriangleMesh rough = test::ball(3.0, 4);
  std::uint32_t random = 1;
  for (glm::dvec3& place : rough.positions_m) {
    random = 1664525u * random + 1013904223u;
    place *= 0.85 + 0.3 * random / 4294967296.0;
  }
  const PanelHull hull = panel_hull(rough, 2.0, 360);
  EXPECT_GT(hull.wetted_count, 250u);
  EXPECT_LT(hull.wetted_count, 500u);
}

// Fails if a plate gets a panel of its cover for each of its breadths, or a raft loses its thin sides.
TEST(PanelHullTest, ThinHullsHaveAboutAsManyPanels) {
  for (const auto& [sides_m, draught_m] :
       {std::pair(glm::dvec3(10.0, 4.0, 1e-3), 2.0), std::pair(glm::dvec3(10.0, 0.5, 10.0), 1e-4)}) {
    const PanelHull hull = panel_hull(test::box(sides_m), draught_m - 0.5 * sides_m.y, 270);
    EXPECT_GT(hull.wetted_count, 100u);
    EXPECT_LT(hull.panels.size(), 200u);
  }
}

// A floating hemisphere of radius a, of its displaced mass: heave 1 / 2 at infinity, 0.8764 at
// k a = 0.05 (Hulme 1982), surge 0.2732 at infinity and 1 / 2 at 0. Fails if an integral or the image is
// wrong. The mesh's own faces are the panels, without a coarser hull. Limit 4 %, for their constant sources.
TEST(PanelMethodTest, HemisphereAtTheEndsOfTheSpectrum) {
  const TriangleMesh ball = test::ball(5.0, 3);
  const double displaced = test::sea_density_kgpm3 * submerged_below(ball, 0.0).volume_m3;
  const HydrodynamicData data = data_of(ball, 0.0, {.panels = 720, .frequencies = 2});
  EXPECT_NEAR(data.added_mass_at_infinity[7] / displaced, 0.5, 0.02);
  EXPECT_NEAR(data.added_mass_at_infinity[0] / displaced, 0.2732, 0.011);
  // k a = 2 pi / 120: a little above the values at 0.
  EXPECT_NEAR(data.added_mass.front()[0] / displaced, 0.515, 0.02);
  EXPECT_NEAR(data.added_mass.front()[7] / displaced, 0.8764, 0.035);
}

// Data bases often lack the infinite frequency. Fails if the sum over the memory has a wrong sign or factor:
// then heave is off by a third. Off by MEASURED % (damping below, beyond and between the frequencies), limit
// 5 %.
TEST(PanelMethodTest, DampingGivesAddedMassAtInfinity) {
  const HydrodynamicData data = data_of(test::box({10.0, 10.0, 8.0}), 0.0);
  const HullMatrix found = added_mass_by_damping(data);
  for (const std::size_t motion : {0u, 1u, 3u}) {
    const double expected = data.added_mass_at_infinity[7 * motion];
    EXPECT_NEAR(found[7 * motion] / expected, 1.0, 0.05) << motion;
  }
}

// Haskind's relation and energy: the excitation by diffraction and the damping by pressure agree with what
// radiation and waves far away give. Fails if an irregular frequency is left, or a sign, or a factor.
// They differ by what panels cost: at most 10 % of the largest with 250 of them, 6 % with 1000 (measured on a
// cube, where Haskind's are the nearer ones); limit 14 %.
TEST(PanelMethodTest, HaskindAgreesWithDiffraction) {
  const TriangleMesh mesh = test::box({10.0, 10.0, 8.0});
  const HydrodynamicData by_waves = data_of(mesh, 0.0), direct = data_of(mesh, 0.0, {.is_direct = true});
  const auto worst_share = [](const auto& value, const auto& other, std::size_t count) {
    double worst = 0.0, most = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      worst = std::max(worst, std::abs(value(i) - other(i)));
      most = std::max(most, std::abs(value(i)));
    }
    return worst / most;
  };
  for (const std::size_t motion : {0u, 1u, 2u, 3u, 5u}) {
    const auto damping = [&](const HydrodynamicData& data) {
      return [&data, motion](std::size_t i) { return data.damping[i][7 * motion]; };
    };
    const auto excitation = [&](const HydrodynamicData& data) {
      return [&data, motion](std::size_t i) { return data.excitation[i][motion]; };
    };
    EXPECT_LT(worst_share(damping(by_waves), damping(direct), by_waves.damping.size()), 0.14) << motion;
    EXPECT_LT(worst_share(excitation(by_waves), excitation(direct), by_waves.excitation.size()), 0.07)
        << motion;
  }
  for (const HullMatrix& damping : by_waves.damping) {
    for (std::size_t motion = 0; motion < hull_motions; ++motion) EXPECT_GE(damping[7 * motion], 0.0);
  }
}

// Heave of a 10 m cube, metres per metre, of Capytaine 3.0. Fails if forces or phases are wrong. The limits
// of built-in data: 10 % away from the peak at 5.65 s and 30 % of the difference from 1; measured 1 % and 3
// %.
TEST(PanelMethodTest, CubeHeavesAsCapytaineSays) {
  const Loaded deep = loaded_box({10.0, 10.0, 10.0}, 5.0, 2.5);
  EXPECT_NEAR(heave_of(deep, 14.0), 1.010, 0.005);
  EXPECT_NEAR(heave_of(deep, 10.0), 1.048, 0.01);
  EXPECT_NEAR(heave_of(deep, 8.0), 1.158, 0.02);
  EXPECT_NEAR(heave_of(deep, 7.0), 1.377, 0.04);
  EXPECT_NEAR(heave_of(deep, 6.0), 2.640, 0.15);
  EXPECT_NEAR(heave_of(deep, 5.0), 0.853, 0.04);
  EXPECT_NEAR(heave_of(deep, 4.0), 0.114, 0.01);
  const Loaded shallow = loaded_box({10.0, 10.0, 10.0}, 2.0, 2.5);
  EXPECT_NEAR(heave_of(shallow, 10.0), 1.004, 0.005);
  EXPECT_NEAR(heave_of(shallow, 8.0), 1.015, 0.01);
  EXPECT_NEAR(heave_of(shallow, 6.0), 1.084, 0.02);
  EXPECT_NEAR(heave_of(shallow, 5.0), 1.284, 0.04);
}

// In long waves water is a plane that tilts and is accelerated down its slope s by g s: it turns a hull by
// s (C -+ g A), C its restoring force and A its added mass from sway to roll or surge to pitch. Fails if the
// moments of pressures are integrated at the panels' centres: 15 % too small in this ship's roll. The panels
// are 2 % deeper than the ship in the mean, which is 2 % of her roll; limit 4 %.
TEST(PanelMethodTest, LongWavesTurnAHullAsTiltedWaterDoes) {
  const TriangleMesh ship = test::ship(24.0);
  const double level_m = -0.1;
  const Submerged below = submerged_below(ship, level_m);
  const glm::dvec3 centre = below.centre_m + glm::dvec3(0.0, 0.3, 0.0);
  const HydrodynamicData data =
      panel_method(ship, level_m, centre, test::sea_density_kgpm3, gravity_mps2, {.frequencies = 2});
  const HullMatrix restoring = restoring_matrix(below, centre, centre, test::sea_density_kgpm3, gravity_mps2);
  const HullMatrix& added = data.added_mass.front();
  const double k = std::pow(data.frequencies_radps.front(), 2.0) / gravity_mps2;
  const auto turned = [&](double direction_rad, std::size_t motion) {
    // What is in phase with the slope, not with the height.
    return std::abs(excitation_at(data, data.frequencies_radps.front(), direction_rad)[motion].imag()) / k;
  };
  EXPECT_NEAR(turned(0.5 * pi, 3) / (restoring[7 * 3] + gravity_mps2 * added[2 * 6 + 3]), 1.0, 0.04);
  EXPECT_NEAR(turned(0.0, 5) / (restoring[7 * 5] - gravity_mps2 * added[0 * 6 + 5]), 1.0, 0.04);
}

// A(omega) = A at infinity - 1 / omega integral of K sin (Ogilvie 1964). Fails if the tail of B or a factor
// of K is wrong. Limit 4 % of the added mass; panels and the tail each give 1 to 2 %.
TEST(PanelMethodTest, RetardationFitsTheAddedMass) {
  const HydrodynamicData data = data_of(test::box({10.0, 10.0, 10.0}), 0.0);
  const double step_s = 0.05;
  const std::vector<HullMatrix> kernel = retardation(data, step_s, 1200);
  for (const std::size_t entry : {0u, 7u}) {
    for (const double frequency : {0.7, 1.0, 1.5}) {
      double sum = 0.0;
      for (std::size_t n = 1; n < kernel.size(); ++n) {
        sum += kernel[n][entry] * std::sin(frequency * step_s * static_cast<double>(n)) * step_s;
      }
      const double expected = added_mass_at(data, frequency)[entry];
      EXPECT_NEAR(data.added_mass_at_infinity[entry] - sum / frequency, expected,
                  0.04 * std::max(expected, data.added_mass_at_infinity[entry]))
          << entry << " " << frequency;
    }
  }
}

// A hull that is turned a quarter has its forces turned with it, so that surge is sway. Fails if the
// symmetric half or the directions are mixed up.
TEST(PanelMethodTest, TurnedHullHasTurnedForces) {
  const HydrodynamicData along = data_of(test::box({14.0, 6.0, 8.0}), 0.0),
                         across = data_of(test::box({8.0, 6.0, 14.0}), 0.0);
  const double frequency = 1.1;
  const HullMatrix a = added_mass_at(along, frequency), b = added_mass_at(across, frequency);
  for (const auto& [one, other] :
       {std::pair(0u, 2u), std::pair(1u, 1u), std::pair(2u, 0u), std::pair(3u, 5u)}) {
    EXPECT_NEAR(a[7 * one] / b[7 * other], 1.0, 0.05) << one;
  }
  const HullWrench head = excitation_at(along, frequency, 0.0),
                   beam = excitation_at(across, frequency, 0.5 * pi);
  EXPECT_LT(std::abs(head[0] - beam[2]), 0.05 * std::abs(head[0]));
  EXPECT_LT(std::abs(head[1] - beam[1]), 0.05 * std::abs(head[1]));
  EXPECT_LT(std::abs(head[5] + beam[3]), 0.08 * std::abs(head[5]));
}

}  // namespace
}  // namespace offing::bodies
