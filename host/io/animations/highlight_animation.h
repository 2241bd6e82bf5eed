#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "host/base/camera.h"
#include "host/base/rgba_image.h"
#include "host/base/triangle_mesh.h"
#include "host/io/atomic_file.h"

namespace offing::animations {

/// What a projector casts: alpha is where it is opaque.
struct AnimatedTexture {
  std::string name;  ///< of a built-in shape, or "image", "normal_map"
  std::string file;  ///< of a picture, as it is to be named; empty for shapes
  RgbaImage image;   ///< of a shape; empty for pictures
};

/// One projector at one time, in its mesh's axes: a box cast along -normal, with right x up = normal.
struct ProjectorSample {
  std::uint64_t id = 0;  ///< the same for the same highlight from frame to frame
  int rule = -1;         ///< of the artist's, -1: none. A highlight between two rules has a projector of each
  int copy = 0;          ///< of a highlight that is split
  int light = 0;         ///< whose light it is, in the order of the scene; -1: a pin, which has none
  glm::dvec3 position_m{0.0}, right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, normal{0.0, 0.0, 1.0};
  double width_m = 1.0, height_m = 1.0;  ///< full, along right and up
  double opacity = 1.0;                  ///< 0 ... 1
  std::size_t texture = 0;               ///< of HighlightAnimation::textures
  double softness = 0.0;                 ///< of a shape's rim, in half widths
  glm::dvec3 colour{1.0};                ///< linear Rec.709
};

/// A mesh at one time: world = rotation * mesh + translation_m.
struct MeshFrame {
  glm::dmat3 rotation{1.0};
  glm::dvec3 translation_m{0.0};
  std::vector<ProjectorSample> projectors;
  /// Of a mesh that deforms and has a look: frames of the same form share one. None: at rest.
  std::shared_ptr<const MeshForm> form = {};
};

/// What a mesh looks like at rest, for programs that do not have its file.
struct MeshLook {
  std::shared_ptr<const TriangleMesh> mesh;  ///< at its scale, with its normals
  glm::dvec3 colour{0.5};                    ///< diffuse reflectance, linear Rec.709
};

/// A mesh of an animation, with its pose and highlights in each frame.
struct AnimatedMesh {
  std::string name;
  std::string file;    ///< as it is to be named; empty for made shapes
  double scale = 1.0;  ///< of the file's places, before its pose
  std::vector<MeshFrame> frames;
  std::optional<MeshLook> look = {};
};

/// What a light sends at one time.
struct LightFrame {
  glm::dvec3 vector{0.0, 1.0, 0.0};  ///< toward a distant light, or the place of a near one, m
  glm::dvec3 illuminance_klx{0.0};   ///< of surfaces that face it, linear Rec.709; 0 where it is gone
};

/// A light of an animation.
struct AnimatedLight {
  bool is_near = false;
  double distance_m = 1.0;  ///< of a near one from the meshes
  std::vector<LightFrame> frames;
};

/// What meshes, eye and lights of a scene are beside their highlights.
struct AnimatedScene {
  std::vector<Camera> cameras;        ///< a frame each
  std::vector<AnimatedLight> lights;  ///< in the order of HighlightAnimation::lights
};

/// The highlights of meshes, frame by frame: frame i is at (first_frame + i) / frames_per_s.
struct HighlightAnimation {
  std::string generator;  ///< the program that made it, with its version
  double frames_per_s = 30.0;
  int first_frame = 0;
  std::vector<std::string> lights;  ///< names, in the order of ProjectorSample::light
  std::vector<AnimatedTexture> textures;
  std::vector<AnimatedMesh> meshes;         ///< as many frames each
  std::optional<AnimatedScene> scene = {};  ///< of glTF files alone
};

/// By the name's ending, atomically: `.json`, for programs: every number, in the world's axes, next to the
/// pose of each mesh; `.gltf` or `.glb`, for engines: a node a projector below one a mesh (see
/// highlight_animation_gltf()). The same animation gives the same bytes. Throws Error(bad_usage) for another
/// ending, Error(file) if it cannot be written.
void write_highlights(const std::filesystem::path& file, const HighlightAnimation& animation,
                      Existing existing = Existing::replace);

/// Throws Error(bad_usage) unless the name ends in one of those that write_highlights() writes.
void require_animation_name(const std::filesystem::path& file);

enum class GltfForm {
  text,    ///< .gltf: JSON with its buffer inside, in base64
  binary,  ///< .glb
};

/// An animation as glTF 2.0: below a node for each mesh, which moves as the mesh does, a node for each
/// projector that ever is: its +x, +y and +z are right, up and normal, its scale is the box (width, height,
/// the larger of both), 0 while it is not there. So the projection is the inverse of the node's matrix, and
/// the box lies within -0.5 ... 0.5. Each node carries a unit square with the texture, unlit, so that the
/// file shows something in any viewer; opacity and colour are animated as the material's baseColorFactor by
/// KHR_animation_pointer, which viewers that do not know it leave out. `extras` of a projector's node have
/// id, rule, copy, light (of the file's extras.lights, null for a pin), texture and softness; those of a
/// mesh's node its file and the scale of the file's places, which the node does not have. Poses lie at each
/// frame, linear in between.
///
/// A mesh with a look is in the file too: positions, normals and a material of its name. Each of its forms is
/// a morph target, and weights lead from form to form. A scene gives a node
/// "camera" and a node for each light (KHR_lights_punctual), in lux, or in candela that make its illuminance
/// at distance_m; values that do not change have no keys.
std::string highlight_animation_gltf(const HighlightAnimation& animation, GltfForm form);

/// An animation as JSON: {"generator", "version": 1, "frames_per_s", "first_frame", "frame_count",
/// "lights": [name], "textures": [{"name", "file"?}], "meshes": [{"name", "file"?, "scale", "frames":
/// [{"frame", "time_s", "mesh": {"translation_m", "rotation": [x, y, z, w]}, "highlights": [{"id", "rule",
/// "copy", "light", "position_m", "right", "up", "normal", "width_m", "height_m", "opacity", "texture",
/// "softness", "colour"}]}]}]}. Vectors are in the world's axes (right-handed, y up), `texture` is an index,
/// a rotation is a unit quaternion. Numbers read back to the same doubles.
/// `lights` and `light` are written under their earlier names, `lamps` and `lamp`, too.
std::string highlight_animation_json(const HighlightAnimation& animation);

}  // namespace offing::animations
