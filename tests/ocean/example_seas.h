#pragma once

#include <string>
#include <vector>

#include "host/ocean/spectrum/sea_spectrum.h"

namespace offing::ocean {

struct ExampleSea {
  std::string name;
  SeaSpectrum spectrum;
};

/// Every model and every spreading once, two narrow swells, and measured records with long swell below a wind
/// sea, one of them with all energy in single frequencies and directions.
std::vector<ExampleSea> example_seas();

}  // namespace offing::ocean
