#pragma once

#include "host/base/cloud_volume.h"
#include "host/base/triangle_mesh.h"

namespace offing::clouds {

/// How a closed mesh becomes a cloud (C14, C15).
struct MeshVolumeOptions {
  double cell_m = 1.0;
  double thickness_m = 4.0;  ///< how deep below the surface density has risen to 1
  double fluff_m = 2.0;      ///< how far beyond the surface it begins
};

/// Density of a cloud in the shape of a mesh, in the mesh's axes, as CloudParameters::shape takes it: smooth
/// from 0 at fluff_m outside the surface to 1 at thickness_m inside it, 0.5 half way between. Distances are
/// those between middles of cells inside and outside, half a cell right. Meshes need not be perfect: see
/// mesh_inside.h.
/// Throws Error(bad_input) for options out of range, faces that name no vertex, a mesh that encloses no cell,
/// and a grid of more than 2^27 cells.
CloudVolume mesh_volume(const TriangleMesh& mesh, const MeshVolumeOptions& options);

}  // namespace offing::clouds
