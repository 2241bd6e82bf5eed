#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/base/error.h"
#include "host/base/work.h"
#include "host/scene/model/scene.h"
#include "host/world/world_terrain.h"

namespace offing::scene {

/// The ground of a scene, with its height map read or made; nothing where it has none. Throws
/// Error(bad_input) that names the place in the scene for a file that is not there, what
/// read_height_map() and FractalTerrain throw, and Error(cancelled) if `work` is cancelled while lakes are
/// filled.
std::optional<world::TerrainParameters> prepare_terrain(const Scene& scene, const Work& work = {});

/// A lake that cannot be where a scene wants it.
class LakeError : public Error {
 public:
  LakeError(const Error& error, std::vector<std::size_t> lakes) : Error(error), lakes_(std::move(lakes)) {}

  /// The numbers of lakes that are in the way of each other, or of the one that has no basin.
  const std::vector<std::size_t>& lakes() const { return lakes_; }

 private:
  std::vector<std::size_t> lakes_;
};

/// The lakes of a scene on this ground. The ground may have the lakes of `before`: those that stay are not
/// filled again. Throws LakeError(bad_input) that names the place in the scene for a lake that cannot be
/// there, and Error(cancelled) if `work` is cancelled.
std::vector<world::LakeSettings> prepare_lakes(const Scene& scene, const world::TerrainParameters& terrain,
                                               std::span<const LakeScene> before, const Work& work);

/// Whether two lakes on the same ground cover the same part of it.
bool are_filled_alike(const LakeScene& one, const LakeScene& other);
/// Whether an edit changes the heights of the ground or where they are.
bool is_other_ground(const Scene& before, const Scene& after);
/// Whether the scene after an edit has lakes that are still to be filled, which can take long.
bool has_lakes_to_fill(const Scene& before, const Scene& after);

/// The same for a scene that is an edit of another one, whose ground is `now`: heights are read or made only
/// if they are others.
std::optional<world::TerrainParameters> edited_terrain(const std::optional<world::TerrainParameters>& now,
                                                       const Scene& before, const Scene& after);

/// Whether a scene says where its eye is, or where it looks.
bool places_its_camera(const Scene& scene);

/// Where a scene has ground and does not say where its eye is: terrain::flying_camera() over that ground,
/// with the scene's field of view. Does nothing else.
void place_camera(Scene& scene, const std::optional<world::TerrainParameters>& terrain);

/// Where the camera walks and is over the ground, or is in the ground: its eye goes to a walker's height.
void stand_on_ground(const world::WorldTerrain& terrain, ViewScene& view);

/// A warning if the eye of a view, before stand_on_ground(), is below the ground or, where there is no sea,
/// off the map. Nothing otherwise.
std::optional<std::string> eye_warning(const world::WorldTerrain& terrain, ViewScene view, bool has_sea);

}  // namespace offing::scene
