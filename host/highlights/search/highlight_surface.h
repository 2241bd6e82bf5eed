#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/triangle_mesh.h"
#include "host/ocl/buffer.h"

namespace offing::highlights {

/// Which vertices are one place, and which faces meet there. Nothing is assumed of the neighbourhood: an edge
/// may have any number of faces.
class VertexLinks {
 public:
  /// Vertices no farther apart than `distance_m` are one place (copies along a texture's seams, components
  /// that touch), in chains too; 0 joins equal positions only.
  VertexLinks(const TriangleMesh& mesh, double distance_m);

  std::size_t place_count() const { return first_face_.size() - 1; }
  std::uint32_t place_of(std::uint32_t vertex) const { return places_[vertex]; }
  /// Faces with a corner at a place, ascending; one with two corners there is named twice.
  std::span<const std::uint32_t> faces_at(std::uint32_t place) const {
    return std::span(faces_).subspan(first_face_[place], first_face_[place + 1] - first_face_[place]);
  }

 private:
  std::vector<std::uint32_t> places_;      // [vertices]
  std::vector<std::uint32_t> first_face_;  // [places + 1]
  std::vector<std::uint32_t> faces_;       // [3 faces]
};

/// How a mesh is prepared before highlights are searched on it.
struct SurfaceOptions {
  /// Rounds in which each normal becomes the mean of itself and those around: fewer highlights on noisy
  /// scans.
  int smoothing_rounds = 0;
  /// Vertices this near are one place, as a share of the diagonal of the mesh's box.
  double touching_share = 1e-6;
};

/// A mesh as highlights need it, on the host and on a device. Normals are those of the mesh, whatever their
/// length, or where it has none, of the faces around each place, weighted by their angles there. Where these
/// cancel it is that of the largest face; only vertices without any have none.
class HighlightSurface {
 public:
  /// Throws Error(bad_input) if curvatures or normals do not match the vertices, if a face names a vertex
  /// that is not there, if a number is not finite, or if the mesh has no vertices; Error(out_of_memory) if it
  /// does not fit.
  HighlightSurface(const ocl::Device& device, TriangleMesh mesh, VertexCurvatures curvatures,
                   const SurfaceOptions& options = {});

  /// The same faces with their vertices elsewhere, as a skinned mesh has them every frame. Normals that are
  /// empty follow from the faces. What touches what stays as it was. Throws as the constructor does.
  void deform(std::vector<glm::dvec3> positions_m, std::vector<glm::dvec3> normals,
              VertexCurvatures curvatures);

  const TriangleMesh& mesh() const { return mesh_; }  ///< normals as they are used
  /// Where the vertices were before they were deformed.
  const std::vector<glm::dvec3>& positions_at_rest_m() const {
    return at_rest_m_.empty() ? mesh_.positions_m : at_rest_m_;
  }
  const VertexCurvatures& curvatures() const { return curvatures_; }
  std::uint64_t revision() const { return revision_; }  ///< how often it was deformed
  const VertexLinks& links() const { return links_; }
  const ocl::Device& device() const { return device_; }
  const std::vector<glm::dvec3>& face_normals() const {
    return face_normals_;
  }                                                         ///< unit, or zero without an area
  const glm::dvec3& middle_m() const { return middle_m_; }  ///< the mean of the vertices
  double diagonal_m() const { return diagonal_m_; }         ///< of the box along the axes
  double mean_edge_m() const { return mean_edge_m_; }

  // As the kernels read them (kernels/shared/highlights.h).
  const ocl::Buffer<float>& vertex_rows() const { return vertex_rows_; }
  const ocl::Buffer<std::int32_t>& face_rows() const { return face_rows_; }
  int pitch() const { return pitch_; }  ///< vertices from row to row, a multiple of 16

 private:
  void measure();
  void set_normals();
  void upload_vertices();
  void upload_faces();

  ocl::Device device_;
  int smoothing_rounds_;
  std::uint64_t revision_ = 0;
  TriangleMesh mesh_;
  std::vector<glm::dvec3> at_rest_m_;  // none: it was never deformed
  VertexCurvatures curvatures_;
  std::vector<glm::dvec3> face_normals_;
  glm::dvec3 middle_m_{0.0};
  double diagonal_m_ = 0.0, mean_edge_m_ = 0.0;
  VertexLinks links_;
  int pitch_ = 0;
  ocl::Buffer<float> vertex_rows_;
  ocl::Buffer<std::int32_t> face_rows_;
};

}  // namespace offing::highlights
