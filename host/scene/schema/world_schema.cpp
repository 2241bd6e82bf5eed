// [world] and [time]: which sea and where it is, and the times of frames.
#include <string>

#include "host/base/parameter_check.h"
#include "host/scene/schema/sections.h"

namespace offing::scene {
namespace {

std::string needs_date(const UseContext& context, const WorldSection&) {
  return context.scene.view.sun_time_utc ? "" : "sun.time_utc is not given";
}

std::string needs_sea(const UseContext& context, const WorldSection&) {
  return context.sea.is_there ? "" : "the scene has no sea";
}

}  // namespace

Schema<WorldSection> world_schema() {
  Schema<WorldSection> schema("world");
  return schema.rows(ParameterGroup::world, Affects::view,
                     {{&WorldSection::seed,
                       {.key = "seed",
                        .affects = Affects::sea_seed | Affects::baked,
                        .flag = "--seed",
                        .high = 9223372036854775807.0,
                        .help = "random seed: another seed gives another sea of the same spectrum"}},

                      {&WorldSection::latitude_rad,
                       {.key = "latitude_deg",
                        .unit = "deg",
                        .low = -90.0,
                        .high = 90.0,
                        .help = "latitude of the origin, north positive; used for the sun's position",
                        .scale = radians_per_degree},
                       needs_date},
                      {&WorldSection::longitude_rad,
                       {.key = "longitude_deg",
                        .unit = "deg",
                        .low = -180.0,
                        .high = 360.0,
                        .help = "longitude of the origin, east positive; used for the sun's position",
                        .scale = radians_per_degree},
                       needs_date},
                      {&WorldSection::sea_level_m,
                       {.key = "sea_level_m",
                        .unit = "m",
                        .low = -1e4,
                        .high = 1e4,
                        .help = "height of the still sea, from the same zero as terrain heights"},
                       needs_sea}});
}

Schema<TimeSection> time_schema() {
  Schema<TimeSection> schema("time");
  return schema.rows(
      ParameterGroup::time, Affects::view,
      {{&TimeSection::frames_per_second,
        {.key = "fps",
         .affects = Affects::baked,
         .flag = "--fps",
         .unit = "1/s",
         .low = 0.001,
         .high = 1e6,
         .help = "frames per second: frame i shows time i / fps"}},
       {&TimeSection::start_s,
        {.key = "start_s", .unit = "s", .low = 0.0, .high = 1e6, .help = "time of the first frame"}},
       {&TimeSection::end_s,
        {.key = "end_s", .unit = "s", .low = 0.0, .high = 1e6, .help = "frames stop before this time"}},
       {&TimeSection::loop_period_s,
        {.key = "loop_period_s",
         .affects = Affects::spectrum | Affects::baked,
         .flag = "--loop-period-s",
         .unit = "s",
         .low = 0.1,
         .high = 1e5,
         .help = "make the sea repeat exactly after this time; looks natural from about 10 s",
         .example = "20",
         .absent = "no loop"}}});
}

}  // namespace offing::scene
