#pragma once

#include <cstdint>

#include "host/highlights/projectors/projector.h"
#include "host/highlights/search/face_tree.h"
#include "host/highlights/search/highlight_surface.h"
#include "host/highlights/search/lighting.h"

namespace offing::highlights {

/// Which highlights a mesh keeps its lights from (H11 of docs/sources.md).
class LightShadow {
 public:
  explicit LightShadow(const HighlightSurface& surface)
      : tree_(surface.mesh()), touching_m_(1e-4 * surface.diagonal_m()), revision_(surface.revision()) {}

  /// Of the surface that it was made of.
  std::uint64_t revision() const { return revision_; }

  /// 0 ... 1: how much of the middle of a highlight the light reaches, both in the mesh's axes. It changes
  /// evenly while the edge of a shadow crosses the middle, so that a highlight fades and does not vanish at
  /// once.
  double lit_share(const Projector& projector, const Source& light) const;

 private:
  FaceTree tree_;
  double touching_m_;  // this far off the surface begins what casts shadows
  std::uint64_t revision_;
};

}  // namespace offing::highlights
