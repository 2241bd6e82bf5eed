#pragma once

#include <string>

#include "host/io/animations/highlight_animation.h"

namespace offing::animations {

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
std::string highlight_animation_gltf(const HighlightAnimation& animation, GltfForm form);

}  // namespace offing::animations
