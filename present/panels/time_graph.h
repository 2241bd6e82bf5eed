#pragma once

#include "present/gl/stage_times.h"

namespace offing::present {

/// Draws the times of the last frames, stage upon stage, with a legend of their means.
void draw_time_graph(const StageTimes& times, TimeSource source);

}  // namespace offing::present
