// Curvatures against those of the smooth surfaces that meshes were made from.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_tools/curvature/curvature.h"
#include "tests/mesh_tools/curvature/accuracy.h"

namespace offing::mesh_tools {
namespace {

using namespace mesh_shapes;

using testing::Each;
using testing::Lt;

VertexCurvatures measured(const TriangleMesh& mesh, CurvatureMethod method) {
  return vertex_curvatures(mesh, {.method = method}).curvatures;
}

struct Gate {
  CurvatureMethod method;
  // Of ellipsoid, torus, noisy torus, saddle: curvature %, direction degrees.
  double curvature_percent[4], direction_deg[4];
};

class CurvatureAccuracy : public testing::TestWithParam<Gate> {};

// Each method on meshes with jittered vertices and random diagonals, one with noise, one with a border. Gates
// are a tenth above what is measured: a weight or a sign that is wrong costs several times that. Measured
// (recorded as ..._percent_deg, %/degrees): fit 0.32/0.20, 0.21/0.16, 0.36/0.11, 0.22/0.03; tensor 0.88/0.62,
// 1.12/1.12, 2.03/1.49, 0.91/0.20; tensor-exact 1.04/0.82, 1.03/1.10, 2.14/1.42, 1.81/0.28; diffused
// 0.46/0.52, 0.93/1.24, 3.24/1.68, 0.78/0.23; jet 0.38/0.24, 1.07/0.38, 6.02/1.84, 0.51/0.10.
TEST_P(CurvatureAccuracy, ComesNearTheSmoothSurface) {
  const Gate& gate = GetParam();
  std::size_t index = 0;
  for (const test::NamedShape& named : test::comparison_shapes()) {
    const auto errors = test::errors_of(measured(named.shape.mesh, gate.method), *named.shape.truth);
    RecordProperty(fmt::format("{}_percent_deg", named.name),
                   fmt::format("{:.2f}/{:.2f}", 100.0 * errors.curvature, errors.direction_deg));
    EXPECT_LE(100.0 * errors.curvature, gate.curvature_percent[index]) << named.name;
    EXPECT_LE(errors.direction_deg, gate.direction_deg[index]) << named.name;
    ++index;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Methods, CurvatureAccuracy,
    testing::Values(Gate{CurvatureMethod::fit, {0.36, 0.24, 0.4, 0.25}, {0.23, 0.18, 0.13, 0.04}},
                    Gate{CurvatureMethod::tensor, {1.0, 1.25, 2.25, 1.0}, {0.7, 1.25, 1.65, 0.23}},
                    Gate{CurvatureMethod::tensor_exact, {1.15, 1.15, 2.4, 2.0}, {0.9, 1.25, 1.6, 0.32}},
                    Gate{CurvatureMethod::diffused, {0.52, 1.05, 3.6, 0.87}, {0.6, 1.4, 1.85, 0.26}},
                    Gate{CurvatureMethod::jet, {0.45, 1.2, 6.6, 0.57}, {0.27, 0.42, 2.05, 0.12}}),
    [](const auto& instance) {
      std::string name(name_of(instance.param.method));
      std::ranges::replace(name, '-', '_');
      return name;
    });

/// A scan's faults: of a face in 333, one corner lies beyond its other side, so that the face is folded over.
TriangleMesh with_folds(TriangleMesh mesh) {
  for (std::size_t i = 0; i < mesh.faces.size(); i += 333) {
    const auto& [a, b, c] = mesh.faces[i];
    std::vector<glm::dvec3>& p = mesh.positions_m;
    const glm::dvec3 side = glm::normalize(p[b] - p[a]), way = p[c] - p[a];
    p[c] -= 1.5 * (way - glm::dot(way, side) * side);
  }
  return mesh;
}

/// Root of the mean square, over the larger true curvature, of both curvatures.
double rms_percent(const VertexCurvatures& found, const VertexCurvatures& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.k_max_per_m.size(); ++i) {
    const double k_max = truth.k_max_per_m[i], k_min = truth.k_min_per_m[i];
    const double size = std::max(std::abs(k_max), std::abs(k_min));
    const double off_max = (found.k_max_per_m[i] - k_max) / size;
    const double off_min = (found.k_min_per_m[i] - k_min) / size;
    sum += 0.5 * (off_max * off_max + off_min * off_min);
  }
  return 100.0 * std::sqrt(sum / static_cast<double>(truth.k_max_per_m.size()));
}

enum class Faults { none, folds };

/// Of the default method on a shape with this noise, in edges.
template <class Make>
double scan_error_percent(const Make& make, double noise, Faults faults = Faults::none) {
  const Shape clean = make(Roughness{.jitter = 0.25, .seed = 7});
  const TriangleMesh mesh = make(Roughness{.jitter = 0.25, .normal_noise = noise, .seed = 7}).mesh;
  return rms_percent(vertex_curvatures(faults == Faults::folds ? with_folds(mesh) : mesh).curvatures,
                     *clean.truth);
}

// Noise of 2 % of an edge, and folds. Fails if the default takes either for the surface: a ball of 3.5 edges
// makes noise of 2 % seventeen times the clean error, one of 11 edges everywhere leaves 14 % on a head.
// Measured (clean, folds, both): ellipsoid 0.44, 0.55, 0.83; torus 0.27, 0.41, 0.59; head 5.4, 5.7, 5.2.
TEST(CurvatureOfScans, DefaultsStayWithinThreeTimesTheCleanError) {
  const auto expect_robust = [](const std::string& name, double most, const auto& make) {
    const double least = scan_error_percent(make, 0.0), folded = scan_error_percent(make, 0.0, Faults::folds);
    const double both = scan_error_percent(make, 0.02, Faults::folds);
    testing::Test::RecordProperty(name, fmt::format("{:.3f} {:.3f} {:.3f}", least, folded, both));
    EXPECT_LE(folded, most * least) << name;
    EXPECT_LE(both, most * least) << name;
  };
  expect_robust("ellipsoid", 3.0, [](const Roughness& r) { return make_ellipsoid({1.0, 0.75, 0.5}, 5, r); });
  expect_robust("torus", 3.0, [](const Roughness& r) {
    return make_torus(1.0, 0.4, {160, 64, Diagonals::random}, r);
  });
  expect_robust("head", 1.2, [](const Roughness& r) { return make_head(1.0, 5, r); });
}

// At a border half of a ball is empty: one of 9 edges leaves six times the clean error. A folded face there is
// most of the faces around its corners: by these alone, its neighbours are taken for folded, and the error is
// 294 %. Measured 0.52; 1.40, 0.56 and 1.48 %.
TEST(CurvatureOfScans, BordersStayWithinThreeTimesTheCleanError) {
  const auto saddle = [](const Roughness& r) { return make_saddle(1.0, {100, 100, Diagonals::random}, r); };
  const double most = 3.0 * scan_error_percent(saddle, 0.0);
  EXPECT_LE(scan_error_percent(saddle, 0.02), most);
  EXPECT_LE(scan_error_percent(saddle, 0.0, Faults::folds), most);
  EXPECT_LE(scan_error_percent(saddle, 0.02, Faults::folds), most);
}

// A fit is exact on spheres, so that there is no clean error to compare with. Measured 0.68 %.
TEST(CurvatureOfScans, NoiseOnASphereIsAveragedOut) {
  EXPECT_LE(scan_error_percent([](const Roughness& r) { return make_sphere(1.0, 5, r); }, 0.02), 1.0);
}

double mean_error_on_sphere(int level, CurvatureMethod method) {
  const Shape sphere = make_sphere(2.0, level);
  return test::errors_of(measured(sphere.mesh, method), *sphere.truth).curvature;
}

// 2.5 k, 10 k and 41 k vertices. Fails if a bias is left that finer meshes do not remove: regions counted by
// other edges than areas. The error of a region of fixed edges falls with the square of the edge; irregular
// corners of an icosphere, twelve whatever the level, leave a little less than that.
TEST(CurvatureConvergence, ErrorsFallAsSpheresAreRefined) {
  for (const CurvatureMethod method :
       {CurvatureMethod::fit, CurvatureMethod::tensor, CurvatureMethod::diffused, CurvatureMethod::jet}) {
    const double coarse = mean_error_on_sphere(4, method), fine = mean_error_on_sphere(5, method),
                 finest = mean_error_on_sphere(6, method);
    // The fit is right on spheres but for the normals' errors, which are rounding soon.
    EXPECT_LT(fine, 0.6 * coarse + 1e-7) << name_of(method);
    EXPECT_LT(finest, 0.6 * fine + 1e-7) << name_of(method);
    EXPECT_LT(finest, 1e-3) << name_of(method);
  }
  EXPECT_LT(mean_error_on_sphere(6, CurvatureMethod::tensor_exact), 0.02);
}

// The bias of the print, which docs/meshes.md states: edges on the rim of the region count in full though
// half of what they bend lies outside. Fails if `paper` is repaired by mistake, or gets worse. Measured 7.2
// and 8.6 %.
TEST(CurvatureConvergence, ThePrintKeepsItsBias) {
  for (const int level : {4, 6}) {
    const double error = mean_error_on_sphere(level, CurvatureMethod::paper);
    EXPECT_GT(error, 0.05) << level;
    EXPECT_LT(error, 0.12) << level;
  }
}

// Angles without a sign make every saddle a dome: curvatures there are off by more than themselves.
TEST(CurvatureConvergence, UnsignedAnglesLoseConcaveParts) {
  const test::NamedShape saddle = test::jittered_saddle();
  const auto errors = [&](EdgeAngles angles) {
    const CurvatureOptions options{.method = CurvatureMethod::paper, .angles = angles};
    return test::errors_of(vertex_curvatures(saddle.shape.mesh, options).curvatures, *saddle.shape.truth);
  };
  EXPECT_LT(errors(EdgeAngles::with_sign).curvature, 0.1);
  EXPECT_GT(errors(EdgeAngles::unsigned_as_printed).curvature, 0.5);
}

struct IntegralCase {
  test::NamedShape named;
  double expected;  ///< of the Gaussian curvature over the surface
};

// Gauss and Bonnet: on a closed surface the integral is 2 pi times Euler's characteristic; on the saddle that
// of the smooth surface over the same vertices, borders left out. Fails if curvature is lost or found anew,
// as where regions' edges lean out of the tangent plane. The bound is 2 % of the absolute integral; measured
// at most 1.96 %.
TEST(CurvatureIntegral, IsThatOfTheTopology) {
  std::vector<IntegralCase> cases{{test::jittered_ellipsoid(), 4.0 * std::numbers::pi},
                                  {test::jittered_torus(), 0.0},
                                  {test::noisy_torus(), 0.0}};
  for (const IntegralCase& closed : cases) {
    for (const CurvatureMethod method :
         {CurvatureMethod::fit, CurvatureMethod::tensor, CurvatureMethod::tensor_exact,
          CurvatureMethod::diffused, CurvatureMethod::jet}) {
      const VertexCurvatures found = measured(closed.named.shape.mesh, method);
      double sum = 0.0, absolute = 0.0;
      for (std::size_t i = 0; i < found.area_m2.size(); ++i) {
        const double part = found.k_max_per_m[i] * found.k_min_per_m[i] * found.area_m2[i];
        sum += part;
        absolute += std::abs(part);
      }
      EXPECT_LE(std::abs(sum - closed.expected), 0.02 * absolute)
          << closed.named.name << " " << name_of(method);
    }
  }
}

TEST(CurvatureIntegral, IsThatOfTheSaddleWithinItsBorder) {
  const Shape saddle = test::jittered_saddle().shape;
  const VertexCurvatures& truth = *saddle.truth;
  for (const CurvatureMethod method :
       {CurvatureMethod::fit, CurvatureMethod::tensor, CurvatureMethod::tensor_exact,
        CurvatureMethod::diffused, CurvatureMethod::jet}) {
    const VertexCurvatures found = measured(saddle.mesh, method);
    double sum = 0.0, absolute = 0.0, expected = 0.0;
    for (std::size_t i = 0; i < found.area_m2.size(); ++i) {
      const glm::dvec3& p = saddle.mesh.positions_m[i];
      if (std::max(std::abs(p.x), std::abs(p.y)) > 1.0 - 1e-9) continue;
      const double part = found.k_max_per_m[i] * found.k_min_per_m[i] * found.area_m2[i];
      sum += part;
      absolute += std::abs(part);
      expected += truth.k_max_per_m[i] * truth.k_min_per_m[i] * found.area_m2[i];
    }
    EXPECT_LE(std::abs(sum - expected), 0.02 * absolute) << name_of(method);
  }
}

// Fails if a sign or an order is swapped: a ball in metres, seen from outside, bends by 1 / r both ways.
TEST(CurvatureConvention, ConvexIsPositiveInOneOverMetres) {
  const Shape sphere = make_sphere(4.0, 4);
  for (const CurvatureMethod method :
       {CurvatureMethod::fit, CurvatureMethod::tensor, CurvatureMethod::tensor_exact, CurvatureMethod::paper,
        CurvatureMethod::diffused, CurvatureMethod::jet}) {
    const CurvatureResult result = vertex_curvatures(sphere.mesh, {.method = method});
    for (std::size_t i = 0; i < result.normals.size(); ++i) {
      ASSERT_NEAR(result.curvatures.k_max_per_m[i], 0.25, 0.05) << name_of(method);
      ASSERT_GE(result.curvatures.k_max_per_m[i], result.curvatures.k_min_per_m[i]) << name_of(method);
      ASSERT_GT(glm::dot(result.normals[i], sphere.mesh.normals[i]), 0.999) << name_of(method);
      const glm::dvec3 across = glm::cross(result.curvatures.e_max[i], result.curvatures.e_min[i]);
      ASSERT_LT(glm::distance(across, result.normals[i]), 1e-9) << name_of(method);
    }
    // A sphere prefers no direction.
    EXPECT_THAT(result.curvatures.confidence, Each(Lt(0.1))) << name_of(method);
  }
}

}  // namespace
}  // namespace offing::mesh_tools
