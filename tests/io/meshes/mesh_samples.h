#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "host/io/meshes/mesh_file.h"

namespace offing::test {

/// A small file of a format, one of the fuzzers' corpus.
struct MeshSample {
  std::string format, name, bytes;
};

/// gltf, obj, off, ply and stl in all their kinds.
std::vector<MeshSample> mesh_samples();
MeshSample mesh_sample(const std::string& format, const std::string& name);

/// What the reader of a format makes of bytes.
MeshFile parse_mesh(std::string_view format, std::string_view bytes);

/// How many of something the file had and the mesh has not.
std::size_t left_out(const MeshFile& file, std::string_view what);

/// A closed mesh of random triangles: a sphere-like graph of `rings` x `sectors` vertices with random radii,
/// so that no coordinate has a short decimal form.
TriangleMesh random_mesh(unsigned seed, unsigned rings = 5, unsigned sectors = 7);

}  // namespace offing::test
