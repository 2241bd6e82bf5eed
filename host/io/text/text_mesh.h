#pragma once

#include <string_view>

#include "host/base/triangle_mesh.h"

namespace offing {

/// Letters to be made solid.
struct TextMeshOptions {
  double height_m = 1.0;     ///< of the box around the outlines
  double thickness_m = 0.3;  ///< from front to back
};

/// The outlines of a text in the system's bold sans-serif font, each stretched from front to back to a wall:
/// what a solid needs that is filled by winding numbers (holes wind the other way), without caps. x to the
/// right, y up, the front at +z; the middle of the box around it is the origin. Throws Error(bad_input) for
/// text that is not UTF-8, has no outlines, as blanks have none, or is longer than 64 bytes.
TriangleMesh text_mesh(std::string_view text, const TextMeshOptions& options);

}  // namespace offing
