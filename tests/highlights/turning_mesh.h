#pragma once

#include "host/highlights/projectors/drawn_highlights.h"
#include "host/highlights/search/highlight_surface.h"
#include "host/highlights/tracks/highlight_tracker.h"
#include "host/world/world_mesh.h"

namespace offing::test {

/// A mesh that turns about a line through its middle before an eye and a light at rest, for `moving_frames`
/// frames, and then stands.
struct TurningMesh {
  double degrees_per_frame = 0.5, frames_per_s = 30.0;
  int moving_frames = 720;

  highlights::RigidMotion motion(const highlights::HighlightSurface& surface, double time_s) const;
  highlights::Lighting world_lighting(const highlights::HighlightSurface& surface) const;
  highlights::Lighting lighting(const highlights::HighlightSurface& surface, double time_s) const;
  highlights::LightingAt lighting_at(const highlights::HighlightSurface& surface) const;
};

/// What changed most from a frame to the next, of all highlights, in the world and in the mesh's axes.
struct FrameChanges {
  double move_share = 0.0;  ///< of the diagonal
  double scale = 0.0;       ///< |ratio of widths - 1|, of either way
  double turn_deg = 0.0;
  double fade = 0.0;
};

/// How well highlights kept up with the points that were searched for.
struct Coherence {
  FrameChanges changes;
  /// Share of points that carry a highlight, of those that have been there and in the light for ten frames.
  double covered = 0.0;
  double median_lag_frames = 0.0;  ///< distance behind the point over its way in a frame
  double mean_points = 0.0, mean_shown = 0.0;
  std::size_t births = 0;
  std::size_t in_shadow = 0;  ///< points of all frames that their light does not reach
};

/// The mesh of a surface, turning. Both must outlive it.
world::WorldMesh view_of(const highlights::HighlightSurface& surface, const TurningMesh& turning);

/// Shows it at a time, as one picture of a sequence that begins at 0.
void show(world::WorldMesh& view, const TurningMesh& turning, double time_s);

/// Turns a mesh for all its frames.
Coherence turn(world::WorldMesh& view, const TurningMesh& turning);

}  // namespace offing::test
