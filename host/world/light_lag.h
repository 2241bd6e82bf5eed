#pragma once

namespace offing::world {

/// How far what light does may lag behind what a world shows, so that a frame costs less. The default is what
/// cannot be seen; with more, a picture depends on those before it.
struct LightLag {
  /// The sky is that of the nearest of fixed heights, so far apart as a share of themselves.
  double altitude_share = 0.01;
  /// Clouds are lit at every so many'th of their steps of time, 1 or more; from 2 on those that drift as one
  /// keep their shapes in between too, and new light on clouds that only moved takes one part a call of
  /// WorldClouds::light().
  int cloud_steps = 1;
  /// Other new light on clouds is spread over this many calls of WorldClouds::light() at most, 1 or more;
  /// until it is whole the old light stays.
  int cloud_light_frames = 1;
  /// Clouds send an eye the light that they sent to one at most so far aside, rad as seen from any of them.
  double cloud_rad = 0.0;
  /// An eye farther aside has theirs anew part by part, all of it after so many WorldClouds::see() or
  /// see_mirrored(), 1 or more.
  int cloud_parts = 1;

  bool operator==(const LightLag&) const = default;
};

}  // namespace offing::world
