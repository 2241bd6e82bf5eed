#include <chrono>
#include <filesystem>
#include <fstream>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "host/base/error.h"
#include "host/base/host_memory.h"
#include "host/base/work.h"
#include "host/cli/ocean/bake.h"
#include "host/cli/ocean/frame_maker.h"
#include "tests/cli/folder_content.h"
#include "tests/io/temporary_folder.h"
#include "tests/ocl/expect_error.h"

// A bake on several devices: threads that simulate, one that writes, and what they share.

namespace offing::cli {
namespace {

scene::Sea small_sea() {
  scene::Scene scene;
  scene.ocean.parameters.size = 32;
  scene.ocean.patch_lengths_m = {200.0};
  return scene::prepare_sea(scene);
}

/// Bakes a small sea on `devices` devices, which are one device opened several times.
BakeSummary bake_on(std::size_t devices, const std::filesystem::path& folder, const FrameRange& frames,
                    const CancelToken& cancel) {
  const scene::Sea sea = small_sea();
  BakeSettings settings;
  settings.folder = folder;
  settings.frames = frames;
  settings.channels.set(static_cast<std::size_t>(ChannelGroup::displacement));
  settings.channels.set(static_cast<std::size_t>(ChannelGroup::foam));
  const FrameFiles files(settings, static_cast<int>(sea.parameters.cascades.size()), "hash");
  files.prepare_folder();
  FrameWriter writer(sea, settings, files, "hash", "a sea");
  Progress progress(frames.last - frames.first + 1, "frames", Verbosity::quiet);
  return bake(std::vector(devices, ocl::select_device()), sea, settings, files, writer, progress, cancel);
}

// Fails if devices that work at once take a frame twice, leave one out, or mix their fields up; the second
// time, if they do not agree that all is there.
TEST(BakeMakers, ShareTheFrames) {
  const TemporaryFolder one, three;
  EXPECT_EQ(bake_on(1, one.path(), {0, 11}, {}).written, 12);
  EXPECT_EQ(bake_on(3, three.path(), {0, 11}, {}).written, 12);
  EXPECT_TRUE(test::folder_content(three.path()) == test::folder_content(one.path()));
  EXPECT_EQ(bake_on(3, three.path(), {0, 11}, {}).kept, 12);
}

/// What a frame's arrays take.
std::size_t bytes_of(const BakedFrame& frame) {
  std::size_t floats = frame.mesh.positions_xyz.size() + frame.mesh.normals_xyz.size();
  const auto add = [&](const BakedFrame::CascadeFields& fields) {
    const ocean::SurfaceFields& of = fields.surface;
    for (const std::vector<float>* values :
         {&of.displacement_x, &of.displacement_y, &of.displacement_z, &of.slope_x, &of.slope_z,
          &of.gradient_xx, &of.gradient_xz, &of.gradient_zz, &of.jacobian, &of.jacobian_min_eigenvalue,
          &fields.foam, &fields.velocity.x, &fields.velocity.y, &fields.velocity.z}) {
      floats += values->size();
    }
  };
  for (const BakedFrame::CascadeFields& fields : frame.cascades) add(fields);
  if (frame.first_with_gerstner) add(*frame.first_with_gerstner);
  return floats * sizeof(float);
}

// Fails if the memory that a bake is refused for is not what its frames take.
TEST(BakeMakers, KnowWhatAFrameTakes) {
  scene::Scene scene;
  scene.ocean.parameters.size = 32;
  scene.ocean.patch_lengths_m = {200.0, 30.0};
  scene.ocean.gerstner_count = 8;
  const scene::Sea sea = scene::prepare_sea(scene);
  const ocl::Device device = ocl::Device::open();
  BakeSettings settings;
  settings.channels.set(static_cast<std::size_t>(ChannelGroup::displacement));
  EXPECT_EQ(bytes_of(FrameMaker(device, sea, settings).make(0)), frame_bytes(settings, 32, 2));
  settings.channels.set(static_cast<std::size_t>(ChannelGroup::foam));
  settings.channels.set(static_cast<std::size_t>(ChannelGroup::velocity));
  settings.mesh = MeshFormat::ply;
  settings.gerstner = GerstnerUse::included;
  EXPECT_EQ(bytes_of(FrameMaker(device, sea, settings).make(0)), frame_bytes(settings, 32, 2));
}

/// Resident memory of this process.
double resident_bytes() {
  give_back_freed_memory();
  long pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// Fails if the memory that seas are counted with is not what they take. Bound: drivers and programs take some
// megabytes beside them. Gate a tenth.
TEST(BakeMakers, KnowWhatASeaTakes) {
#if defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer keeps as much memory for itself";
#endif
  scene::Scene scene;
  scene.ocean.parameters.size = 1024;
  scene.ocean.patch_lengths_m = {200.0, 30.0};
  const scene::Sea sea = scene::prepare_sea(scene);
  const ocl::Device device = ocl::Device::open();
  if (device.info().type != ocl::DeviceType::cpu) GTEST_SKIP() << "its memory is not the host's";
  BakeSettings settings;
  settings.channels.set(static_cast<std::size_t>(ChannelGroup::foam));
  settings.channels.set(static_cast<std::size_t>(ChannelGroup::velocity));
  FrameMaker(device, sea, settings).make(0);  // compiles
  const double before = resident_bytes();
  FrameMaker maker(device, sea, settings);
  maker.make(0);
  const double expected = static_cast<double>(sea_bytes(settings, sea));
  EXPECT_NEAR(resident_bytes() - before, expected, 0.1 * expected);
}

// Fails if the room is looked for as if each device were alone: 2^18 of them fit one by one, but not
// together.
TEST(BakeMakers, NeedRoomForAllDevices) {
  scene::Scene scene;
  scene.ocean.parameters.size = 256;
  scene.ocean.patch_lengths_m = {200.0};
  const scene::Sea sea = scene::prepare_sea(scene);
  BakeSettings settings;
  settings.folder = "out";
  settings.frames = {0, 9};
  ocl::DeviceInfo cpu = ocl::select_device();
  cpu.type = ocl::DeviceType::cpu;
  require_host_room(settings, sea, std::vector(1, cpu));
  test::expect_error(ErrorKind::out_of_memory,
                     "out: 10 frames at once of 1 cascades of 256 x 256 samples, and the seas of 262144 ",
                     [&] { require_host_room(settings, sea, std::vector(std::size_t{1} << 18, cpu)); });
  ocl::DeviceInfo gpu = cpu;
  gpu.type = ocl::DeviceType::gpu;
  gpu.has_host_unified_memory = false;
  require_host_room(settings, sea, std::vector(std::size_t{1} << 18, gpu));
}

// Fails if a bake goes on after it was cancelled from another thread (it would for hours), or if what it
// leaves is not exactly the frames that it counts.
TEST(BakeMakers, StopWhenCancelled) {
  const TemporaryFolder folder;
  CancelToken cancel;
  const std::jthread user([&](const std::stop_token& end) {
    while (!end.stop_requested() && std::filesystem::is_empty(folder.path())) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    cancel.cancel();
  });
  try {
    bake_on(3, folder.path(), {0, 999'999}, cancel);
    FAIL() << "a million frames in no time";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cancelled);
    const std::size_t files = test::folder_content(folder.path()).size();
    EXPECT_THAT(error.what(),
                testing::HasSubstr("with " + std::to_string(files) + " of 1000000 frames done"));
  }
}

// Fails if steps told by several threads are lost or counted twice, or the last line comes more than once.
TEST(Progress, CountsTheStepsOfAllThreads) {
  testing::internal::CaptureStderr();
  {
    Progress progress(4000, "steps", Verbosity::normal);
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&progress] {
        for (int step = 0; step < 500; ++step) {
          progress.advance();
          progress.skip();
        }
      });
    }
  }
  const std::string told = testing::internal::GetCapturedStderr();
  const std::size_t last = told.find("4000/4000 steps");
  EXPECT_NE(last, std::string::npos) << told;
  EXPECT_EQ(told.find("4000/4000 steps", last + 1), std::string::npos) << told;
}

}  // namespace
}  // namespace offing::cli
