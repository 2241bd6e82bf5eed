#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "host/cli/ocean/bake_settings.h"
#include "host/scene/measure/energy_shares.h"
#include "host/scene/prepare/sea.h"

namespace offing::cli {

/// ocean.json, which lies beside the frames of a bake: all that a program needs to put the maps together.
/// docs/ocean.schema.json says what its fields are. It depends on scene, settings and version alone.
nlohmann::ordered_json bake_description(const scene::Scene& scene, const scene::Sea& sea,
                                        const BakeSettings& settings, const scene::EnergyShares& energy,
                                        const std::string& scene_hash);

/// m0 of these waves, m^2.
double energy_m2(const std::vector<ocean::GerstnerWave>& waves);

}  // namespace offing::cli
