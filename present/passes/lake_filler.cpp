#include "present/passes/lake_filler.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

#include "host/base/error.h"
#include "host/scene/prepare/scene_terrain.h"

namespace offing::present {

bool SceneLakes::are_on(const world::TerrainParameters& ground) const {
  return terrain.map == ground.map && terrain.tiles == ground.tiles &&
         terrain.origin_x_m == ground.origin_x_m && terrain.origin_z_m == ground.origin_z_m;
}

void LakeFiller::begin(const scene::Scene& scene, std::vector<scene::LakeScene> before,
                       const world::TerrainParameters& terrain) {
  stop();
  cancel_ = std::make_unique<CancelToken>();
  wanted_ = {.lakes = scene.lakes, .terrain = terrain};
  const auto fill = [scene, before = std::move(before), filled = wanted_, cancel = cancel_.get()]() mutable {
    try {
      filled.terrain.lakes = scene::prepare_lakes(scene, filled.terrain, before, Work(*cancel));
      return filled;
    } catch (const std::bad_alloc&) {
      throw Error(ErrorKind::out_of_memory, "lakes: this machine has too little memory to fill them",
                  "choose a lower level, or a coarser map");
    }
  };
  filling_ = std::async(std::launch::async, fill);
}

bool LakeFiller::is_filling(const std::vector<scene::LakeScene>& lakes,
                            const world::TerrainParameters& ground) const {
  return is_busy() && wanted_.are_on(ground) &&
         std::ranges::equal(wanted_.lakes, lakes, scene::are_filled_alike);
}

void LakeFiller::stop() {
  if (!filling_.valid()) return;
  cancel_->cancel();
  filling_.wait();
  filling_ = {};
  wanted_ = {};
}

std::optional<SceneLakes> LakeFiller::take() {
  if (!filling_.valid() || filling_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
  wanted_ = {};
  return filling_.get();
}

}  // namespace offing::present
