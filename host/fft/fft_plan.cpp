#include "host/fft/fft_plan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::fft {
namespace {

constexpr int smallest_size = 16;
constexpr int largest_size = 4096;
constexpr int smallest_simd_size = 64;  // a row is a square of narrow lanes
constexpr int narrow_lanes = 8;         // the narrowest vectors of kernels/simd/lanes.clh
constexpr int thread_values = 8;        // of a radix-8 butterfly, in a work-item of a GPU

// Arrays from these sizes on are stored past the caches: they would push out what is read next.
constexpr int smallest_streamed_intermediate = 2048;
constexpr std::size_t smallest_streamed_result_bytes = std::size_t{8} << 20;

struct Radices {
  int first, second, third;
};

// Stages of a strip. The first streams from memory, so it is wide; the last stays small enough for registers.
Radices simd_radices(int size) {
  switch (size) {
    case 64:
      return {8, 1, 8};
    case 128:
      return {4, 4, 8};
    case 256:
      return {8, 4, 8};
    case 512:
      return {8, 8, 8};
    case 1024:
      return {8, 16, 8};
    case 2048:
      return {8, 16, 16};
    default:
      return {16, 16, 16};
  }
}

constexpr int most_row_vectors = 256;

// The transforms over a row's vectors: A * B.
std::pair<int, int> row_radices(int vectors) {
  switch (vectors) {
    case 8:
      return {8, 1};
    case 16:
      return {4, 4};
    case 32:
      return {4, 8};
    case 64:
      return {8, 8};
    case 128:
      return {8, 16};
    default:
      return {16, 16};
  }
}

// A range of factors k.
struct Factors {
  int first, count;
};

// Appends cosines [count][factors] of 2 pi j k / period, then the sines.
void append_rotations(std::vector<float>& table, int count, Factors factors, int period) {
  for (const bool is_sine : {false, true}) {
    for (int j = 0; j < count; ++j) {
      for (int k = factors.first; k < factors.first + factors.count; ++k) {
        const double angle_rad = 2.0 * std::numbers::pi * (static_cast<double>(j) * k / period);
        table.push_back(static_cast<float>(is_sine ? std::sin(angle_rad) : std::cos(angle_rad)));
      }
    }
  }
}

std::vector<float> simd_table(int size, const Radices& radices) {
  std::vector<float> table;
  append_rotations(table, size / radices.first, {0, radices.first}, size);
  append_rotations(table, radices.third, {0, radices.second}, size / radices.first);
  return table;
}

std::vector<float> row_table(int size, int lanes, std::pair<int, int> radices) {
  const int vectors = size / lanes;
  std::vector<float> table;
  for (int k = 0; k < vectors; ++k) {
    for (const bool is_sine : {false, true}) {
      for (int lane = 0; lane < lanes; ++lane) {
        const double angle_rad = 2.0 * std::numbers::pi * (static_cast<double>(lane) * k / size);
        table.push_back(static_cast<float>(is_sine ? std::sin(angle_rad) : std::cos(angle_rad)));
      }
    }
  }
  append_rotations(table, radices.second, {0, radices.first}, vectors);
  return table;
}

// Columns of the intermediate array that the first pass writes: whole vectors.
int padded_columns(const PlanRequest& request) {
  return std::max(request.columns, ocl::widest_lanes);
}

// A row's length in the intermediate array. A caller that reads past the columns zeroes the padding itself.
int pitch(const PlanRequest& request) {
  return padded_columns(request) + ocl::widest_lanes;
}

void set_common_defines(ocl::Defines& defines, const PlanRequest& request, int lanes) {
  defines.set("FFT_SIZE", request.size);
  defines.set("FFT_PITCH", pitch(request));
  defines.set("LANES", lanes);
}

PassPlan simd_pass(const PlanRequest& request, int lanes) {
  PassPlan pass;
  const Radices radices = simd_radices(request.size);
  set_common_defines(pass.defines, request, lanes);
  pass.defines.set("FFT_RADIX_1", radices.first);
  pass.defines.set("FFT_RADIX_2", radices.second);
  pass.defines.set("FFT_RADIX_3", radices.third);
  pass.twiddles = simd_table(request.size, radices);
  return pass;
}

std::size_t simd_scratch_bytes(const PlanRequest& request, int lanes) {
  return sizeof(float) * 2 * static_cast<std::size_t>(lanes * request.size);
}

PassPlan simd_columns(const ocl::DeviceInfo& device, const PlanRequest& request,
                      const ocl::KernelTuning& tuning) {
  const bool has_room = simd_scratch_bytes(request, tuning.lanes) <= device.local_memory_bytes;
  const int lanes = has_room ? tuning.lanes : narrow_lanes;
  PassPlan pass = simd_pass(request, lanes);
  if (request.size >= smallest_streamed_intermediate) pass.defines.set_flag("FFT_STREAM_INTERMEDIATE");
  pass.shape = {{static_cast<std::size_t>(padded_columns(request) / lanes), 1, 1}, {tuning.group, 1, 1}};
  pass.scratch_bytes = simd_scratch_bytes(request, lanes);
  return pass;
}

PassPlan simd_rows(const PlanRequest& request, const ocl::KernelTuning& tuning) {
  PassPlan pass;
  const int lanes = request.size / tuning.lanes > most_row_vectors ? ocl::widest_lanes : tuning.lanes;
  set_common_defines(pass.defines, request, lanes);
  const auto radices = row_radices(request.size / lanes);
  pass.defines.set("FFT_ROW_RADIX_A", radices.first);
  pass.defines.set("FFT_ROW_RADIX_B", radices.second);
  pass.defines.set("FFT_ROWS_PER_ITEM", tuning.per_item);
  pass.twiddles = row_table(request.size, lanes, radices);
  const std::size_t result_bytes = sizeof(float) * 2 * static_cast<std::size_t>(request.result_fields) *
                                   static_cast<std::size_t>(request.size) *
                                   static_cast<std::size_t>(request.size);
  if (result_bytes >= smallest_streamed_result_bytes) pass.defines.set_flag("STREAM_RESULT");
  pass.shape = {{static_cast<std::size_t>(request.size / tuning.per_item), 1, 1}, {tuning.group, 1, 1}};
  return pass;
}

PassPlan workgroup_pass(const PlanRequest& request, int width) {
  PassPlan pass;
  const int odd_factors[] = {1, 2, 4};  // of sizes 8^m, 2 * 8^m, 4 * 8^m
  set_common_defines(pass.defines, request, 1);
  pass.defines.set("FFT_GROUP_RADIX", odd_factors[std::countr_zero(static_cast<unsigned>(request.size)) % 3]);
  pass.defines.set("FFT_GROUP_WIDTH", width);
  pass.defines.set("FFT_THREAD_VALUES", thread_values);
  append_rotations(pass.twiddles, request.size, {1, 1}, request.size);
  pass.batch_dimension = 2;
  return pass;
}

PassPlan workgroup_columns(const ocl::DeviceInfo& device, const PlanRequest& request,
                           const ocl::KernelTuning& tuning) {
  const int threads = request.size / thread_values;
  const auto bytes_per_column = sizeof(float) * static_cast<std::size_t>(request.size);
  // Neighbouring columns for coalesced access, up to the padding, which they divide.
  int width = std::clamp(static_cast<int>(tuning.group) / threads, 1, ocl::widest_lanes);
  while (width > 1 && static_cast<std::size_t>(width) * bytes_per_column > device.local_memory_bytes) {
    width /= 2;
  }
  PassPlan pass = workgroup_pass(request, width);
  const auto thread_count = static_cast<std::size_t>(threads), column_count = static_cast<std::size_t>(width);
  pass.shape = {{static_cast<std::size_t>(padded_columns(request)), thread_count, 1},
                {column_count, thread_count, 1}};
  pass.scratch_bytes = static_cast<std::size_t>(width) * bytes_per_column;
  return pass;
}

PassPlan workgroup_rows(const PlanRequest& request, const ocl::KernelTuning& tuning) {
  const int threads = request.size / thread_values;
  // Short rows share a work-group.
  const int width = std::clamp(static_cast<int>(tuning.group) / threads, 1, request.size);
  PassPlan pass = workgroup_pass(request, width);
  const auto thread_count = static_cast<std::size_t>(threads), row_count = static_cast<std::size_t>(width);
  pass.shape = {{thread_count, static_cast<std::size_t>(request.size), 1}, {thread_count, row_count, 1}};
  return pass;
}

}  // namespace

ocl::LaunchShape PassPlan::shape_for(int batch) const {
  ocl::LaunchShape batched = shape;
  batched.global[static_cast<std::size_t>(batch_dimension)] *= static_cast<std::size_t>(batch);
  return batched;
}

std::vector<ocl::KernelShape> possible_families(const ocl::DeviceInfo& device, const PlanRequest& request) {
  if (request.size < smallest_size || request.size > largest_size ||
      !std::has_single_bit(static_cast<unsigned>(request.size))) {
    throw Error(ErrorKind::bad_input,
                fmt::format("transform size: expected a power of two from {} to {}, got {}", smallest_size,
                            largest_size, request.size),
                "use 256, 512 or 1024");
  }
  const int threads = request.size / thread_values;
  const bool can_simd = request.size >= smallest_simd_size &&
                        simd_scratch_bytes(request, narrow_lanes) <= device.local_memory_bytes;
  const bool can_workgroup = static_cast<std::size_t>(threads) <= device.max_work_group_size;
  const ocl::KernelShape wanted = ocl::tuning_for(device, "fft_columns").shape;
  std::vector<ocl::KernelShape> families;
  if (can_simd) families.push_back(ocl::KernelShape::simd);
  if (can_workgroup) families.push_back(ocl::KernelShape::workgroup);
  if (families.empty()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("transform size {}: needs work-groups of {}, {} allows {}", request.size, threads,
                            device.name, device.max_work_group_size),
                "choose a smaller --size or another --device");
  }
  if (families.front() != wanted) std::reverse(families.begin(), families.end());
  if (ocl::shape_is_forced() && families.front() == wanted) families.resize(1);
  return families;
}

FftPlan::FftPlan(const ocl::DeviceInfo& device, const PlanRequest& request, ocl::KernelShape family) {
  const ocl::KernelTuning columns = ocl::tuning_for(device, "fft_columns", family);
  const ocl::KernelTuning rows = ocl::tuning_for(device, "fft_rows", family);
  if (family == ocl::KernelShape::simd) {
    columns_ = simd_columns(device, request, columns);
    rows_ = simd_rows(request, rows);
  } else {
    columns_ = workgroup_columns(device, request, columns);
    rows_ = workgroup_rows(request, rows);
  }
  intermediate_floats_ =
      2 * static_cast<std::size_t>(request.size) * static_cast<std::size_t>(pitch(request));
}

}  // namespace offing::fft
