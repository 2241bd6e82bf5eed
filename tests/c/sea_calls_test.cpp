// The sea of a world in arrays of the caller's, on host and device.
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/c/offing.h"
#include "host/ocean/query/water_query.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "tests/c/sized.h"
#include "tests/c/small_sea.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

using testing::HasSubstr;

class SeaCallsTest : public SmallSea {
 protected:
  static constexpr std::size_t texels = 64 * 64;

  std::vector<float> field(OffingField name) {
    std::vector<float> values(texels);
    EXPECT_EQ(offing_read(world(), 0, name, values.data(), texels), OFFING_OK) << offing_last_error();
    return values;
  }
};

// Fails if an array is filled from another quantity than its name says, or quantities that are not wanted
// change the others.
TEST_F(SeaCallsTest, FillsTheArraysThatAreWanted) {
  const std::vector<double> points{0.0, 0.0, 31.5, -12.25, 1e5, 2e5};
  const std::array<OffingPoint, 3> places{{{0.0, 0.0}, {31.5, -12.25}, {1e5, 2e5}}};
  std::array<OffingSample, 3> expected{};
  const OffingQuery old_query{.depth_m = 1.5, .min_wavelength_m = 4.0};
  ASSERT_EQ(offing_frame(world(), 3.25), OFFING_OK);
  ASSERT_EQ(offing_sample(world(), &old_query, places.data(), 3, expected.data()), OFFING_OK);

  OffingWaterQuery query{};
  query.size = sizeof query;
  query.depth_m = 1.5;
  query.min_wavelength_m = 4.0;
  std::array<float, 3> height{}, pressure{}, residual{};
  std::array<float, 9> normal{}, velocity{};
  std::array<float, 3> error{};
  std::array<float, 9> acceleration{};
  std::array<float, 36> full{};
  const OffingWater all{sizeof all,      height.data(), normal.data(),       velocity.data(), pressure.data(),
                        residual.data(), nullptr,       acceleration.data(), error.data(),    full.data()};
  ASSERT_EQ(offing_sample_water(world(), &query, points.data(), 3, &all), OFFING_OK) << offing_last_error();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(height[i], expected[i].height_m);
    EXPECT_EQ(pressure[i], expected[i].pressure_pa);
    EXPECT_EQ(residual[i], expected[i].residual_m);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(normal[3 * i + axis], expected[i].normal[axis]);
      EXPECT_EQ(velocity[3 * i + axis], expected[i].velocity_mps[axis]);
      EXPECT_EQ(full[12 * i + 8 + axis], acceleration[3 * i + axis]);
    }
    EXPECT_NE(acceleration[3 * i + 1], 0.0f);
    EXPECT_EQ(full[12 * i], height[i]);
    EXPECT_EQ(full[12 * i + 11], error[i]);
    EXPECT_GT(error[i], 0.0f);
  }
  // A caller built before accelerations were there.
  OffingWater earlier = all;
  earlier.size = offsetof(OffingWater, acceleration_mps2);
  acceleration.fill(1.0f);
  ASSERT_EQ(offing_sample_water(world(), &query, points.data(), 3, &earlier), OFFING_OK);
  EXPECT_EQ(acceleration[0], 1.0f);
  // An answer of a frame's maps, and one that there is not.
  query.accuracy = OFFING_ACCURACY_FRAME_MAPS;
  ASSERT_EQ(offing_sample_water(world(), &query, points.data(), 3, &all), OFFING_OK);
  EXPECT_EQ(acceleration[1], 0.0f);
  query.accuracy = 4;
  EXPECT_EQ(offing_sample_water(world(), &query, points.data(), 3, &all), OFFING_BAD_INPUT);
  query.accuracy = OFFING_ACCURACY_AUTOMATIC;
  ASSERT_EQ(offing_sample_water(world(), &query, points.data(), 3, &all), OFFING_OK);
  std::array<float, 3> alone{};
  OffingWater height_only{};
  height_only.size = sizeof height_only;
  height_only.height_m = alone.data();
  ASSERT_EQ(offing_sample_water(world(), &query, points.data(), 3, &height_only), OFFING_OK);
  EXPECT_EQ(alone, height);
  std::array<float, 24> samples{};
  OffingWater as_written{};
  as_written.size = sizeof as_written;
  as_written.samples = samples.data();
  ASSERT_EQ(offing_sample_water(world(), &query, points.data(), 3, &as_written), OFFING_OK);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(samples[8 * i], height[i]);
    EXPECT_EQ(samples[8 * i + 3], residual[i]);
    EXPECT_EQ(samples[8 * i + 5], velocity[3 * i + 1]);
    EXPECT_EQ(samples[8 * i + 7], pressure[i]);
  }
  query.is_surface_only = 1;
  ASSERT_EQ(offing_sample_water(world(), &query, points.data(), 3, &as_written), OFFING_OK);
  EXPECT_EQ(samples[0], height[0]);
  EXPECT_EQ(samples[7], 0.0f);
}

// Fails if fields that are read together differ from those read one by one, or one is missing.
TEST_F(SeaCallsTest, ReadsFieldsTogether) {
  constexpr std::array fields{OFFING_DISPLACEMENT_X,
                              OFFING_DISPLACEMENT_Y,
                              OFFING_DISPLACEMENT_Z,
                              OFFING_SLOPE_X,
                              OFFING_SLOPE_Z,
                              OFFING_JACOBIAN,
                              OFFING_FOAM,
                              OFFING_GRADIENT_XX,
                              OFFING_GRADIENT_XZ,
                              OFFING_GRADIENT_ZZ,
                              OFFING_JACOBIAN_MIN_EIGENVALUE,
                              OFFING_VELOCITY_X,
                              OFFING_VELOCITY_Y,
                              OFFING_VELOCITY_Z};
  ASSERT_EQ(offing_frame(world(), 5.0), OFFING_OK);
  std::vector<std::vector<float>> together(fields.size(), std::vector<float>(texels, -7.0f));
  std::vector<float*> targets;
  for (std::vector<float>& values : together) targets.push_back(values.data());
  ASSERT_EQ(offing_read_fields(world(), 0, fields.data(), fields.size(), targets.data(), texels), OFFING_OK)
      << offing_last_error();
  for (std::size_t i = 0; i < fields.size(); ++i) EXPECT_EQ(together[i], field(fields[i])) << fields[i];
  // J = (1 + xx)(1 + zz) - xz^2 of the fields of this texel.
  for (const std::size_t texel : {std::size_t{0}, std::size_t{777}, texels - 1}) {
    const float xx = together[7][texel], xz = together[8][texel], zz = together[9][texel];
    EXPECT_NEAR(together[5][texel], (1.0f + xx) * (1.0f + zz) - xz * xz, 1e-5f);
  }
}

// Fails if the sea of the waves that are written is another one; their amplitudes are floats of the device.
TEST_F(SeaCallsTest, WritesTheWavesOfTheSea) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "sea.csv").string();
  ASSERT_EQ(offing_write_modes(world(), file.c_str()), OFFING_OK) << offing_last_error();
  OffingScene* scene = nullptr;
  OffingWorld* again = nullptr;
  ASSERT_EQ(
      offing_parse_scene(("version = 1\n[ocean]\nmodes_file = \"" + file + "\"\n").c_str(), nullptr, &scene),
      OFFING_OK);
  ASSERT_EQ(offing_make_world(device(), scene, &again), OFFING_OK) << offing_last_error();
  const OffingPoint point{12.0, -7.0};
  OffingSample expected{}, found{};
  const OffingQuery query{};
  for (const auto& [sea, sample] : {std::pair(world(), &expected), std::pair(again, &found)}) {
    EXPECT_EQ(offing_frame(sea, 77.25), OFFING_OK);
    EXPECT_EQ(offing_sample(sea, &query, &point, 1, sample), OFFING_OK);
  }
  EXPECT_NEAR(found.height_m, expected.height_m, 1e-5);
  offing_free_world(again);
  offing_free_scene(scene);
  EXPECT_NE(offing_write_modes(world(), "/no/such/folder/a.nc"), OFFING_OK);
}

// Fails if a field on the device is not that on the host, or begins elsewhere.
TEST_F(SeaCallsTest, CopiesFieldsOnTheDevice) {
  const auto context = static_cast<cl_context>(offing_device_context(device()));
  const auto queue = static_cast<cl_command_queue>(offing_device_queue(device()));
  const ocl::Device same = ocl::Device::adopt(context, queue);
  const ocl::Buffer<float> buffer(same, std::vector<float>(texels + 3, -7.0f), "values");
  for (const OffingField name : {OFFING_DISPLACEMENT_Y, OFFING_JACOBIAN}) {
    ASSERT_EQ(offing_copy_field(world(), 0, name, buffer.handle(), 2), OFFING_OK) << offing_last_error();
    const std::vector<float> found = buffer.read(), expected = field(name);
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), found.begin() + 2));
    EXPECT_EQ(found[1], -7.0f);
    EXPECT_EQ(found.back(), -7.0f);
  }
  EXPECT_EQ(offing_copy_field(world(), 0, OFFING_SLOPE_X, buffer.handle(), texels), OFFING_BAD_INPUT);
  EXPECT_EQ(offing_copy_field(world(), 0, OFFING_FOAM, buffer.handle(), 0), OFFING_BAD_INPUT);
  const ocl::Device other = ocl::Device::open();
  const ocl::Buffer<float> foreign(other, texels, "foreign");
  EXPECT_EQ(offing_copy_field(world(), 0, OFFING_SLOPE_X, foreign.handle(), 0), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_error(), HasSubstr("context"));
}

// Fails if samples on the device are not those on the host.
TEST_F(SeaCallsTest, SamplesOnTheDevice) {
  const ocl::Device same = ocl::Device::adopt(static_cast<cl_context>(offing_device_context(device())),
                                              static_cast<cl_command_queue>(offing_device_queue(device())));
  const ocl::Buffer<SurfaceQueryPoint> points(
      same, std::vector<SurfaceQueryPoint>{{0, 0, 1.5f, 2.5f}, {1, -1, 0.0f, 3.0f}}, "points");
  const ocl::Buffer<ocean::FirstWaterFloats> samples(same, 2, "samples");
  ASSERT_EQ(offing_sample_water_on_device(world(), nullptr, points.handle(), 2, samples.handle()), OFFING_OK)
      << offing_last_error();
  const std::vector<double> places{1.5, 2.5, 64.0, -61.0};
  std::array<float, 2> height{};
  std::array<float, 24> full{};
  OffingWater water{};
  water.size = sizeof water;
  water.height_m = height.data();
  water.full_samples = full.data();
  ASSERT_EQ(offing_sample_water(world(), nullptr, places.data(), 2, &water), OFFING_OK);
  const std::vector<ocean::FirstWaterFloats> found = samples.read();
  EXPECT_EQ(found[0][0], height[0]);
  EXPECT_EQ(found[1][0], height[1]);

  const ocl::Buffer<float> full_samples(same, std::vector<float>(24, -7.0f), "full samples");
  OffingWaterQuery query{};
  query.size = sizeof query;
  query.is_full = 1;
  ASSERT_EQ(offing_sample_water_on_device(world(), &query, points.handle(), 2, full_samples.handle()),
            OFFING_OK)
      << offing_last_error();
  EXPECT_EQ(full_samples.read(), std::vector<float>(full.begin(), full.end()));
  EXPECT_NE(full[9], 0.0f) << "acceleration";
  EXPECT_GT(full[11], 0.0f) << "expected error";
}

// Fails if a world on an adopted device is another sea, or a queue out of order is taken.
TEST_F(SeaCallsTest, RunsOnADeviceOfTheCaller) {
  const ocl::Device own = ocl::Device::open();
  OffingDevice* adopted = nullptr;
  ASSERT_EQ(offing_adopt_device(own.context(), own.queue(), &adopted), OFFING_OK) << offing_last_error();
  EXPECT_STREQ(offing_device_name(adopted), own.info().name.c_str());
  OffingWorld* other = nullptr;
  ASSERT_EQ(offing_make_world(adopted, scene(), &other), OFFING_OK) << offing_last_error();
  std::vector<float> values(texels);
  ASSERT_EQ(offing_read(other, 0, OFFING_DISPLACEMENT_Y, values.data(), texels), OFFING_OK);
  EXPECT_EQ(values, field(OFFING_DISPLACEMENT_Y));
  offing_free_world(other);
  offing_close_device(adopted);
  EXPECT_EQ(offing_adopt_device(own.context(), nullptr, &adopted), OFFING_BAD_INPUT);
  EXPECT_EQ(offing_adopt_device(own.context(), offing_device_queue(device()), &adopted), OFFING_BAD_INPUT);
}

// Fails if two threads get into one world, or the one that is refused learns no fix. Both call until they
// have met, which takes a few frames.
TEST_F(SeaCallsTest, RefusesASecondThread) {
  std::atomic<bool> have_met = false;
  std::string hint;
  const auto call = [&](std::string* hint_of_refusal) {
    for (int i = 0; i < 10000 && !have_met; ++i) {
      if (offing_frame(world(), 0.01 * i) != OFFING_BUSY) continue;
      have_met = true;
      if (hint_of_refusal != nullptr) *hint_of_refusal = offing_last_hint();
    }
  };
  std::thread other([&] { call(nullptr); });
  call(&hint);
  other.join();
  EXPECT_TRUE(have_met);
  if (!hint.empty()) {
    EXPECT_THAT(hint, HasSubstr("each thread"));
  }
  EXPECT_EQ(offing_frame(world(), 1.0), OFFING_OK);
}

// Fails if a call reads a scene while another thread gives it another spectrum: the state of the sea is then
// neither, or the program crashes. That is rare; the thread sanitizer always reports it.
TEST_F(SeaCallsTest, AThreadMayChangeAScene) {
  OffingScene* shared = nullptr;
  ASSERT_EQ(offing_parse_scene("version = 1\n[ocean]\nsize = 16\n", nullptr, &shared), OFFING_OK);
  const std::array<double, 3> frequencies_hz{0.08, 0.1, 0.2};
  std::array<OffingSpectra*, 2> spectra{};
  std::array<double, 2> hs_m{};
  const auto measured_hs_m = [&] {
    OffingSeaState state = sized<OffingSeaState>();
    EXPECT_EQ(offing_get_sea_state(shared, &state), OFFING_OK) << offing_last_error();
    return state.hs_m;
  };
  for (std::size_t i = 0; i < 2; ++i) {
    const std::array<double, 3> energy{1.0, 10.0 + 10.0 * static_cast<double>(i), 2.0};
    OffingSpectrum spectrum = sized<OffingSpectrum>();
    spectrum.frequency_count = 3;
    spectrum.frequencies_hz = frequencies_hz.data();
    spectrum.energy_m2phz = energy.data();
    ASSERT_EQ(offing_make_spectrum(&spectrum, &spectra[i]), OFFING_OK) << offing_last_error();
    ASSERT_EQ(offing_set_spectrum(shared, spectra[i], 0), OFFING_OK) << offing_last_error();
    hs_m[i] = measured_hs_m();
  }
  ASSERT_NE(hs_m[0], hs_m[1]);
  std::atomic<bool> is_done = false;
  std::thread other([&] {
    for (std::size_t i = 0; !is_done; i = 1 - i) {
      offing_set_spectrum(shared, spectra[i], 0);
      std::this_thread::sleep_for(std::chrono::microseconds(20));  // leaves the lock to the others
    }
  });
  for (int i = 0; i < 20; ++i) EXPECT_THAT(measured_hs_m(), testing::AnyOf(hs_m[0], hs_m[1]));
  OffingWorld* made = nullptr;
  EXPECT_EQ(offing_make_world(device(), shared, &made), OFFING_OK) << offing_last_error();
  is_done = true;
  other.join();
  offing_free_world(made);
  offing_free_scene(shared);
  for (OffingSpectra* const of : spectra) offing_free_spectra(of);
}

// Fails if a world is at another time than that of its scene's start or its last frame.
TEST_F(SeaCallsTest, TellsItsTime) {
  OffingScene* late = nullptr;
  OffingWorld* made = nullptr;
  ASSERT_EQ(offing_parse_scene("version = 1\n[time]\nstart_s = 7.5\n[ocean]\nsize = 16\n", nullptr, &late),
            OFFING_OK);
  ASSERT_EQ(offing_make_world(device(), late, &made), OFFING_OK) << offing_last_error();
  double time_s = 0.0;
  EXPECT_EQ(offing_get_time(made, &time_s), OFFING_OK);
  EXPECT_EQ(time_s, 7.5);
  ASSERT_EQ(offing_frame(made, 3.25), OFFING_OK);
  EXPECT_EQ(offing_get_time(made, &time_s), OFFING_OK);
  EXPECT_EQ(time_s, 3.25);
  EXPECT_EQ(offing_get_time(made, nullptr), OFFING_BAD_INPUT);
  offing_free_world(made);
  offing_free_scene(late);
}

// Fails if worlds on four threads disturb each other: all have the heights of one alone.
TEST_F(SeaCallsTest, WorldsRunOnThreads) {
  ASSERT_EQ(offing_frame(world(), 2.0), OFFING_OK);
  const std::vector<float> expected = field(OFFING_DISPLACEMENT_Y);
  std::array<std::vector<float>, 4> found;
  {
    std::vector<std::jthread> threads;
    for (std::vector<float>& values : found) {
      threads.emplace_back([this, &values] {
        OffingWorld* own = nullptr;
        if (offing_make_world(device(), scene(), &own) != OFFING_OK) return;
        values.resize(texels);
        for (int i = 0; i < 5; ++i) {
          offing_frame(own, 0.5 * i);
          offing_read(own, 0, OFFING_DISPLACEMENT_Y, values.data(), texels);
        }
        offing_free_world(own);
      });
    }
  }
  for (const std::vector<float>& values : found) EXPECT_EQ(values, expected);
}

// Fails if structs of an older program, which are shorter, are read or written past their end, or one whose
// size was forgotten is taken.
TEST_F(SeaCallsTest, TakesStructsOfOlderPrograms) {
  struct {
    OffingDeviceInfo info;
    char after = 'x';
  } memory{};
  memory.info.size = offsetof(OffingDeviceInfo, vendor);
  memory.info.vendor[0] = '?';
  ASSERT_EQ(offing_get_device_info(device(), &memory.info), OFFING_OK) << offing_last_error();
  EXPECT_STREQ(memory.info.name, offing_device_name(device()));
  EXPECT_EQ(memory.info.vendor[0], '?');
  EXPECT_EQ(memory.info.size, offsetof(OffingDeviceInfo, vendor));
  memory.info.size = 0;
  EXPECT_EQ(offing_get_device_info(device(), &memory.info), OFFING_BAD_INPUT);
  EXPECT_THAT(offing_last_hint(), HasSubstr("sizeof"));

  std::size_t count = 0;
  ASSERT_EQ(offing_list_devices(nullptr, 0, &count), OFFING_OK);
  ASSERT_GT(count, 0u);
  std::vector<OffingDeviceInfo> devices(count);
  for (OffingDeviceInfo& info : devices) info.size = sizeof info;
  ASSERT_EQ(offing_list_devices(devices.data(), count, &count), OFFING_OK) << offing_last_error();
  EXPECT_EQ(devices[0].index, 0);
  EXPECT_GT(devices[0].memory_bytes, 0u);
}

// Fails if lines of the log are lost, or go on to a program that wants them no longer.
TEST_F(SeaCallsTest, HandsTheLogToTheProgram) {
  std::vector<std::string> lines;
  const auto keep = [](void* user, OffingLogLevel level, const char* line) {
    if (level == OFFING_LOG_WARNING) static_cast<std::vector<std::string>*>(user)->push_back(line);
  };
  ASSERT_EQ(offing_set_log(keep, &lines), OFFING_OK);
  OffingScene* odd = nullptr;
  OffingWorld* made = nullptr;
  ASSERT_EQ(
      offing_parse_scene("version = 1\n[ocean]\nsize = 16\nspectrum = \"pm\"\ngamma = 3\n", nullptr, &odd),
      OFFING_OK);
  ASSERT_EQ(offing_make_world(device(), odd, &made), OFFING_OK);
  ASSERT_EQ(offing_set_log(nullptr, nullptr), OFFING_OK);
  EXPECT_THAT(lines, testing::ElementsAre(HasSubstr("gamma")));
  offing_free_world(made);
  offing_free_scene(odd);
}

}  // namespace
}  // namespace offing
