#include "host/fft/fft2d.h"

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/fft/fft_plan.h"
#include "host/ocl/program.h"

namespace offing::fft {

Fft2d::Fft2d(const ocl::Device& device, int size, int batch, Direction direction)
    : size_(size), batch_(batch) {
  if (batch < 1) {
    throw Error(ErrorKind::bad_input, fmt::format("transform batch: expected at least 1, got {}", batch),
                "ask for one transform or more");
  }
  const FftPlan plan(device.info(), {.size = size, .columns = size, .result_fields = 1});
  const auto kernel_of = [&](PassPlan pass, const char* source, const char* name) {
    if (direction == Direction::forward) pass.defines.set_flag("FFT_FORWARD");
    return ocl::Program::build(device, source, pass.defines).kernel(name);
  };
  columns_ = kernel_of(plan.columns(), "fft/transform_columns.cl", "transform_columns");
  rows_ = kernel_of(plan.rows(), "fft/transform_rows.cl", "transform_rows");
  columns_shape_ = plan.columns().shape_for(batch);
  columns_scratch_ = {plan.columns().scratch_bytes};
  rows_shape_ = plan.rows().shape_for(batch);
  row_twiddles_ = ocl::Buffer<float>(device, plan.rows().twiddles, "row twiddles");
  column_twiddles_ = ocl::Buffer<float>(device, plan.columns().twiddles, "column twiddles");
  intermediate_ = ocl::Buffer<float>(device, plan.intermediate_floats() * static_cast<std::size_t>(batch),
                                     "transform intermediate");
}

std::size_t Fft2d::float_count() const {
  return static_cast<std::size_t>(batch_) * static_cast<std::size_t>(size_) *
         static_cast<std::size_t>(size_) * 2;
}

void Fft2d::transform(const ocl::Buffer<float>& input, ocl::Buffer<float>& output) {
  if (input.size() < float_count() || output.size() < float_count()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("transform buffers: expected at least {} floats, got {} and {}", float_count(),
                            input.size(), output.size()),
                "make both buffers of float_count() floats");
  }
  columns_.launch(columns_shape_, input, intermediate_, column_twiddles_, columns_scratch_);
  rows_.launch(rows_shape_, intermediate_, row_twiddles_, output);
}

}  // namespace offing::fft
