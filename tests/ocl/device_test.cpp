#include "host/ocl/device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ocl/child_process.h"
#include "tests/ocl/expect_error.h"
#include "tests/ocl/scoped_environment.h"

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

using ::testing::HasSubstr;
using ::testing::StartsWith;

// Fails if a figure is read with the wrong type or unit: they would be zero or absurd.
TEST(DeviceTest, ReportsPlausibleFigures) {
  const std::vector<DeviceInfo> devices = list_devices();
  ASSERT_FALSE(devices.empty());
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const DeviceInfo& device = devices[i];
    SCOPED_TRACE(device.name);
    EXPECT_EQ(device.index, static_cast<int>(i));
    EXPECT_FALSE(device.name.empty());
    EXPECT_FALSE(device.platform.empty());
    EXPECT_THAT(device.device_version, StartsWith("OpenCL "));
    EXPECT_THAT(device.c_version, StartsWith("OpenCL C "));
    EXPECT_FALSE(device.driver_version.empty());
    EXPECT_GE(device.global_memory_bytes, device.reported_global_memory_bytes);
    EXPECT_GE(device.reported_global_memory_bytes, std::uint64_t{64} << 20);
    EXPECT_LE(device.max_allocation_bytes, device.global_memory_bytes);
    EXPECT_GE(device.local_memory_bytes, 16u << 10);  // 32 KiB in the full profile, 16 in OpenCL 1.0
    EXPECT_GE(device.compute_units, 1u);
    EXPECT_GE(device.max_work_group_size, 1u);
    EXPECT_GE(device.base_address_alignment_bytes, 4u);
  }
}

TEST(DeviceTest, OpensEachListedDevice) {
  for (const DeviceInfo& info : list_devices()) {
    const Device device = Device::open(info);
    EXPECT_EQ(device.info().name, info.name);
    EXPECT_FALSE(device.is_profiling());
    EXPECT_NO_THROW(device.flush());
    EXPECT_NO_THROW(device.finish());
  }
}

TEST(DeviceTest, ObeysTheEnvironmentUnlessASelectorIsGiven) {
  const test::ScopedEnvironment environment("OFFING_DEVICE", "no such device");
  test::expect_error(ErrorKind::no_device, "OFFING_DEVICE: no OpenCL device fits \"no such device\"",
                     [] { select_device(); });
  EXPECT_EQ(select_device("0").index, 0);
}

TEST(DeviceTest, RefusesADeviceThatIsGone) {
  DeviceInfo gone = select_device();
  gone.name = "unplugged";
  test::expect_error(ErrorKind::no_device, "device 0 \"unplugged\"", [&] {
    gone.index = 0;
    Device::open(gone);
  });
}

// Fails if a machine without drivers gets anything but exit 3 and the package to install.
TEST(DeviceTest, SaysWhatToInstallWithoutAPlatform) {
  if (select_device().platform == "Oclgrind")
    GTEST_SKIP() << "Oclgrind brings its platform into every process";
  const test::ScopedEnvironment no_vendors("OCL_ICD_VENDORS", "/nonexistent");
  test::ChildProcess child({"devices"});
  EXPECT_EQ(child.exit_status(), 3);
  EXPECT_THAT(child.output(),
              StartsWith("error: no OpenCL platform: expected at least one driver, found none"));
  EXPECT_THAT(child.output(), HasSubstr("hint: install an OpenCL driver"));
  EXPECT_THAT(child.output(), HasSubstr("pocl-opencl-icd"));
}

// PoCL hides its device where it cannot make its cache folder; fails if the quirk does not give it another.
TEST(DeviceTest, SurvivesAHomeThatCannotBeWritten) {
  const TemporaryFolder cache;
  const test::ScopedEnvironment home("HOME", "/proc");
  const test::ScopedEnvironment xdg("XDG_CACHE_HOME", "/proc/nonexistent");
  for (const std::string& own_cache : {cache.path().string(), std::string("/proc/nonexistent")}) {
    const test::ScopedEnvironment own("OFFING_CACHE_DIR", own_cache);
    test::ChildProcess child({"devices"});
    EXPECT_EQ(child.exit_status(), 0) << child.output();
  }
}

// Host memory that is refused must end as an error that names the buffer, not in a crash or the system's
// killer.
TEST(DeviceTest, NamesTheBufferThatHostMemoryCannotHold) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers reserve more address space than the limit of this test";
#endif
  const DeviceInfo info = select_device();
  if (info.type != DeviceType::cpu) GTEST_SKIP() << info.name << " has memory of its own";
  test::ChildProcess child({"memory", std::to_string(std::size_t{192} << 20)});
  EXPECT_EQ(child.exit_status(), 1);
  EXPECT_THAT(child.output(), HasSubstr("buffer \"too large\" of 201326592 bytes on " + info.name));
  EXPECT_THAT(child.output(), HasSubstr("hint: use a smaller --size"));
}

}  // namespace
}  // namespace offing::ocl
