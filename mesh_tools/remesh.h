#pragma once

#include <optional>
#include <string_view>

#include "host/base/log.h"
#include "host/base/triangle_mesh.h"
#include "host/base/work.h"

namespace offing::mesh_tools {

struct RemeshSettings {
  double edge_m = 0.0;  ///< length that edges should have
  int rounds = 3;       ///< of splitting, collapsing, flipping and smoothing
  /// Edges between faces whose normals differ by more stay where they are, as polylines.
  std::optional<double> sharp_rad = std::nullopt;
};

/// A mesh of the same surface with edges of about one length (Botsch and Kobbelt 2004, as CGAL's
/// isotropic_remeshing). Borders stay where they are, as polylines. The mesh must be a manifold, else
/// Error(bad_input) names the file. Throws Error(cancelled) between rounds when asked to stop.
TriangleMesh remesh(const TriangleMesh& mesh, std::string_view file_name, const RemeshSettings& settings,
                    const CancelToken& cancel, Verbosity verbosity);

/// How many faces edges of this length make at most, about: by the area, and by edges of the mesh that are
/// cut.
double most_faces_at(const TriangleMesh& mesh, double edge_m);

/// The edge length at which equilateral triangles of its area are so many.
double edge_length_for(const TriangleMesh& mesh, double faces);

}  // namespace offing::mesh_tools
