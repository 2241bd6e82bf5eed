#pragma once

#include <string_view>

#include <glm/vec2.hpp>

#include "host/highlights/projectors/highlight_rule.h"

namespace offing::highlights {

/// Signed distance from a place of a projector's box (-1 ... 1, x right, y up) to the rim of a shape,
/// negative inside, exact, in half widths. No shape leaves its box. Pictures fill theirs: max(|x|, |y|) - 1.
///
///   dot     |q| - 1
///   ring    ||q| - 0.8| - 0.2
///   window  four panes 0.92 wide around (+-0.54, +-0.54), corners rounded by 0.08
///   star    five tips on the unit circle, the first one up, and five notches at 0.45
///   streak  a lens from (0, -1) to (0, 1), 0.44 wide: two arcs of one circle; it lies along up, where
///           surfaces bend less
///   heart   two discs of radius 0.54 around (+-0.46, 0.46) and their outer tangents through (0, -1)
double signed_distance(HighlightTexture shape, const glm::dvec2& q);

/// How deep the deepest place of a shape is: the largest -signed_distance().
double depth_of(HighlightTexture shape);

/// How opaque a shape is there, 0 ... 1: 0 from the rim outward, and 1 from `softness` half widths inside it
/// on, or from the shape's depth on where that is less; between them the cubic 3 s^2 - 2 s^3. `pixel` is the
/// width of a pixel in half widths: no rim is narrower. Pictures bring their own rims: theirs is one pixel.
double shape_opacity(HighlightTexture shape, const glm::dvec2& q, double softness, double pixel);

/// Its name in scenes and exports.
std::string_view name_of(HighlightTexture texture);

}  // namespace offing::highlights
