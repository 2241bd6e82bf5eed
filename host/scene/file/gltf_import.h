#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/io/meshes/mesh_file.h"
#include "host/scene/model/scene.h"

namespace offing::scene {

/// What to take of a glTF.
struct GltfChoice {
  std::string animation = {};  ///< empty: all; the first one that moves a value counts
  std::string camera = {};     ///< the scene's; empty: the first one
  double frames_per_s = 24.0;  ///< of the scene, and of the keyframes
};

/// The scene of a glTF, and what it could not take.
struct ImportedScene {
  Scene scene;
  std::vector<LeftOut> left_out = {};
};

/// Makes a scene from a glTF: its meshes, as one [[mesh]] with this file, its camera and its lights. Cameras
/// and lights that move get linear keyframes, without those that interpolation gives anyway. Further cameras
/// become bookmarks with their pose at the start. A light at a place gets the illuminance that it has at the
/// middle of the meshes at the start. If there are lights, the sun is put below the horizon, so that only
/// they shine.
///
/// Throws Error(bad_input) as read_mesh_file(), for a camera or an animation that is not there, for more than
/// 10,000 frames, and for values that a scene cannot have.
ImportedScene import_gltf(const std::filesystem::path& file, const GltfChoice& choice, Trust trust);

}  // namespace offing::scene
