#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "host/base/triangle_mesh.h"
#include "host/io/atomic_file.h"

namespace offing {

/// Numbers that vertices have besides position and normal.
struct VertexProperty {
  std::string name;                ///< as in a PLY: letters, digits, _
  std::span<const double> values;  ///< [vertices]; written as floats
};

using Colour8 = std::array<std::uint8_t, 3>;  ///< red, green, blue, sRGB

/// What a PLY holds beside the mesh itself.
struct VertexAttributes {
  std::vector<VertexProperty> properties;  ///< in this order
  std::span<const Colour8> colours;        ///< [vertices], or none
  std::vector<std::string> comments;       ///< lines
};

/// Writes a binary little-endian PLY: x y z (floats if they hold all positions exactly, else doubles), nx ny
/// nz if the mesh has normals, the properties, red green blue. Atomic; the same mesh gives the same bytes.
/// Throws Error(bad_input) for arrays that do not match the mesh, a value that is not finite as a float, a
/// name or a comment that a PLY cannot hold; Error(file) if it cannot be written.
void write_ply(const std::filesystem::path& path, const TriangleMesh& mesh,
               const VertexAttributes& attributes = {}, Existing existing = Existing::replace);

/// Writes what the name says: .ply as write_ply(), .obj (with normals), .off, .stl (binary: floats without
/// indices, so that only corners at one place are joined again, and vertices of no face are lost). Errors as
/// write_ply(), Error(bad_usage) for any other name.
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                Existing existing = Existing::replace);

/// Throws Error(bad_usage) for a name that write_mesh() does not know.
void require_mesh_extension(const std::filesystem::path& path);

}  // namespace offing
