#pragma once

#include "host/c/call.h"
#include "host/ocl/device.h"
#include "host/scene/model/scene.h"
#include "host/world/world.h"

/// What the handles of offing.h are.

struct OffingDevice {
  offing::ocl::Device device;
};

struct OffingScene {
  offing::scene::Scene scene;
};

struct OffingWorld : offing::c::OneAtATime {
  OffingWorld(const offing::scene::Scene& of, const offing::ocl::Device& device,
              const offing::world::WorldParameters& parameters)
      : scene(of), world(device, parameters) {}

  offing::scene::Scene scene;
  offing::world::World world;
};
