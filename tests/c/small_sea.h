#pragma once

#include <gtest/gtest.h>

#include "host/c/offing.h"

namespace offing {

/// A device, a scene with a small sea of cascades and Gerstner waves, and its world.
class SmallSea : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(offing_open_device(nullptr, &device_), OFFING_OK) << offing_last_error();
    ASSERT_EQ(offing_parse_scene(
                  "version = 1\n[wind]\nspeed_mps = 9\n[ocean]\nsize = 64\n[ocean.gerstner]\ncount = 8\n",
                  nullptr, &scene_),
              OFFING_OK)
        << offing_last_error();
    ASSERT_EQ(offing_make_world(device_, scene_, &world_), OFFING_OK) << offing_last_error();
  }
  void TearDown() override {
    offing_free_world(world_);
    offing_free_scene(scene_);
    offing_close_device(device_);
  }

  OffingDevice* device() const { return device_; }
  OffingScene* scene() const { return scene_; }
  OffingWorld* world() const { return world_; }

 private:
  OffingDevice* device_ = nullptr;
  OffingScene* scene_ = nullptr;
  OffingWorld* world_ = nullptr;
};

}  // namespace offing
