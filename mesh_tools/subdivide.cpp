#include "mesh_tools/subdivide.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/Traits.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/vector_cast.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>
#include <fmt/format.h>

#include "host/base/error.h"
#include "mesh_tools/mesh_defects.h"

namespace offing::mesh_tools {

namespace {

// The names are OpenMesh's.
struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Triangles = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;
using Polygons = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;

/// OpenMesh leaves out what it cannot hold with a line on stderr: all must be there.
template <typename Mesh>
Mesh to_open_mesh(const TriangleMesh& mesh, std::string_view file_name) {
  require_manifold(mesh, file_name);
  Mesh result;
  std::vector<typename Mesh::VertexHandle> vertices;
  for (const glm::dvec3& p : mesh.positions_m)
    vertices.push_back(result.add_vertex(OpenMesh::Vec3d(p.x, p.y, p.z)));
  for (const TriangleIndices& face : mesh.faces) {
    result.add_face(vertices[face[0]], vertices[face[1]], vertices[face[2]]);
  }
  if (result.n_faces() != mesh.faces.size()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected {} faces that OpenMesh can join, got {}", one_line(file_name),
                            mesh.faces.size(), result.n_faces()),
                "repair it with `offing-mesh repair`");
  }
  return result;
}

/// Faces of more corners as fans: of a quadrilateral two triangles.
template <typename Mesh>
TriangleMesh to_mesh(const Mesh& mesh) {
  TriangleMesh result;
  for (const auto vertex : mesh.vertices()) {
    const OpenMesh::Vec3d& p = mesh.point(vertex);
    result.positions_m.emplace_back(p[0], p[1], p[2]);
  }
  std::vector<std::uint32_t> corners;
  for (const auto face : mesh.faces()) {
    corners.clear();
    for (const auto vertex : mesh.fv_range(face)) corners.push_back(static_cast<std::uint32_t>(vertex.idx()));
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      result.faces.push_back({corners[0], corners[i], corners[i + 1]});
    }
  }
  return result;
}

/// Vertices of no face, which smoothing would move to where nothing is, kept out of a mesh.
class LooseVertices {
 public:
  explicit LooseVertices(const TriangleMesh& mesh) : positions_m_(mesh.positions_m) {
    std::vector<std::uint8_t> is_used(positions_m_.size(), 0);
    for (const TriangleIndices& face : mesh.faces) {
      for (const std::uint32_t corner : face) is_used[corner] = 1;
    }
    number_without_.resize(positions_m_.size());
    for (std::uint32_t i = 0; i < positions_m_.size(); ++i) {
      number_without_[i] = static_cast<std::uint32_t>(used_.size());
      if (is_used[i] != 0) used_.push_back(i);
    }
    without_.faces = mesh.faces;
    for (const std::uint32_t vertex : used_) without_.positions_m.push_back(positions_m_[vertex]);
    for (TriangleIndices& face : without_.faces) {
      for (std::uint32_t& corner : face) corner = number_without_[corner];
    }
  }

  const TriangleMesh& mesh_without() const { return without_; }

  /// Vertices that the mesh had have their numbers again; new ones come after all of them.
  TriangleMesh put_back(const TriangleMesh& fine) const {
    const std::size_t loose = positions_m_.size() - used_.size();
    TriangleMesh all{.positions_m = positions_m_, .normals = {}, .faces = fine.faces};
    for (std::size_t i = 0; i < used_.size(); ++i) all.positions_m[used_[i]] = fine.positions_m[i];
    all.positions_m.insert(all.positions_m.end(),
                           fine.positions_m.begin() + static_cast<std::ptrdiff_t>(used_.size()),
                           fine.positions_m.end());
    for (TriangleIndices& face : all.faces) {
      for (std::uint32_t& corner : face) {
        corner = corner < used_.size() ? used_[corner] : corner + static_cast<std::uint32_t>(loose);
      }
    }
    return all;
  }

 private:
  const std::vector<glm::dvec3>& positions_m_;
  std::vector<std::uint32_t> used_, number_without_;
  TriangleMesh without_;
};

template <typename Mesh, typename Subdivider>
TriangleMesh refine(const TriangleMesh& mesh, std::string_view file_name, int levels,
                    const CancelToken& cancel) {
  const LooseVertices loose(mesh);
  Mesh fine = to_open_mesh<Mesh>(loose.mesh_without(), file_name);
  Subdivider subdivider;
  for (int level = 0; level < levels; ++level) {
    cancel.throw_if_cancelled();
    subdivider.attach(fine);
    subdivider(1);
    subdivider.detach();
  }
  return loose.put_back(to_mesh(fine));
}

double faces_after(const TriangleMesh& mesh, SubdivisionMethod method, int levels) {
  const auto faces = static_cast<double>(mesh.faces.size());
  switch (method) {
    case SubdivisionMethod::sqrt3:
      return faces * std::pow(3.0, levels);
    case SubdivisionMethod::catmull_clark:
      return levels == 0 ? faces : 6.0 * faces * std::pow(4.0, levels - 1);
    case SubdivisionMethod::loop:
    case SubdivisionMethod::butterfly:
      break;
  }
  return faces * std::pow(4.0, levels);
}

}  // namespace

TriangleMesh subdivide(const TriangleMesh& mesh, std::string_view file_name, SubdivisionMethod method,
                       int levels, const CancelToken& cancel) {
  namespace uniform = OpenMesh::Subdivider::Uniform;
  constexpr double most_faces = 2147483648.0;  // OpenMesh counts in 32 bits, half-edges less
  if (faces_after(mesh, method, levels) > most_faces / 6.0) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("--levels: expected a mesh of less than 3.5e8 faces, got {:.3g}",
                            faces_after(mesh, method, levels)),
                "choose fewer levels");
  }
  switch (method) {
    case SubdivisionMethod::sqrt3:
      return refine<Triangles, uniform::Sqrt3T<Triangles, double>>(mesh, file_name, levels, cancel);
    case SubdivisionMethod::butterfly:
      return refine<Triangles, uniform::ModifiedButterflyT<Triangles, double>>(mesh, file_name, levels,
                                                                               cancel);
    case SubdivisionMethod::catmull_clark:
      return refine<Polygons, uniform::CatmullClarkT<Polygons, double>>(mesh, file_name, levels, cancel);
    case SubdivisionMethod::loop:
      break;
  }
  return refine<Triangles, uniform::LoopT<Triangles, double>>(mesh, file_name, levels, cancel);
}

}  // namespace offing::mesh_tools
