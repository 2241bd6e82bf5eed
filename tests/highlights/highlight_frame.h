#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/highlights/projectors/projector.h"
#include "host/highlights/projectors/region.h"
#include "host/highlights/tracks/highlight_track.h"

/// Tracks as they are drawn without rules: what tests and benchmarks hold against a HighlightDrawing.
namespace offing::highlights {

/// One highlight as it is drawn.
struct ShownHighlight {
  std::uint64_t id = 0;
  int light = 0;
  double opacity = 0.0;
  Projector projector;
  std::size_t first_face = 0, face_count = 0;  ///< of HighlightFrame::faces
};

/// What is drawn at one time: highlights by id and the faces that each is drawn on.
struct HighlightFrame {
  std::vector<ShownHighlight> highlights;
  std::vector<std::uint32_t> faces;

  std::span<const std::uint32_t> faces_of(const ShownHighlight& highlight) const {
    return std::span(faces).subspan(highlight.first_face, highlight.face_count);
  }
};

/// The tracks that can be seen (opacity above 0) with their regions, into a frame whose memory is used again.
void make_frame(const std::vector<HighlightTrack>& tracks, RegionSearch& regions, HighlightFrame& frame);

}  // namespace offing::highlights
