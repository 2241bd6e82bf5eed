#include "host/ocl/tuning.h"

#include <array>
#include <cstdlib>
#include <mutex>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"

namespace offing::ocl {
namespace {

enum class DeviceClass {
  vector_cpu,  // a CPU whose compiler makes wide vectors of float4 ... float16 (PoCL, Intel)
  other,  // many narrow lanes; CPU drivers built for scalar code (llvmpipe) need tens of seconds for wide
          // kernels
};

struct TuningRow {
  std::string_view family;
  DeviceClass device_class;
  KernelTuning tuning;
};

// Measured on PoCL 3.1 with AVX-512: explicit float16 code reaches 390 GFLOP/s, float8 204, work-items that
// PoCL vectorises itself half or less.
constexpr KernelTuning simd{KernelShape::simd};
constexpr KernelTuning workgroup{KernelShape::workgroup};
constexpr std::array rows{
    TuningRow{"fft", DeviceClass::vector_cpu, simd},
    TuningRow{"gerstner", DeviceClass::vector_cpu, simd},
    TuningRow{"terrain", DeviceClass::vector_cpu, simd},
    TuningRow{"highlights", DeviceClass::vector_cpu, simd},
    TuningRow{"clouds", DeviceClass::vector_cpu, simd},
};

DeviceClass class_of(const DeviceInfo& device) {
  const bool has_vectors = device.type == DeviceType::cpu && device.native_float_width >= 4;
  return has_vectors ? DeviceClass::vector_cpu : DeviceClass::other;
}

// Empty where the device decides.
std::string_view forced_shape() {
  const char* shape = std::getenv("OFFING_SHAPE");
  return shape == nullptr ? "" : shape;
}

struct EarlierValue {
  std::string_view earlier, value;
};
constexpr std::array earlier_values{EarlierValue{"strip", "simd"}, EarlierValue{"group", "workgroup"}};

// The value for one of its earlier names, with a warning at the first use.
std::string_view current_value(std::string_view shape) {
  static std::once_flag warned;
  for (const auto& [earlier, value] : earlier_values) {
    if (shape != earlier) continue;
    std::call_once(warned, [&] { spdlog::warn("OFFING_SHAPE={} is now OFFING_SHAPE={}", earlier, value); });
    return value;
  }
  return shape;
}

KernelTuning with_override(KernelTuning tuning) {
  const std::string_view shape = current_value(forced_shape());
  if (shape.empty()) return tuning;
  if (shape == "simd") return simd;
  if (shape == "workgroup") return workgroup;
  throw Error(ErrorKind::bad_usage,
              fmt::format("OFFING_SHAPE: expected simd or workgroup, got \"{}\"", shape),
              "unset OFFING_SHAPE to let the device decide");
}

}  // namespace

KernelTuning tuning_for(const DeviceInfo& device, std::string_view family) {
  const DeviceClass device_class = class_of(device);
  for (const TuningRow& row : rows) {
    if (row.family == family && row.device_class == device_class) return with_override(row.tuning);
  }
  return with_override(workgroup);  // the default row: right everywhere, if not fast
}

bool shape_is_forced() {
  return !forced_shape().empty();
}

}  // namespace offing::ocl
