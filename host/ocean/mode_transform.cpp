#include "host/ocean/mode_transform.h"

#include "host/ocl/program.h"

namespace offing::ocean {

ModeTransform::ModeTransform(const ocl::Device& device, const WaveModes& modes, const Request& request) {
  const fft::FftPlan plan(
      device.info(),
      {.size = modes.size(), .columns = modes.size() / 2, .result_fields = request.pair_fields});
  const auto kernel_of = [&](fft::PassPlan pass, std::string_view source, std::string_view name) {
    pass.defines.set("SPECTRUM_COLUMNS", modes.columns());
    return ocl::Program::build(device, source, pass.defines).kernel(name);
  };
  first_ = kernel_of(plan.columns(), request.first_source, request.first_kernel);
  second_ = kernel_of(plan.rows(), request.second_source, request.second_kernel);
  first_shape_ = plan.columns().shape_for(modes.cascade_count());
  second_shape_ = plan.rows().shape_for(modes.cascade_count());
  first_scratch_ = {plan.columns().scratch_bytes};
  column_twiddles_ = ocl::Buffer<float>(device, plan.columns().twiddles, "column twiddles");
  row_twiddles_ = ocl::Buffer<float>(device, plan.rows().twiddles, "row twiddles");
  const auto fields = static_cast<std::size_t>(modes.cascade_count() * request.half_fields);
  intermediate_ = ocl::Buffer<float>(device, fields * plan.intermediate_floats(), "transform intermediate");
  // Column n/2, the Nyquist column, is read as zero by the second pass and never written by the first.
  intermediate_.fill(0.0f);
}

}  // namespace offing::ocean
