#pragma once

namespace offing::test {

/// What the process holds of the system's.
struct Holdings {
  double memory_mb = 0.0;
  int threads = 0;
  int descriptors = 0;
};

Holdings holdings();

/// How long a soak lasts: OFFING_SOAK_SECONDS, or this.
double soak_seconds(double usual);

}  // namespace offing::test
