#pragma once

#include <functional>

#include "host/ocl/device.h"
#include "present/gl/stage_times.h"

namespace offing::present {

/// Measures a stage that OpenCL does, or a part of it, until it is done; by the device's clock too where the
/// device keeps one.
void run_stage(StageTimes& times, Stage stage, const ocl::Device& device, const std::function<void()>& work);

}  // namespace offing::present
