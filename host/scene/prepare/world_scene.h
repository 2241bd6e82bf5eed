#pragma once

#include "host/base/work.h"
#include "host/scene/model/scene.h"
#include "host/scene/prepare/sea.h"
#include "host/world/world.h"

namespace offing::scene {

/// What a world needs of a scene, with the view of its start. Throws what prepare_sea() and prepare_terrain()
/// throw.
world::WorldParameters prepare_world(const Scene& scene, Warnings warnings = Warnings::logged,
                                     const Work& work = {});

/// The same for a scene that is to be shown: its camera is placed where it says nothing (place_camera(),
/// look_at_meshes()).
world::WorldParameters prepare_shown_world(Scene& scene, const Work& work = {});

/// Gives a world the sun and the air of a view; what has not changed costs nothing.
void set_view(world::World& world, const ViewScene& view);

/// Takes a world to what its scene shows at this time, seen from the scene's own camera: sun and air, the
/// water, and the eye's height in the sky. Returns that view. Throws what view_at() and World::at() throw.
ViewScene show_at(world::World& world, const Scene& scene, double time_s);

/// Makes the world that `before` was prepared for that of `after`, with the view of its start: as a fresh
/// start with it would, but only what the two differ in is made anew. Swells and raindrops cost nothing, the
/// seed draws the same spectrum again, all else of the sea makes it anew. Bodies with another start, hull or
/// load begin anew at the time that is shown; others go on, on the water that has changed, from where they
/// are. Wakes are computed again over their histories. Logs no
/// warnings. Throws what
/// prepare_sea() and view_at() throw, and has changed nothing then; where the device cannot make a part of
/// it, parts may have changed.
void edit_world(world::World& world, const Scene& before, const Scene& after);

/// The same for all but the clouds, which stay as they are.
void edit_world_below(world::World& world, const Scene& before, const Scene& after);

}  // namespace offing::scene
