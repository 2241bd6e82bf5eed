// The C interface, as a program with a bug might call it: each input is a list of calls with any arguments
// but pointers to nowhere. One device and one world serve all inputs; other worlds are made of scenes of 16 x
// 16 samples.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fuzzer/FuzzedDataProvider.h>
#include <spdlog/spdlog.h>

#include "host/c/offing.h"
#include "tests/fuzz/expect.h"

namespace {

using offing::fuzz::expect;

constexpr const char* scene_text =
    "version = 1\n[ocean]\nsize = 16\ncascade_count = 1\ngerstner.count = 2\n[[ocean.cascade]]\npatch_m = "
    "100\n"
    "[[ocean.swell]]\namplitude_m = 0.3\n";

/// What has failed says why on one line; pointers that a call was to fill are as they were.
bool is_done(OffingStatus status) {
  if (status == OFFING_OK) return true;
  expect(status == OFFING_FAILED || status == OFFING_BAD_INPUT || status == OFFING_NO_DEVICE);
  expect(*offing_last_error() != '\0' && std::strchr(offing_last_error(), '\n') == nullptr);
  expect(std::strchr(offing_last_hint(), '\n') == nullptr);
  return false;
}

OffingDevice* device() {
  static OffingDevice* const opened = [] {
    OffingDevice* made = nullptr;
    expect(is_done(offing_open_device("", &made)));
    return made;
  }();
  return opened;
}

OffingWorld* make_world(const std::string& text) {
  OffingScene* scene = nullptr;
  OffingWorld* world = nullptr;
  if (!is_done(offing_parse_scene(text.c_str(), "/nowhere", &scene))) return nullptr;
  is_done(offing_make_world(device(), scene, &world));
  offing_free_scene(scene);
  return world;
}

OffingWorld* shared_world() {
  static OffingWorld* const world = make_world(scene_text);
  return world;
}

double any_number(FuzzedDataProvider& bytes) {
  switch (bytes.ConsumeIntegralInRange(0, 3)) {
    case 0:
      return bytes.ConsumeFloatingPoint<double>();
    case 1:
      return bytes.ConsumeFloatingPointInRange(-1e4, 1e4);
    case 2:
      return bytes.PickValueInArray({0.0, -0.0, 1e8, -1e8, 2e7, 1e-300, 1e300});
    default:
      return bytes.PickValueInArray({std::numeric_limits<double>::quiet_NaN(),
                                     std::numeric_limits<double>::infinity(),
                                     -std::numeric_limits<double>::infinity()});
  }
}

void sample(FuzzedDataProvider& bytes, OffingWorld* world) {
  std::vector<OffingPoint> points(bytes.ConsumeIntegralInRange<std::size_t>(0, 40));
  for (OffingPoint& point : points) point = {any_number(bytes), any_number(bytes)};
  const OffingQuery query{any_number(bytes), any_number(bytes)};
  const OffingQuery* const asked = bytes.ConsumeBool() ? &query : nullptr;
  std::vector<OffingSample> samples(points.size());
  if (bytes.ConsumeIntegralInRange(0, 15) == 0) {
    is_done(offing_sample(world, asked, nullptr, points.size(), samples.data()));
    is_done(offing_sample(world, asked, points.data(), points.size(), nullptr));
    return;
  }
  if (!is_done(offing_sample(world, asked, points.data(), points.size(), samples.data()))) return;
  for (const OffingSample& found : samples) {
    expect(std::isfinite(found.height_m) && std::isfinite(found.pressure_pa));
    for (int axis = 0; axis < 3; ++axis)
      expect(std::isfinite(found.normal[axis]) && std::isfinite(found.velocity_mps[axis]));
  }
}

void read(FuzzedDataProvider& bytes, OffingWorld* world) {
  const int cascade = bytes.ConsumeBool() ? 0 : bytes.ConsumeIntegral<int>();
  const auto field = static_cast<OffingField>(bytes.ConsumeIntegralInRange(0, 7));
  const auto side = static_cast<std::size_t>(offing_map_size(world));
  std::vector<float> values(side * side + 1);
  const std::size_t count = bytes.ConsumeBool() ? side * side : bytes.ConsumeIntegral<std::size_t>();
  if (!is_done(offing_read(world, cascade, field,
                           bytes.ConsumeIntegralInRange(0, 15) == 0 ? nullptr : values.data(), count)))
    return;
  expect(count == side * side && cascade == 0);
  for (std::size_t i = 0; i < count; ++i) expect(std::isfinite(values[i]));
}

/// The scene of a small sea; where a byte says so, as the input has it. A world takes a hundred times as long
/// as any other call, so that only one in two hundred is made; the first one always, so that a finding can be
/// repeated.
void make_other_world(FuzzedDataProvider& bytes) {
  static int asked = 0;
  if (asked++ % 200 != 0) return;
  std::string text = scene_text;
  for (const char* key : {"fetch_m", "depth_m", "gamma", "wind_speed_mps", "choppiness"}) {
    if (!bytes.ConsumeBool()) continue;
    text.insert(text.find("size"),
                fmt::format("{} = {:.6e}\n", key, bytes.ConsumeFloatingPointInRange(-10.0, 1e4)));
  }
  OffingWorld* const world = make_world(text);
  if (world != nullptr) {
    sample(bytes, world);
    read(bytes, world);
  }
  offing_free_world(world);
}

void parse(FuzzedDataProvider& bytes) {
  OffingScene* scene = nullptr;
  const std::string text = bytes.ConsumeRandomLengthString(400);
  if (is_done(offing_parse_scene(text.c_str(), bytes.ConsumeBool() ? nullptr : "/nowhere", &scene))) {
    offing_free_scene(scene);
  } else {
    expect(scene == nullptr);
  }
}

void pass_nothing() {
  OffingWorld* world = nullptr;
  OffingScene* scene = nullptr;
  OffingSample found;
  const OffingPoint point{};
  float value = 0.0f;
  expect(!is_done(offing_open_device("", nullptr)) &&
         !is_done(offing_open_device("no such device", nullptr)));
  expect(!is_done(offing_parse_scene(nullptr, nullptr, &scene)) &&
         !is_done(offing_parse_scene("", "", nullptr)));
  expect(!is_done(offing_load_scene(nullptr, &scene)) &&
         !is_done(offing_load_scene("/nowhere/a.toml", &scene)));
  expect(!is_done(offing_make_world(nullptr, nullptr, &world)) && !is_done(offing_frame(nullptr, 0.0)));
  expect(!is_done(offing_sample(nullptr, nullptr, &point, 1, &found)));
  expect(!is_done(offing_read(nullptr, 0, OFFING_FOAM, &value, 1)));
  expect(offing_cascade_count(nullptr) == 0 && offing_map_size(nullptr) == 0);
  expect(offing_patch_length_m(nullptr, 0) == 0.0 && *offing_device_name(nullptr) == '\0');
  offing_free_scene(nullptr);
  offing_free_world(nullptr);
  offing_close_device(nullptr);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  spdlog::set_level(spdlog::level::off);
  expect(shared_world() != nullptr);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  OffingWorld* const world = shared_world();
  static bool is_at_zero = false;  // what earlier inputs left does not count
  if (!is_at_zero) is_done(offing_frame(world, 0.0));
  is_at_zero = true;
  for (int call = 0; call < 8 && bytes.remaining_bytes() > 0; ++call) {
    switch (bytes.ConsumeIntegralInRange(0, 31)) {
      case 0:
        make_other_world(bytes);
        break;
      case 1:
        pass_nothing();
        break;
      case 2:
      case 3:
      case 4:
      case 5:
        parse(bytes);
        break;
      case 6:
      case 7: {
        const int cascade = bytes.ConsumeIntegral<int>();
        expect(offing_patch_length_m(world, cascade) == (cascade == 0 ? 100.0 : 0.0));
        break;
      }
      case 8:
      case 9:
      case 10:
      case 11:
      case 12:
      case 13:
        is_done(offing_frame(world, any_number(bytes)));
        is_at_zero = false;
        break;
      case 14:
      case 15:
      case 16:
      case 17:
        read(bytes, world);
        break;
      default:
        sample(bytes, world);
    }
  }
  return 0;
}
