#pragma once

#include <filesystem>
#include <string>

#include <glm/vec3.hpp>

#include "host/scene/model/scene.h"

namespace offing::present {

/// What a file can be that is dropped on a window.
enum class DroppedKind { scene, mesh, height_map, spectrum, cloud };

/// Whether a file may be of a kind, as far as its name tells: a .ply may be a mesh or a cloud, a folder that
/// is a tile store holds heights.
bool may_be(const std::filesystem::path& file, DroppedKind kind);

/// By its name, and of a .ply by its header: one of particles is a cloud. A folder is a tile store. Throws
/// Error(bad_input) for a file that is none of these, or not there.
DroppedKind kind_of_dropped(const std::filesystem::path& file);

/// Adds a file that is no scene to a scene, as far as that can be done without reading it, and keeps the sea
/// that there is: a mesh stands at `place_m` (world, +y up), heights are the ground in the stead of those
/// before, a spectrum makes the sea, a cloud is where its file has it. Returns what is to be said of it.
/// Throws Error(bad_input) where the scene takes no more of them, or not such a name.
std::string add_dropped(scene::Scene& scene, const std::filesystem::path& file, DroppedKind kind,
                        const glm::dvec3& place_m);

}  // namespace offing::present
