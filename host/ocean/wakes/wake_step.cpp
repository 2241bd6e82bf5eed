#include "host/ocean/wakes/wake_step.h"

#include "host/fft/fft2d.h"
#include "host/ocl/program.h"

namespace offing::ocean {
namespace {

fft::FftPlan plan_for(const ocl::Device& device, int cells) {
  return {device.info(),
          {.size = cells, .columns = cells},
          fft::Fft2d::family_for(device, cells, fft::Direction::inverse)};
}

}  // namespace

WakeStep::WakeStep(const ocl::Device& device, int cells, const std::vector<float>& turn)
    : WakeStep(device, plan_for(device, cells), turn) {}

WakeStep::WakeStep(const ocl::Device& device, const fft::FftPlan& plan, const std::vector<float>& turn)
    : columns_shape_(plan.columns().shape_for(1)),
      rows_shape_(plan.rows().shape_for(1)),
      scratch_{plan.columns().scratch_bytes},
      column_twiddles_(device, plan.columns().twiddles, "column twiddles"),
      row_twiddles_(device, plan.rows().twiddles, "row twiddles"),
      turn_(device, turn, "turns of modes"),
      intermediate_(device, plan.intermediate_floats(), "transform intermediate"),
      spectrum_(device, turn.size(), "modes of a wake") {
  const auto kernel = [&](const char* source, const char* name, ocl::Defines defines, bool is_forward) {
    if (is_forward) defines.set_flag("FFT_FORWARD");
    return ocl::Program::build(device, source, defines).kernel(name);
  };
  const ocl::Defines &columns = plan.columns().defines, &rows = plan.rows().defines;
  press_columns_ = kernel("ocean/wakes/wake_press_columns.cl", "wake_press_columns", columns, true);
  turn_rows_ = kernel("ocean/wakes/wake_turn_rows.cl", "wake_turn_rows", rows, true);
  inverse_columns_ = kernel("fft/transform_columns.cl", "transform_columns", columns, false);
  settle_rows_ = kernel("ocean/wakes/wake_settle_rows.cl", "wake_settle_rows", rows, false);
}

void WakeStep::advance(const WakeGrid& grid, const ocl::Buffer<float>& displaced,
                       const ocl::Buffer<float>& kept, ocl::Buffer<float>& state) {
  press_columns_.launch(columns_shape_, state, displaced, intermediate_, column_twiddles_, scratch_);
  turn_rows_.launch(rows_shape_, intermediate_, row_twiddles_, turn_, spectrum_);
  inverse_columns_.launch(columns_shape_, spectrum_, intermediate_, column_twiddles_, scratch_);
  settle_rows_.launch(rows_shape_, intermediate_, row_twiddles_, grid, displaced, kept, state);
}

}  // namespace offing::ocean
