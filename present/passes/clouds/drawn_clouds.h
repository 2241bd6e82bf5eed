#pragma once

#include "host/clouds/image/cloud_image.h"
#include "host/world/world.h"

namespace offing::present {

/// The clouds of a world as the last World::see_clouds() sorted them, for CloudPass. The world has clouds.
clouds::DrawnParticles drawn_clouds(const world::World& world);

}  // namespace offing::present
