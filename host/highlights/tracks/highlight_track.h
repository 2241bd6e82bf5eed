#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/highlights/projectors/projector.h"
#include "host/highlights/search/highlight_points.h"
#include "host/highlights/search/surface_place.h"

namespace offing::highlights {

/// How fast what is shown may change. Thirty frames a second move a highlight by 1.5 % of the mesh's diagonal
/// at most, scale it by 8 %, turn it by 4 degrees and fade it by 0.13.
struct TrackLimits {
  double move_per_s = 0.45;   ///< diagonals of the mesh's box
  double scale_per_s = 2.4;   ///< of the natural logarithm of a width
  double turn_radps = 2.094;  ///< of all three axes together
  double fade_per_s = 4.0;    ///< of the opacity
  /// Where eye, light or mesh turn steadily and so fast that these are more: diagonals, and radians, for
  /// each radian by which H turns over the surface. Else highlights would stay behind.
  double move_per_rad = 0.85, turn_per_rad = 2.0;
};

/// How highlights are followed over time.
struct TrackOptions {
  double step_s = 1.0 / 60.0;  ///< time between searches
  HighlightSize size{};
  TrackLimits limits{};
  /// How far from where it is expected a highlight may appear and still be the same, and how far behind what
  /// is shown may fall, before it fades out and a new one fades in: shares of the diagonal.
  double jump_share = 0.05, lag_share = 0.08;
  /// Highlights of one light are one to the eye while the middle of one is this deep in another's box (0 in
  /// the middle, 1 at the rim), or nearer than a share of the diagonal. They are two from the larger values
  /// on.
  double unite_depth = 1.5, part_depth = 2.2;
  double unite_share = 0.16, part_share = 0.22;
  /// A point must have been there for this long before it becomes visible.
  double settle_s = 0.1;
  /// One is hidden where its light reaches less of it than the first share, until it reaches the second.
  double dark_share = 0.2, lit_share = 0.4;
  /// One that has become visible stays for this long, and as long as it takes to fade out, even if its point
  /// is gone.
  double least_life_s = 0.25;
  int key_steps = 60;        ///< from one key state to the next
  bool has_shadows = false;  ///< whether the surface keeps highlights from their lights (LightShadow)
};

/// Checks ranges: throws Error(bad_input) that names the option.
void require_valid(const TrackOptions& options);

/// A place of the mesh, for whose nearest highlight a rule is; with a light, of those of this light.
struct NearestPlace {
  glm::dvec3 place_m{0.0};  ///< of the surface at rest
  std::optional<int> light = {};
  /// Nearest to it on the surface at rest: it goes along as that deforms. Follows from the place.
  SurfacePlace nearest = {};

  bool operator==(const NearestPlace& other) const {
    return place_m == other.place_m && light == other.light;
  }
};

/// One highlight through time.
struct HighlightTrack {
  std::uint64_t id = 0;  ///< counts births since reset()
  /// Found in the last search, or fading out since it was lost.
  enum class State { alive, fading };
  State state = State::alive;
  HighlightPoint point;   ///< where N = H, or was
  glm::dvec3 way_m{0.0};  ///< of the point in the last step
  double turn_rad = 0.0;  ///< of H over the surface in the last step
  /// The lesser of that of the last two steps: a light that jumps does not raise the limits.
  double steady_turn_rad = 0.0;
  Projector projector;          ///< as shown: follows the point within the limits
  std::uint32_t seed_face = 0;  ///< that the projector's middle lies on
  double presence = 0.0;        ///< 0 ... 1: fades in from birth on, out from the end on
  bool is_merged = false;       ///< another one is shown in its stead
  double share = 1.0;           ///< 0 ... 1: goes to 0 while it is merged, else to 1
  double shown_s = 0.0;         ///< for how long it has been visible
  double age_s = 0.0;           ///< since its point was found first
  bool is_dark = false;         ///< hidden, as its light reaches too little of it
  double lit = 1.0;             ///< 0 ... 1: how much of it its light reaches, as looked at last
  double opacity = 0.0;         ///< 0 ... 1, as shown: follows presence * share * lit within the limits
  std::vector<double> nearest;  ///< [TrackState::places], 0 ... 1: how much of it is the nearest to each
};

/// All highlights at one step: what a replay can start from.
struct TrackState {
  std::int64_t step = 0;  ///< since reset()
  std::uint64_t next_id = 0;
  std::vector<HighlightTrack> tracks;  ///< by id
  std::vector<NearestPlace> places;    ///< that tracks share out among them
};

}  // namespace offing::highlights
