#pragma once

#include "host/world/world.h"

namespace offing::test {

/// A world whose sea carries a ship of 24 m and a box of 2 m beside it, each the mesh of its own number; the
/// third mesh is aboard the ship, 8 m aft and 3 m up. It runs at 4 m/s toward +x with a wake window that
/// follows it.
world::WorldParameters floating_world(double wind_speed_mps);

}  // namespace offing::test
