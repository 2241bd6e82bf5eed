#pragma once

#include <cstdint>
#include <vector>

#include "host/highlights/projectors/projector.h"
#include "host/highlights/search/highlight_surface.h"

namespace offing::highlights {

/// Finds the faces that a projector draws on (H8, H11 of docs/sources.md). The time for one is that of the
/// faces found and of those around them, however large the mesh.
class RegionSearch {
 public:
  /// The surface must outlive the search.
  explicit RegionSearch(const HighlightSurface& surface);

  /// Appends the faces that hang together with `seed` (corner by corner, across components where those
  /// touch), reach into the projector's box, whatever their depth, and look its way (face normal . normal >
  /// 0); `seed` itself always, first. Of faces of the same three places one is enough.
  void find(const Projector& projector, std::uint32_t seed, std::vector<std::uint32_t>& faces);

 private:
  const HighlightSurface* surface_;
  std::uint32_t round_ = 0;                              // of the marks that count
  std::vector<std::uint32_t> face_marks_, place_marks_;  // [faces], [places]: the round that came by last
  std::vector<std::uint32_t> first_copies_;              // [faces]: the first one of the same three places
  std::vector<std::uint32_t> copy_marks_;                // [faces], of first copies: the round that draws one
};

}  // namespace offing::highlights
