// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/highlights/curvature/diffused_curvature.h"
#include "host/mesh_shapes/shape.h"
#include "mesh_tools/curvature/curvature.h"
#include "tests/bench/benches.h"
#include "tests/mesh_tools/curvature/accuracy.h"

namespace offing::bench {
namespace {

using mesh_tools::CurvatureMethod;

/// A torus of n x n / 2 vertices with noise, as scans have.
mesh_shapes::Shape noisy_torus(int size) {
  return mesh_shapes::make_torus(1.0, 0.4, {size, size / 2, mesh_shapes::Diagonals::random},
                                 {.jitter = 0.3, .normal_noise = 0.02, .seed = 7});
}

/// Both sides must have measured the same surface: throws Error(device) where the mean error is above a fifth
/// of the curvature. Noise that is a share of the edges bends finer meshes more: a tenth at n = 2048.
void require_sound(const std::string& name, const mesh_shapes::Shape& shape, const VertexCurvatures& found) {
  const double error = test::errors_of(found, *shape.truth).curvature;
  if (error < 0.2) return;
  throw Error(ErrorKind::device,
              fmt::format("{}: expected a mean error below 20 %, found {:.1f} %", name, 100.0 * error),
              "run the tests of this device: ctest -L quick");
}

void bench_size(const ocl::Device& device, int size, const Settings& settings, const Sinks& sinks) {
  const mesh_shapes::Shape shape = noisy_torus(size);
  const mesh_tools::UnitMesh mesh = mesh_tools::unit_mesh(shape.mesh);
  const auto measuring = [&](CurvatureMethod method, int threads) -> Work {
    return [&mesh, method, threads] {
      mesh_tools::vertex_curvatures(mesh, {.method = method, .threads = threads});
    };
  };
  const auto jet_error = test::errors_of(
      mesh_tools::vertex_curvatures(mesh, {.method = CurvatureMethod::jet}).curvatures, *shape.truth);
  // One core each; then ours on all of them, against the same peer.
  const Work peer = measuring(CurvatureMethod::jet, 1);
  for (const int threads : {1, 0}) {
    for (const CurvatureMethod method :
         {CurvatureMethod::fit, CurvatureMethod::tensor, CurvatureMethod::diffused}) {
      const VertexCurvatures found = mesh_tools::vertex_curvatures(mesh, {.method = method}).curvatures;
      const std::string name =
          fmt::format("curvature_{}{}", mesh_tools::name_of(method), threads == 0 ? "_all_cores" : "");
      require_sound(name, shape, found);
      const auto error = test::errors_of(found, *shape.truth);
      const std::string errors = fmt::format("CGAL jet fitting, one core; errors {:.1f} % and {:.1f} %",
                                             100.0 * error.curvature, 100.0 * jet_error.curvature);
      sinks.row(row_of(name, size, errors, compare(measuring(method, threads), peer, settings.blocks)));
    }
  }

  std::vector<float> coordinates;
  for (const glm::dvec3& p : shape.mesh.positions_m) {
    for (int axis = 0; axis < 3; ++axis) coordinates.push_back(static_cast<float>(p[axis]));
  }
  const ocl::Buffer<float> positions_m(device, coordinates, "positions");
  highlights::DiffusedCurvature on_device(device, shape.mesh);
  on_device.at(positions_m);
  require_sound("curvature_opencl", shape, on_device.read());
  std::vector<highlights::Float4> first(1);
  const Work ours = [&] {
    on_device.at(positions_m);
    on_device.curvatures().read(first);  // waits
  };
  sinks.row(
      row_of("curvature_opencl", size, "CGAL jet fitting, one core", compare(ours, peer, settings.blocks)));
}

}  // namespace

void bench_curvature(const ocl::Device& device, const Settings& settings, const Sinks& sinks) {
  for (const int size : settings.sizes) bench_size(device, size, settings, sinks);
}

}  // namespace offing::bench
