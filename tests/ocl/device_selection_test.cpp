#include "host/ocl/device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ocl/expect_error.h"

namespace offing::ocl {
namespace {

using ::testing::HasSubstr;

DeviceInfo device(int index, const char* name, const char* platform, DeviceType type) {
  DeviceInfo info;
  info.index = index;
  info.name = name;
  info.platform = platform;
  info.type = type;
  return info;
}

const std::vector<DeviceInfo> machine{
    device(0, "pthread-Zen", "Portable Computing Language", DeviceType::cpu),
    device(1, "GeForce 4090", "NVIDIA CUDA", DeviceType::gpu),
    device(2, "GeForce 4090", "NVIDIA CUDA", DeviceType::gpu),
    device(3, "llvmpipe", "rusticl", DeviceType::cpu),
};

int chosen(std::string_view selector) {
  return choose_device(machine, selector).index;
}

TEST(DeviceSelectionTest, TakesAnIndex) {
  for (int index = 0; index < 4; ++index) EXPECT_EQ(chosen(std::to_string(index)), index);
}

// Fails if a type becomes ambiguous where several devices have it.
TEST(DeviceSelectionTest, TakesTheFirstOfAType) {
  EXPECT_EQ(chosen("cpu"), 0);
  EXPECT_EQ(chosen("GPU"), 1);
}

TEST(DeviceSelectionTest, TakesAPartOfNameOrPlatformInAnyCase) {
  EXPECT_EQ(chosen("ZEN"), 0);
  EXPECT_EQ(chosen("portable"), 0);
  EXPECT_EQ(chosen("Rusti"), 3);
}

// Fails if a number that is no index hides the devices whose names hold it.
TEST(DeviceSelectionTest, TakesANumberInANameThatIsNoIndex) {
  const std::vector<DeviceInfo> one_gpu{machine[0], machine[1]};
  EXPECT_EQ(choose_device(one_gpu, "4090").index, 1);
}

TEST(DeviceSelectionTest, PrefersGpuThenCpuThenAnything) {
  EXPECT_EQ(chosen(""), 1);
  EXPECT_EQ(choose_device({machine[3], machine[0]}, "").index, 3);
  EXPECT_EQ(choose_device({device(0, "dsp", "vendor", DeviceType::accelerator)}, "").name, "dsp");
}

// Fails if one of two equal devices is taken silently.
TEST(DeviceSelectionTest, ListsTheMatchesOfAnAmbiguousPart) {
  const std::string hint = test::expect_error(ErrorKind::no_device,
                                              "device \"geforce\" is ambiguous: it fits 1: GeForce 4090 "
                                              "(gpu, NVIDIA CUDA); 2: GeForce 4090 (gpu, NVIDIA CUDA)",
                                              [] { chosen("geforce"); });
  EXPECT_THAT(hint, HasSubstr("index"));
}

TEST(DeviceSelectionTest, ListsAllDevicesWhenNoneFits) {
  for (const char* selector : {"banana", "7", "-1", "accelerator", "0x1"}) {
    test::expect_error(ErrorKind::no_device,
                       std::string("no OpenCL device fits \"") + selector + "\": found 0: pthread-Zen",
                       [&] { chosen(selector); });
  }
}

}  // namespace
}  // namespace offing::ocl
