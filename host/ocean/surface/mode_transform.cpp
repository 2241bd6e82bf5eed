#include "host/ocean/surface/mode_transform.h"

#include "host/fft/sound_family.h"
#include "host/ocl/program.h"

namespace offing::ocean {
namespace {

fft::PlanRequest plan_request(const ModeTransform::Grid& grid, const ModeTransform::Request& request) {
  return {.size = grid.size, .columns = grid.columns, .result_fields = request.pair_fields};
}

// First pass, second pass.
std::vector<ocl::ProgramRecipe> programs_of(const fft::FftPlan& plan, int columns,
                                            const ModeTransform::Request& request) {
  std::vector<ocl::ProgramRecipe> programs{{request.first_source, plan.columns().defines},
                                           {request.second_source, plan.rows().defines}};
  for (ocl::ProgramRecipe& program : programs) {
    program.defines.set("SPECTRUM_COLUMNS", columns);
    if (request.mode_rows == 0) continue;
    program.defines.set("MODE_ROWS", request.mode_rows).set("MAP_FIELDS", request.half_fields);
  }
  return programs;
}

}  // namespace

ocl::KernelShape ModeTransform::family_for(const ocl::Device& device, Grid grid, const Request& request) {
  grid.cascade_count = 1;
  const fft::PlanRequest plan = plan_request(grid, request);
  const auto programs = [&](ocl::KernelShape family) {
    return programs_of(fft::FftPlan(device.info(), plan, family), grid.columns, request);
  };
  const auto error_of = [&](ocl::KernelShape family) {
    ModeTransform transform(device, grid, request, family);
    return request.self_test(device, transform, grid, request);
  };
  return fft::sound_family(device, plan, {.programs = programs, .error_of = error_of});
}

ModeTransform::ModeTransform(const ocl::Device& device, const WaveModes& modes, const Request& request)
    : ModeTransform(device, Grid{modes.size(), modes.columns(), modes.cascade_count()}, request) {}

ModeTransform::ModeTransform(const ocl::Device& device, const Grid& grid, const Request& request)
    : ModeTransform(device, grid, request, family_for(device, grid, request)) {}

ModeTransform::ModeTransform(const ocl::Device& device, const Grid& grid, const Request& request,
                             ocl::KernelShape family) {
  const fft::FftPlan plan(device.info(), plan_request(grid, request), family);
  const std::vector<ocl::ProgramRecipe> programs = programs_of(plan, grid.columns, request);
  const auto kernel_of = [&device](const ocl::ProgramRecipe& program, std::string_view name) {
    return ocl::Program::build(device, program.source_name, program.defines).kernel(name);
  };
  first_ = kernel_of(programs[0], request.first_kernel);
  second_ = kernel_of(programs[1], request.second_kernel);
  first_shape_ = plan.columns().shape_for(grid.cascade_count);
  second_shape_ = plan.rows().shape_for(grid.cascade_count);
  first_scratch_ = {plan.columns().scratch_bytes};
  column_twiddles_ = ocl::Buffer<float>(device, plan.columns().twiddles, "column twiddles");
  row_twiddles_ = ocl::Buffer<float>(device, plan.rows().twiddles, "row twiddles");
  const auto fields = static_cast<std::size_t>(grid.cascade_count * request.half_fields);
  intermediate_ = ocl::Buffer<float>(device, fields * plan.intermediate_floats(), "transform intermediate");
  // Column n/2, the Nyquist column, is read as zero by the second pass and never written by the first.
  intermediate_.fill(0.0f);
}

}  // namespace offing::ocean
