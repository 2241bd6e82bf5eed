#include "present/gl/device_stage.h"

#include "host/ocl/event.h"

namespace offing::present {

void run_stage(StageTimes& times, Stage stage, const ocl::Device& device, const std::function<void()>& work) {
  const StageTimes::Scope scope(times, stage);
  const ocl::Event start = device.mark();
  work();
  const ocl::Event end = device.mark();
  device.finish();
  if (device.is_profiling()) times.add_device_ms(stage, 1e3 * (end.end_s() - start.end_s()));
}

}  // namespace offing::present
