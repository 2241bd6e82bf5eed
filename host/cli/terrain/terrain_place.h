#pragma once

#include <string_view>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "host/terrain/field/terrain_posts.h"

namespace offing::cli {

/// How every command that takes places explains them.
inline constexpr const char* place_footer =
    "X and Z are metres east and south of the map's north-west post. Y is height, H is height above ground.";

/// Throws Error(bad_input) that names the flag unless (x_m, z_m) is within a map of this extent.
void require_within(std::string_view flag, double width_m, double depth_m, double x_m, double z_m);

/// The ground under (x_m, z_m). Throws Error(bad_input) that names the flag beyond the map's edge.
terrain::TerrainPoint terrain_under(std::string_view flag, const terrain::TerrainPosts& posts, double x_m,
                                    double z_m);

/// Degrees from level.
double slope_deg(const glm::dvec3& normal);

nlohmann::ordered_json to_json(const glm::dvec3& vector);

}  // namespace offing::cli
