#include "present/passes/lake_filler.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "host/base/error.h"
#include "host/scene/prepare/scene_terrain.h"
#include "present/background_work.h"

namespace offing::present {

namespace {

std::optional<double> sea_level_m(const scene::Scene& scene) {
  return scene.has_sea() ? std::optional(scene.sea_level_m()) : std::nullopt;
}

}  // namespace

bool SceneLakes::are_on(const world::TerrainParameters& ground) const {
  return terrain.map == ground.map && terrain.tiles == ground.tiles &&
         terrain.origin_x_m == ground.origin_x_m && terrain.origin_z_m == ground.origin_z_m;
}

void LakeFiller::begin(const scene::Scene& scene, std::vector<scene::LakeScene> before,
                       const world::TerrainParameters& terrain) {
  stop();
  cancel_ = std::make_unique<CancelToken>();
  asked_ = {.lakes = scene.lakes, .terrain = terrain, .sea_level_m = sea_level_m(scene)};
  const auto fill = [scene, before = std::move(before), filled = asked_, cancel = cancel_.get()]() mutable {
    filled.terrain.lakes = scene::prepare_lakes(scene, filled.terrain, before, Work(*cancel));
    return filled;
  };
  const Error no_memory(ErrorKind::out_of_memory, "lakes: this machine has too little memory to fill them",
                        "choose a lower level, or a coarser map");
  try {
    filling_ = run_in_background("lakes", no_memory, fill);
  } catch (const Error& error) {
    // As any other fault of filling: take() throws it.
    std::promise<SceneLakes> unfilled;
    unfilled.set_exception(std::make_exception_ptr(error));
    filling_ = unfilled.get_future();
  }
}

bool LakeFiller::is_asked_for(const scene::Scene& scene, const world::TerrainParameters& ground) const {
  return asked_.are_on(ground) && asked_.sea_level_m == sea_level_m(scene) &&
         std::ranges::equal(asked_.lakes, scene.lakes, scene::are_filled_alike);
}

void LakeFiller::stop() {
  if (filling_.valid()) {
    cancel_->cancel();
    filling_.wait();
  }
  filling_ = {};
  asked_ = {};
}

std::optional<SceneLakes> LakeFiller::take() {
  if (!filling_.valid() || filling_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
  return filling_.get();
}

}  // namespace offing::present
