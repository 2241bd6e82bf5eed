#include "host/ocl/tuning.h"

#include <array>
#include <cstdlib>

#include <fmt/format.h>

#include "host/base/error.h"

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
constexpr KernelTuning strip{KernelShape::strip};
constexpr KernelTuning group{KernelShape::group};
constexpr std::array rows{
    TuningRow{"fft", DeviceClass::vector_cpu, strip},
    TuningRow{"gerstner", DeviceClass::vector_cpu, strip},
    TuningRow{"terrain", DeviceClass::vector_cpu, strip},
    TuningRow{"highlights", DeviceClass::vector_cpu, strip},
    TuningRow{"clouds", DeviceClass::vector_cpu, strip},
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

KernelTuning with_override(KernelTuning tuning) {
  const std::string_view shape = forced_shape();
  if (shape.empty()) return tuning;
  if (shape == "strip") return strip;
  if (shape == "group") return group;
  throw Error(ErrorKind::bad_usage, fmt::format("OFFING_SHAPE: expected strip or group, got \"{}\"", shape),
              "unset OFFING_SHAPE to let the device decide");
}

}  // namespace

KernelTuning tuning_for(const DeviceInfo& device, std::string_view family) {
  const DeviceClass device_class = class_of(device);
  for (const TuningRow& row : rows) {
    if (row.family == family && row.device_class == device_class) return with_override(row.tuning);
  }
  return with_override(group);  // the default row: right everywhere, if not fast
}

bool shape_is_forced() {
  return !forced_shape().empty();
}

}  // namespace offing::ocl
