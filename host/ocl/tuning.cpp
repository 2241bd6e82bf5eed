#include "host/ocl/tuning.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <mutex>
#include <optional>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"

namespace offing::ocl {
namespace {

enum class DeviceClass {
  vector_cpu,  // a CPU whose compiler makes wide vectors of float4 ... float16 (PoCL, Intel)
  any,  // the default, for many narrow lanes. CPU drivers built for scalar code (llvmpipe) need tens of
        // seconds to compile wide kernels
};

struct TuningRow {
  std::string_view kernels;
  DeviceClass device_class;
  KernelTuning tuning;
};

using enum DeviceClass;
using enum KernelShape;

// Of rows with the same name, those for a class come first and the default last. The comment above them says
// what `lanes`, `group` and `per_item` count. On a CPU a `per_item` above 1 gives a work-item so much to do
// that its launch costs little beside it.
//
// Lanes were measured on PoCL 3.1 with AVX-512: explicit float16 code reaches 390 GFLOP/s, float8 204,
// work-items that PoCL vectorises itself half or less.
constexpr TuningRow table[] = {
    // Transforms along columns. Lanes: neighbouring columns; host/fft/fft_plan.cpp takes fewer if local
    // memory is short. Group: on a GPU, about how many work-items neighbouring columns share.
    {"fft_columns", vector_cpu, {.shape = simd, .lanes = 16, .group = 1}},
    {"fft_columns", any, {.shape = workgroup, .group = 256}},
    // Transforms along rows. Lanes: columns; a square of 8 stays in registers. Group: on a GPU, work-items
    // that short rows share. Per item: rows, few enough to leave work-items for many cores.
    {"fft_rows", vector_cpu, {.shape = simd, .lanes = 8, .group = 1, .per_item = 8}},
    {"fft_rows", any, {.shape = workgroup, .group = 64}},

    // Gerstner waves on a grid. Lanes: columns. Per item: rows, which share what is computed once.
    {"gerstner_surface", vector_cpu, {.shape = simd, .lanes = 16, .group = 1, .per_item = 4}},
    {"gerstner_surface", any, {.shape = workgroup}},
    // Water at points. Lanes: points. Per item: vectors of them. On a CPU each work-item has its own
    // group: the private memory of many would overflow the stack.
    {"surface_query", vector_cpu, {.shape = simd, .lanes = 16, .group = 1, .per_item = 8}},
    {"surface_query", any, {.shape = workgroup, .per_item = 8}},

    // Water at points by sums over modes. Lanes: columns of modes. Group: work-items that share the columns
    // of a point; a power of two.
    {"mode_sums", vector_cpu, {.shape = simd, .lanes = 16, .group = 1}},
    {"mode_sums", any, {.shape = workgroup, .group = 256}},

    // Rays over terrain. Lanes: rays, or the pixels along a side of a work-item's tile.
    {"terrain_rays", vector_cpu, {.shape = simd, .lanes = 16, .group = 1}},
    {"terrain_rays", any, {.shape = workgroup}},

    // The field whose zeros are highlights. Lanes: vertices. Per item: vectors of them.
    {"highlight_field", vector_cpu, {.shape = simd, .lanes = 16, .per_item = 32}},
    {"highlight_field", any, {.shape = workgroup}},
    // Its zeros. Per item: faces.
    {"highlight_points", vector_cpu, {.shape = simd, .per_item = 1024}},
    {"highlight_points", any, {.shape = workgroup}},

    // Keys by which particles are sorted. Per item: particles.
    {"order_key", vector_cpu, {.shape = simd, .per_item = 2048}},
    {"order_key", any, {.shape = workgroup}},
    // Passes of the radix sort. Per item: keys, at least. On a CPU there are three passes, whose 2048
    // counters stay in the first cache, and a second work-item pays from some thousand keys on. On a GPU 16
    // counters for each of 64 work-items are 4 KiB of local memory.
    {"radix_sort", vector_cpu, {.shape = simd, .group = 1, .per_item = 8192, .digit_bits = 11}},
    {"radix_sort", any, {.shape = workgroup, .group = 64, .per_item = 16, .digit_bits = 4}},
    // The sums between them, by one group.
    {"radix_scan", vector_cpu, {.shape = simd, .group = 1}},
    {"radix_scan", any, {.shape = workgroup, .group = 256}},

    // Density of clouds. Group: work-items that share the 64 rows of a brick; a power of two up to 64.
    {"cloud_density", vector_cpu, {.shape = simd, .group = 1}},
    {"cloud_density", any, {.shape = workgroup, .group = 64}},

    // The shadow map of clouds: from particles, into texels, and at places without a map. Per item: these.
    {"shadow_splat", vector_cpu, {.shape = simd, .per_item = 256}},
    {"shadow_splat", any, {.shape = workgroup}},
    {"shadow_resolve", vector_cpu, {.shape = simd, .per_item = 8192}},
    {"shadow_resolve", any, {.shape = workgroup}},
    {"shadow_points", vector_cpu, {.shape = simd, .per_item = 64}},
    {"shadow_points", any, {.shape = workgroup}},

    // Light in the grid of a cloud. Lanes: cells. Per item: vectors of them, of the largest grid, 16384
    // cells. On a CPU a cloud thus has two work-items, which keep the cores busy. On a GPU it has one for
    // each row of 16 cells or, in kernels that take cells in any order, one for four cells.
    {"light_density", vector_cpu, {.shape = simd, .lanes = 16, .group = 1, .per_item = 512}},
    {"light_density", any, {.shape = workgroup, .per_item = 16}},
    {"light_cells", vector_cpu, {.shape = simd, .lanes = 16, .group = 1, .per_item = 512}},
    {"light_cells", any, {.shape = workgroup, .per_item = 4}},
    // Kernels in which a group does a cloud, or a colour of it. Group: a power of two up to 256.
    {"light_groups", vector_cpu, {.shape = simd, .lanes = 16, .group = 1}},
    {"light_groups", any, {.shape = workgroup, .group = 256}},
    // What the eye sees of particles. Per item: particles.
    {"particle_scatter", vector_cpu, {.shape = simd, .group = 1, .per_item = 128}},
    {"particle_scatter", any, {.shape = workgroup}},

    // Which particles show in a tile of the image, a work-item a tile. Lanes: particles. A work-item has
    // 2 KB of private memory: drivers that run a group on one thread's stack get small groups.
    {"billboard_tiles", vector_cpu, {.shape = simd, .lanes = 16, .group = 1}},
    {"billboard_tiles", any, {.shape = workgroup, .group = 64}},
    // The tiles' pixels. Lanes: pixels. Group: on a GPU, the pixels of a tile, which see the same
    // particles.
    {"billboard_composite", vector_cpu, {.shape = simd, .lanes = 16, .group = 1}},
    {"billboard_composite", any, {.shape = workgroup, .group = 256}},

    // A body's motion. Group: work-items that share its faces; a power of two.
    {"body_advance", any, {.shape = workgroup, .group = 64}},
    // A hull in a wake window. Group: cells, in a square.
    {"hull_press", any, {.shape = workgroup, .group = 64}},
};

DeviceClass class_of(const DeviceInfo& device) {
  const bool has_vectors = device.type == DeviceType::cpu && device.native_float_width >= 4;
  return has_vectors ? vector_cpu : any;
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
    std::call_once(warned, [&earlier = earlier, &value = value] {
      spdlog::warn("OFFING_SHAPE={} is now OFFING_SHAPE={}", earlier, value);
    });
    return value;
  }
  return shape;
}

// The shape that OFFING_SHAPE names; none: the device decides.
std::optional<KernelShape> chosen_shape() {
  const std::string_view shape = current_value(forced_shape());
  if (shape.empty()) return std::nullopt;
  if (shape == "simd") return simd;
  if (shape == "workgroup") return workgroup;
  throw Error(ErrorKind::bad_usage,
              fmt::format("OFFING_SHAPE: expected simd or workgroup, got \"{}\"", shape),
              "unset OFFING_SHAPE to let the device decide");
}

// The row that fits best. Its shape counts more than its class: it decides which code is compiled.
const TuningRow& row_for(const DeviceInfo& device, std::string_view kernels,
                         std::optional<KernelShape> shape) {
  const DeviceClass device_class = class_of(device);
  const TuningRow* best = nullptr;
  int best_fit = -1;
  for (const TuningRow& row : table) {
    if (row.kernels != kernels) continue;
    const bool has_shape = !shape || row.tuning.shape == *shape;
    const bool suits = row.device_class == any || row.device_class == device_class;
    const int fit = (has_shape ? 2 : 0) + (suits ? 1 : 0);
    if (fit > best_fit) {
      best = &row;
      best_fit = fit;
    }
  }
  if (best != nullptr) return *best;
  throw Error(ErrorKind::bad_usage,
              fmt::format("tuning: expected rows for kernels \"{}\", found none", kernels),
              "add a default row to host/ocl/tuning.cpp");
}

KernelTuning within(const DeviceInfo& device, KernelTuning tuning) {
  if (device.max_work_group_size == 0) return tuning;  // unknown
  while (tuning.group > device.max_work_group_size) tuning.group /= 2;
  return tuning;
}

}  // namespace

KernelTuning tuning_for(const DeviceInfo& device, std::string_view kernels) {
  return within(device, row_for(device, kernels, chosen_shape()).tuning);
}

KernelTuning tuning_for(const DeviceInfo& device, std::string_view kernels, KernelShape shape) {
  return within(device, row_for(device, kernels, shape).tuning);
}

LaunchShape launch_shape(const KernelTuning& tuning, std::size_t count, std::size_t rows) {
  const auto each = static_cast<std::size_t>(tuning.lanes) * static_cast<std::size_t>(tuning.per_item);
  const std::size_t items = (count + each - 1) / each, group = std::max<std::size_t>(tuning.group, 1);
  return {{(items + group - 1) / group * group, rows}, {tuning.group}};
}

bool shape_is_forced() {
  return !forced_shape().empty();
}

}  // namespace offing::ocl
