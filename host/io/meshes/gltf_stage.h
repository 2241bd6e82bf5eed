#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "host/io/file_trust.h"
#include "host/io/meshes/gltf_scene.h"
#include "host/io/meshes/mesh_file.h"

namespace offing::meshes {

/// A perspective camera: it looks along -z of its node, +y is up.
struct GltfCamera {
  std::string name;
  std::size_t node = 0;
  double vertical_field_of_view_rad = 1.0;
};

/// A light of KHR_lights_punctual. One with a direction shines along -z of its node.
struct GltfLight {
  std::string name;
  std::size_t node = 0;
  bool is_directional = false;
  glm::dvec3 colour{1.0};  ///< linear Rec.709
  double intensity = 1.0;  ///< lx of a directional light, else cd
};

/// What a glTF has for a picture besides its meshes.
struct GltfStage {
  std::vector<GltfCamera> cameras;  ///< in the order of the scene's nodes
  std::vector<GltfLight> lights;
  bool has_meshes = false;        ///< whether the scene shows any
  std::vector<LeftOut> left_out;  ///< counts above 0
  std::shared_ptr<const GltfScene> nodes;
};

/// Cameras and lights of the scene of a .gltf or .glb, with what moves them. `animation` is that of
/// GltfScene. Orthographic cameras, the cones of spot lights, the ranges of lights, materials and textures
/// are left out and counted. Throws as parse_gltf(), which reads the meshes.
GltfStage parse_gltf_stage(std::string_view bytes, const std::filesystem::path& path,
                           Trust trust = Trust::trusted, const std::string& animation = "");

/// The same of a file.
GltfStage read_gltf_stage(const std::filesystem::path& path, Trust trust = Trust::trusted,
                          const std::string& animation = "");

}  // namespace offing::meshes
