#pragma once

#include <string>

#include "host/scene/measure/energy_shares.h"
#include "host/scene/prepare/sea.h"

namespace offing::cli {

/// The cascades with their bands and the energy that each holds.
std::string cascade_text(const scene::Sea& sea, const scene::EnergyShares& energy);

}  // namespace offing::cli
