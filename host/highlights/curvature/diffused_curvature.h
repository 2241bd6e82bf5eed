#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/base/triangle_mesh.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"

namespace offing::highlights {

/// One float4 of the device.
using Float4 = std::array<float, 4>;

/// Curvatures of a mesh that deforms: the angles of edges around each vertex, averaged with neighbours for
/// some rounds, as method `diffused` of `offing-mesh curvature` has it, fast enough for every frame. Which
/// faces there are stays as it is; a vertex that shares its position with others in the mesh is one with them
/// for good.
///
/// Single precision: an angle is right to 1e-6 rad, so that curvatures are within some 1e-6 over an edge's
/// length. Degenerate faces, borders, edges of three faces and vertices of none give finite answers, as
/// described in VertexCurvatures.
class DiffusedCurvature {
 public:
  /// Throws Error(bad_usage) for rounds outside 0 ... 1000 and a mesh without faces, Error(bad_input) for
  /// faces that name no vertex, and what programs and buffers throw.
  DiffusedCurvature(const ocl::Device& device, const TriangleMesh& mesh, int rounds = 3);

  /// Enqueues the curvatures of these positions: [vertices][3], metres, finite. Throws Error(bad_usage) for
  /// another size.
  void at(const ocl::Buffer<float>& positions_m);

  /// The same, read back, wherever and however large the mesh is: the device gets positions about their mean,
  /// scaled by a power of two. They are rounded to 2^-24 of the mesh's size.
  VertexCurvatures of(const std::vector<glm::dvec3>& positions_m);

  std::size_t vertex_count() const { return first_.size(); }
  /// Of the last at(), all [vertices]: (k_max, k_min in 1/m, area m2, confidence); (e_max, 0); (normal, 0).
  const ocl::Buffer<Float4>& curvatures() const { return curvatures_; }
  const ocl::Buffer<Float4>& e_max() const { return e_max_; }
  const ocl::Buffer<Float4>& normals() const { return normals_; }

  /// Waits for the last at().
  VertexCurvatures read() const;

 private:
  ocl::Device device_;
  int rounds_;
  ocl::Kernel face_kernel_, ring_kernel_, average_kernel_, principal_kernel_;
  ocl::Buffer<std::uint32_t> corners_, first_, faces_begin_, faces_, edges_begin_, neighbours_;
  ocl::Buffer<std::array<std::int32_t, 2>> sides_;
  ocl::Buffer<std::uint8_t> on_border_;
  ocl::Buffer<std::array<float, 8>> shares_, averaged_;
  ocl::Buffer<float> positions_m_;  // of of()
  ocl::Buffer<Float4> face_normals_, ring_normals_, curvatures_, e_max_, normals_;
};

/// DiffusedCurvature::of() of a mesh that stays as it is. Throws what DiffusedCurvature() throws.
VertexCurvatures diffused_curvatures(const ocl::Device& device, const TriangleMesh& mesh, int rounds = 3);

}  // namespace offing::highlights
