// SPDX-License-Identifier: GPL-3.0-or-later (CGAL)
#pragma once

#include <string_view>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "host/base/triangle_mesh.h"

namespace offing::mesh_tools {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

/// The mesh as CGAL's half-edges: vertices and faces keep their numbers. Throws as require_manifold().
Surface to_surface(const TriangleMesh& mesh, std::string_view file_name);

/// Back, without what has been removed and without normals. Faces of more than three corners are not allowed.
TriangleMesh to_mesh(const Surface& surface);

}  // namespace offing::mesh_tools
