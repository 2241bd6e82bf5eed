#include <cmath>
#include <numbers>

#include "host/c/handles.h"
#include "host/c/watched_work.h"
#include "host/scene/measure/certificate.h"
#include "host/scene/prepare/sea.h"

using offing::Error;
using offing::ErrorKind;
using offing::c::require;
using offing::c::run;

namespace {

/// Within [0, 2 pi).
double whole_turn_rad(double direction_rad) {
  constexpr double turn_rad = 2.0 * std::numbers::pi;
  const double wrapped_rad = direction_rad - turn_rad * std::floor(direction_rad / turn_rad);
  return wrapped_rad < turn_rad ? wrapped_rad : 0.0;  // a tiny negative angle rounds up to a full turn
}

OffingSeaStatistics to_statistics(const offing::scene::Certificate& found) {
  OffingSeaStatistics values{};
  values.size = sizeof values;
  values.asked_hs_m = found.asked.hs_m;
  values.asked_tp_s = found.asked.tp_s;
  values.asked_tm01_s = found.asked.tm01_s;
  values.asked_tm02_s = found.asked.tm02_s;
  values.asked_mean_direction_rad = whole_turn_rad(found.asked.mean_direction_rad);
  values.asked_mss = found.asked.mss;
  values.resolved_hs_m = found.resolved.hs_m;
  values.resolved_tp_s = found.resolved.tp_s;
  values.resolved_tm01_s = found.resolved.tm01_s;
  values.resolved_tm02_s = found.resolved.tm02_s;
  values.resolved_mean_direction_rad = whole_turn_rad(found.resolved.mean_direction_rad);
  values.resolved_mss = found.resolved.mss;
  values.hs_m = found.hs_m.mean;
  values.tp_s = found.tp_s.mean;
  values.tm01_s = found.tm01_s.mean;
  values.tm02_s = found.tm02_s.mean;
  values.mean_direction_rad = whole_turn_rad(found.mean_direction_rad.mean);
  values.mss = found.mss.mean;
  values.skewness = found.skewness.mean;
  values.kurtosis = found.kurtosis.mean;
  values.max_ka = found.max_ka;
  values.folded_share = found.folded_share.mean;
  values.hs_standard_error_m = found.standard_error.hs_m;
  values.tm02_standard_error_s = found.standard_error.tm02_s;
  values.mean_direction_standard_error_rad = found.standard_error.mean_direction_rad;
  values.asked_peak_period_s = found.asked.peak_period_s;
  values.asked_peak_direction_rad = whole_turn_rad(found.asked.peak_direction_rad);
  values.asked_spread_rad = found.asked.spread_rad;
  values.resolved_peak_period_s = found.resolved.peak_period_s;
  values.resolved_peak_direction_rad = whole_turn_rad(found.resolved.peak_direction_rad);
  values.resolved_spread_rad = found.resolved.spread_rad;
  values.peak_period_s = found.peak_period_s.mean;
  values.peak_direction_rad = whole_turn_rad(found.peak_direction_rad.mean);
  values.spread_rad = found.spread_rad.mean;
  values.peak_period_standard_error_s = found.standard_error.peak_period_s;
  values.asked_foam_fraction = found.foam_fraction_asked;
  values.foam_fraction = found.foam_fraction.mean;
  return values;
}

}  // namespace

OffingStatus offing_measure_sea(const OffingDevice* device, const OffingScene* scene, int seeds,
                                const OffingProgress* progress, OffingSeaStatistics* statistics) {
  return run([&] {
    require(device, "device");
    require(scene, "scene");
    require(statistics, "statistics");
    offing::c::read_struct(statistics, "statistics");  // its size, before the work
    constexpr int most_seeds = 100'000;
    if (seeds < 1 || seeds > most_seeds) {
      throw Error(ErrorKind::bad_usage,
                  fmt::format("seeds: expected one within [1, {}], got {}", most_seeds, seeds),
                  "8 seeds are a good start; four times as many halve the standard errors");
    }
    const offing::c::WatchedWork watched(progress);
    const offing::scene::Sea sea = offing::scene::prepare_sea(scene->copy());
    const offing::scene::Certificate found =
        offing::scene::certify(device->device, sea, seeds, watched.work());
    offing::c::write_struct(statistics, "statistics", to_statistics(found));
  });
}
