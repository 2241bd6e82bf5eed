#pragma once

namespace offing::test {

/// What the process holds of the system's.
struct Holdings {
  double memory_mb = 0.0;
  /// But for those that Mesa has write compiled shaders to disk: one to four, as many as there is to write.
  int threads = 0;
  int descriptors = 0;
};

Holdings holdings();

/// How long a soak lasts: OFFING_SOAK_SECONDS, or this.
double soak_seconds(double usual);

}  // namespace offing::test
