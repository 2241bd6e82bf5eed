#include "host/ocean/mode_transform.h"

#include <algorithm>

#include "host/ocl/program.h"

namespace offing::ocean {

ModeTransform::ModeTransform(const ocl::Device& device, const WaveModes& modes, const Request& request) {
  // Row n/2, the Nyquist row, is read as zero by the second pass and never written by the first.
  const int intermediate_rows = std::max(modes.rows(), modes.size() / 2 + 1);
  const fft::FftPlan plan(device.info(), {.size = modes.size(),
                                          .rows = modes.rows(),
                                          .intermediate_rows = intermediate_rows,
                                          .column_fields = request.column_fields});
  const auto kernel_of = [&](fft::PassPlan pass, std::string_view source, std::string_view name) {
    pass.defines.set("SPECTRUM_ROWS", modes.rows());
    return ocl::Program::build(device, source, pass.defines).kernel(name);
  };
  first_ = kernel_of(plan.rows(), request.first_source, request.first_kernel);
  second_ = kernel_of(plan.columns(), request.second_source, request.second_kernel);
  first_shape_ = plan.rows().shape_for(modes.cascade_count());
  second_shape_ = plan.columns().shape_for(modes.cascade_count());
  second_scratch_ = {plan.columns().scratch_bytes};
  row_twiddles_ = ocl::Buffer<float>(device, plan.rows().twiddles, "row twiddles");
  column_twiddles_ = ocl::Buffer<float>(device, plan.columns().twiddles, "column twiddles");
  const auto fields = static_cast<std::size_t>(modes.cascade_count() * request.half_fields);
  intermediate_ = ocl::Buffer<float>(device, fields * plan.intermediate_floats(), "transform intermediate");
  intermediate_.fill(0.0f);
}

}  // namespace offing::ocean
