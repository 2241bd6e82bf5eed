#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace offing::highlights {

/// What is drawn within a projector's box: a shape of this library, a picture with alpha, or a picture of
/// normals that is shaded inside the highlight.
enum class HighlightTexture { dot, window, star, ring, streak, heart, image, normal_map };

/// Whether a texture is a file's, not a shape.
constexpr bool is_image(HighlightTexture texture) {
  return texture == HighlightTexture::image || texture == HighlightTexture::normal_map;
}

constexpr double most_offset = 50.0;  ///< of HighlightControls::offset, either way
constexpr int most_copies = 64;

/// What an artist changes of a highlight (H6 of docs/sources.md) at one time. Default-made, it changes
/// nothing.
struct HighlightControls {
  glm::dvec2 offset{0.0};     ///< over the surface, along e_max and e_min, in half widths
  double rotation_rad = 0.0;  ///< about the normal, from right toward up
  /// 0 axes as found ... 1 up is the way up the surface, toward the mesh's +y, as near as rotation leaves it
  double upright = 0.0;
  double scale = 1.0;       ///< of both widths
  double anisotropy = 0.0;  ///< -1 ... 1: longer along right (above 0) or up, 16 times at 1; the area stays
  double squareness = 0.0;  ///< 0 as found ... 1 both widths alike, the area stays
  int split = 1;            ///< copies side by side along right, as wide as the one in all
  double split_gap = 0.25;  ///< between copies, in widths of one
  HighlightTexture texture = HighlightTexture::dot;
  int picture = -1;        ///< of image and normal_map: index into the world's pictures
  glm::dvec3 colour{1.0};  ///< linear Rec.709, times the light's
  double opacity = 1.0;    ///< 0 ... 1, times the highlight's own
  double softness = 0.3;   ///< of a shape's rim, in half widths
};

/// Controls with the highlights of a mesh that they are for. Of several rules that fit, the last one counts.
/// Places are those of the mesh at rest: where that deforms, they go along with what is nearest to them.
struct HighlightRule {
  /// Only the highlight nearest to this place of the mesh. Where another comes as near (2 % of the diagonal),
  /// the rule goes over to it by degrees, and where it appears or ends there, as fast as highlights fade.
  std::optional<glm::dvec3> nearest_m = {};
  std::optional<int> light = {};  ///< only those of this light
  /// Not what is found: one highlight that stands here on the mesh, wherever the lights are; in the light of
  /// `light`, or of the first one.
  std::optional<glm::dvec3> pin_m = {};
  /// Highlights are drawn on faces of which a corner is within this distance of the place, only.
  std::optional<glm::dvec3> mask_m = {};
  double mask_radius_m = 1.0;
  HighlightControls controls;
};

/// Throws Error(bad_input) that names the control which is out of range.
void require_valid(const HighlightRule& rule);

}  // namespace offing::highlights
