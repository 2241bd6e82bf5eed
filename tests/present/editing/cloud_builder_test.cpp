// Clouds that are made in the background: the same as in the foreground, the newest at last, faults told.
#include "present/editing/cloud_builder.h"

#include <chrono>
#include <cstring>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "host/clouds/particles/cloud_model.h"
#include "host/io/vdb/vdb_volume.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/scene_clouds.h"
#include "tests/io/temporary_folder.h"

namespace offing::present {
namespace {

scene::Scene scene_of(const std::string& text) {
  return scene::parse_scene("version = 1\n" + text, "a.toml", "");
}

bool are_same(const std::vector<CloudParticle>& a, const std::vector<CloudParticle>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(CloudParticle)) == 0;
}

class CloudBuilderTest : public testing::Test {
 protected:
  BuiltClouds built() {
    builder_.wait();
    auto made = builder_.take();
    if (!made) throw std::runtime_error("nothing was made");
    return std::get<BuiltClouds>(std::move(*made));
  }

  CloudBuilder builder_{ocl::select_device(), scene_of("")};
};

constexpr const char* two = "[[cloud]]\n[[cloud]]\ngenus = \"stratus\"\nx_m = 700\ntarget_particles = 200\n";

// Fails if the thread makes other particles than the world would by itself, wherever a cloud is.
TEST_F(CloudBuilderTest, MakesWhatTheWorldWouldMake) {
  const scene::Scene scene = scene_of(two);
  builder_.begin(scene, Haste::interrupt);
  const BuiltClouds result = built();
  ASSERT_TRUE(result.sky);
  ASSERT_EQ(result.sky->particles.size(), 2u);
  const ocl::Device device = ocl::Device::open();
  const auto sky = scene::prepare_clouds(scene);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(are_same(*result.sky->particles[i], clouds::particles_at_rest(device, sky->clouds[i]))) << i;
  }
  EXPECT_FALSE(builder_.progress());
  EXPECT_FALSE(builder_.take());
}

// Fails if a cloud that was only moved or edited by hand is made again, or one that was changed is not.
TEST_F(CloudBuilderTest, KeepsWhatStays) {
  scene::Scene scene = scene_of(two);
  builder_.begin(scene, Haste::interrupt);
  const BuiltClouds first = built();
  scene.clouds[0].position_m.x = 50.0;
  scene.clouds[0].edits.emplace_back();
  scene.clouds[1].seed = 5;
  builder_.begin(scene, Haste::interrupt);
  const BuiltClouds second = built();
  EXPECT_EQ(second.sky->particles[0], first.sky->particles[0]);
  EXPECT_NE(second.sky->particles[1], first.sky->particles[1]);
  // Numbers of clouds do not matter.
  scene.clouds.erase(scene.clouds.begin());
  builder_.begin(scene, Haste::interrupt);
  EXPECT_EQ(built().sky->particles[0], second.sky->particles[1]);
  scene.clouds.clear();
  builder_.begin(scene, Haste::interrupt);
  EXPECT_FALSE(built().sky);
}

// Fails if edits in quick succession end with another one than the last, or wait for all of them.
TEST_F(CloudBuilderTest, TheNewestEditCounts) {
  scene::Scene scene = scene_of(two);
  for (const Haste haste : {Haste::let_finish, Haste::interrupt}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      scene.clouds[0].seed = seed;
      builder_.begin(scene, haste);
    }
    EXPECT_EQ(built().scene.clouds[0].seed, 20u);
  }
}

// Fails if a fault ends the thread, or is told twice.
TEST_F(CloudBuilderTest, TellsFaultsAndGoesOn) {
  builder_.begin(scene_of("[[cloud]]\nfile = \"nowhere.vdb\"\n"), Haste::interrupt);
  builder_.wait();
  const auto made = builder_.take();
  ASSERT_TRUE(made && std::holds_alternative<Error>(*made));
  EXPECT_NE(std::string(std::get<Error>(*made).what()).find("nowhere.vdb"), std::string::npos);
  EXPECT_FALSE(builder_.take());
  builder_.begin(scene_of(two), Haste::interrupt);
  EXPECT_TRUE(built().sky);
}

// Pictures are read once for a folder; a folder that is broken is told of, each time it is named.
TEST_F(CloudBuilderTest, ReadsBillboardsWhereTheyChange) {
  TemporaryFolder folder;
  for (int i = 0; i < CLOUD_TEXTURES; ++i) {
    std::ofstream(folder.path() / (std::to_string(i) + ".png")) << "no picture";
  }
  scene::Scene scene = scene_of(two);
  builder_.begin(scene, Haste::interrupt);
  EXPECT_FALSE(built().billboards);
  scene.cloud_settings.crisp_billboards = folder.path().string();
  for (int i = 0; i < 2; ++i) {
    builder_.begin(scene, Haste::interrupt);
    builder_.wait();
    const auto made = builder_.take();
    ASSERT_TRUE(made && std::holds_alternative<Error>(*made));
    EXPECT_NE(std::string(std::get<Error>(*made).what()).find("clouds.crisp_billboards"), std::string::npos)
        << std::get<Error>(*made).what();
  }
  scene.cloud_settings.crisp_billboards.clear();
  builder_.begin(scene, Haste::interrupt);
  EXPECT_FALSE(built().billboards) << "nothing else was ever shown";
}

// Fails if a window that is closed waits for, or crashes by, what is being made.
TEST(CloudBuilderEndTest, EndsAtAnyTime) {
  for (int i = 0; i < 3; ++i) {
    CloudBuilder builder(ocl::select_device(), scene_of(""));
    builder.begin(scene_of(two), Haste::let_finish);
  }
}

// Fails if a cloud that takes minutes keeps a window open, makes the next edit wait, or tells nothing. Grown,
// sampled, and merged from a file's cells.
TEST(CloudBuilderEndTest, GivesUpWithinACloud) {
  TemporaryFolder folder;
  const std::string file = (folder.path() / "block.vdb").string();
  CloudVolume volume{.cell_m = 4.0, .bricks = {16, 16, 16}, .brick_of = {}, .density = {}};
  for (std::int32_t i = 0; i < 16 * 16 * 16; ++i) volume.brick_of.push_back(i);
  volume.density.assign(volume.brick_of.size() * CloudVolume::cells_of_brick, 1.0f);
  write_vdb(file, {.volume = volume, .albedo = {}});
  for (const std::string& long_one :
       {std::string("[[cloud]]\n[[cloud.level]]\nratio = 0.02\n[[cloud.level]]\nratio = 0.15\n"),
        std::string("[[cloud]]\ngenus = \"stratus\"\ntarget_particles = 1000000\n"),
        "[[cloud]]\ntarget_particles = 1000000\nfile = \"" + file + "\"\n"}) {
    CloudBuilder builder(ocl::select_device(), scene_of(""));
    builder.begin(scene_of(long_one), Haste::let_finish);
    const auto is_on_the_way = [&] {
      const auto progress = builder.progress();
      return progress && progress->share > 0.0;
    };
    while (!is_on_the_way() && builder.progress()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_TRUE(is_on_the_way()) << long_one;
    const auto begin = std::chrono::steady_clock::now();
    builder.begin(scene_of(two), Haste::interrupt);
    builder.wait();
    const auto made = builder.take();
    ASSERT_TRUE(made && std::holds_alternative<BuiltClouds>(*made));
    EXPECT_EQ(std::get<BuiltClouds>(*made).scene.clouds.size(), 2u);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30)) << long_one;
  }
}

}  // namespace
}  // namespace offing::present
