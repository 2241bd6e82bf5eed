#pragma once

#include <optional>

#include "host/base/keyframes.h"
#include "host/scene/model/scene.h"

namespace offing::scene {

/// A number that may have keyframes.
class MovingNumber {
 public:
  MovingNumber(const Scene& scene, const ValueKey& key, double constant) : constant_(constant) {
    if (const auto track = scene.tracks.find(key); track != scene.tracks.end()) track_ = track->second;
  }

  double at(double time_s) const { return track_ ? value_at(*track_, time_s) : constant_; }

 private:
  double constant_;
  std::optional<KeyframeTrack> track_;
};

}  // namespace offing::scene
