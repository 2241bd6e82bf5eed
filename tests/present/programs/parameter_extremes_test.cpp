// Each number of a scene at its smallest and largest value, alone, in pictures and baked frames. What there
// is to try comes from the table of parameters; the scenes to try it in stand below.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/io/exr_image.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/prepare/sea.h"
#include "host/scene/schema/checked_value.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "host/scene/schema/unused_parameters.h"
#include "tests/cli/offing_program.h"

namespace offing::scene {
namespace {

using Clock = std::chrono::steady_clock;

/// A small scene, and the sections and keys of the numbers that mean something in it. A row is tried in the
/// scene that names its key, else in the one that names its section.
struct BaseScene {
  std::string_view names;  // separated by spaces
  std::string_view text;   // MEASURED, MAP, GRID, BOWL, STORE, WAMIT and SEQUENCE stand for files
};

constexpr BaseScene bases[] = {
    {"world wind ocean ocean.gerstner ocean.swell ocean.raindrop time.loop_period_s render",
     "[ocean]\nsize = 32\ngerstner.count = 4\n[[ocean.swell]]\n[[ocean.raindrop]]\namplitude_m = 0.02\n"},
    {"ocean.swell.period_s", "[ocean]\nsize = 32\n[[ocean.swell]]\n"},
    {"ocean.swell.hs_m ocean.swell.tp_s ocean.swell.spread_deg",
     "[ocean]\nsize = 32\n[[ocean.swell]]\nhs_m = 1\n"},
    {"ocean.hs_m ocean.tp_s ocean.tz_s", "[ocean]\nsize = 32\nhs_m = 2\n"},
    {"ocean.foam ocean.foam.decay_s", "[ocean]\nsize = 32\nchoppiness = 2\nfoam.step_s = 2\n"},
    {"ocean.foam.step_s", "[ocean]\nsize = 32\nchoppiness = 2\nfoam.decay_s = 1\n"},
    {"ocean.phillips_constant ocean.phillips_upwind", "[ocean]\nsize = 32\nspectrum = \"phillips\"\n"},
    {"ocean.phillips_cutoff_m",
     "[wind]\nspeed_mps = 60\n[ocean]\nsize = 32\nspectrum = \"phillips\"\ngravity_mps2 = 1\n"},
    {"ocean.swell_hs_m ocean.swell_period_s ocean.swell_bandwidth_hz ocean.swell_exponent",
     "[ocean]\nsize = 32\nspectrum = \"swell\"\n"},
    {"ocean.depth_m", "[ocean]\nsize = 32\nspectrum = \"tma\"\n"},
    {"ocean.spreading_exponent", "[ocean]\nsize = 32\nspreading = \"cosine\"\n"},
    {"ocean.record ocean.tail_hz", "[ocean]\nsize = 32\nspectrum_file = \"MEASURED\"\ntail_hz = 1\n"},
    {"time", "[time]\nfps = 1\n[ocean]\nsize = 32\n"},
    {"world.latitude_deg world.longitude_deg sun.time_scale",
     "[time]\nstart_s = 10\n[sun]\ntime_utc = 2024-06-21T12:00:00Z\n[ocean]\nsize = 32\n"},
    {"sun sky ocean.cascade", "[ocean]\nsize = 32\n"},
    {"camera", "[terrain]\nposts = 65\n[ocean]\nsize = 32\n"},
    {"bookmark", "[ocean]\nsize = 32\n[[bookmark]]\n"},
    {"walk", "[terrain]\nposts = 65\n[camera]\nmode = \"walk\"\n"},
    {"ocean.wake ocean.wake.hull",
     "[ocean]\nsize = 32\n[[ocean.wake]]\ncells = 32\nhistory_s = 2\n[[ocean.wake.hull]]\nspeed_mps = 3\n"},
    {"ocean.wake.rain_per_m2s ocean.wake.hollow_m",
     "[ocean]\nsize = 32\n[[ocean.wake]]\ncells = 32\nlength_m = 1\nstep_s = 0.001\nhistory_s = "
     "0.1\nrain_per_m2s = 10\n"},
    {"ocean.wake.speed_mps",
     "[ocean]\nsize = 32\n[[ocean.wake]]\nmethod = \"verlet\"\ncells = 32\nhistory_s = 2\n"
     "[[ocean.wake.hull]]\nspeed_mps = 3\n"},
    {"ocean.wake.behind_m",
     "[ocean]\nsize = 32\n[[ocean.wake]]\ncentre = \"hull\"\ncells = 32\nhistory_s = 2\n"
     "[[ocean.wake.hull]]\nspeed_mps = 3\n"},
    {"terrain", "[terrain]\nposts = 65\nside_m = 1000\nisland_radius_m = 400\n"},
    {"terrain.vertical_scale terrain.offset_m terrain.spacing_x_m terrain.spacing_z_m "
     "terrain.nodata terrain.void_height_m terrain.raw_columns terrain.raw_rows",
     "[terrain]\nfile = \"MAP\"\nraw_columns = 17\nraw_rows = 17\nraw_type = \"u16\"\nspacing_x_m = "
     "30\nspacing_z_m = 30\nnodata = 0\n"},
    {"terrain.canopy", "[terrain]\nposts = 65\n[terrain.canopy]\nshare = 0.5\n"},
    {"terrain.material", "[terrain]\nposts = 65\n[[terrain.material]]\n"},
    {"terrain.band", "[terrain]\nfile = \"GRID\"\nspacing_x_m = 30\nspacing_z_m = 30\n"},
    {"lake", "[terrain]\nfile = \"BOWL\"\norigin_x_m = -60\norigin_z_m = -60\n[[lake]]\n"},
    {"terrain.cache_mb", "[terrain]\nfile = \"STORE\"\n"},
    {"light", "[[light]]\n[[mesh]]\nshape = \"knot\"\n[[mesh.highlight]]\n"},
    {"light.x_m light.y_m light.z_m",
     "[[light]]\nkind = \"place\"\n[[mesh]]\nshape = \"sphere\"\n[[mesh.highlight]]\n"},
    {"mesh mesh.highlight",
     "[time]\nstart_s = 2\n[[mesh]]\nshape = \"sphere\"\nshading = \"cartoon\"\noutline_px = 2\n"
     "specular = 0.1\n[[mesh.highlight]]\nmask_m = [0, 0, 1]\nsplit = 3\ntexture = \"star\"\n"},
    {"mesh.sequence_fps", "[time]\nstart_s = 1\n[[mesh]]\nfile = \"SEQUENCE\"\nhighlights = \"off\"\n"},
    {"body body.mooring",
     "[ocean]\nsize = 32\n[[mesh]]\nname = \"box\"\nshape = \"box\"\n[[body]]\nmesh = "
     "\"box\"\n[[body.mooring]]\n"},
    {"body.hydrodynamics_length_m",
     "[ocean]\nsize = 32\n[[mesh]]\nname = \"box\"\nshape = \"box\"\n[[body]]\nmesh = "
     "\"box\"\nhydrodynamics = \"WAMIT\"\n"},
    {"clouds cloud cloud.ball cloud.level cloud.particle_edit",
     "[time]\nstart_s = 10\n[clouds]\nquality = 0.1\n[[cloud]]\ngenus = \"cumulus\"\nheat_k = "
     "1\nobstacle_m = [0, 900, 0]\nwind_mps = [1, 0, 0]\n"
     "[[cloud.ball]]\nradius_m = 100\n[[cloud.level]]\n[[cloud.particle_edit]]\n"},
    {"cloud.heat_stability_per_s",
     "[clouds]\nquality = 0.1\n[[cloud]]\nheat_k = 1\nheat_damping_per_s = 0\n"},
    {"cloud.heat_damping_per_s",
     "[clouds]\nquality = 0.1\n[[cloud]]\nheat_k = 1\nheat_stability_per_s = 1\n"},
    {"cloud.target_particles",
     "[clouds]\nquality = 0.1\n[[cloud]]\ngenus = \"stratus\"\nmodelling = "
     "\"sampled\"\n[[cloud.ball]]\nradius_m = 100\n"},
    {"cloud.depth_m cloud.yaw_deg cloud.pitch_deg cloud.roll_deg",
     "[clouds]\nquality = 0.1\n[[cloud]]\ntext = \"O\"\n"},
    {"cloud.size_m cloud.thickness_m cloud.fluff_m",
     "[clouds]\nquality = 0.1\n[[cloud]]\nshape = \"sphere\"\n"},
    {"cloud_layer.extent_m", "[clouds]\nquality = 0.1\n[[cloud_layer]]\ncoverage = 0.0001\n"},
    {"cloud_layer", "[clouds]\nquality = 0.1\n[[cloud_layer]]\nextent_m = 2000\ncoverage = 0.1\n"},
};

bool has_word(std::string_view words, std::string_view word) {
  return fmt::format(" {} ", words).find(fmt::format(" {} ", word)) != std::string::npos;
}

/// The scene that this row is to be tried in; nullptr where there is none.
const BaseScene* base_of(const Parameter& row) {
  for (const std::string_view name : {row.key, section_of(row.key)}) {
    for (const BaseScene& base : bases) {
      if (has_word(base.names, name)) return &base;
    }
  }
  return nullptr;
}

/// A value that other values or files of its scene contradict: no scene takes both ends of its range.
struct Contradiction {
  std::string_view key;
  double value;
  std::string_view words;  // of the message
};

constexpr Contradiction contradictions[] = {
    {"terrain.side_m", 1e7, "longest_m: expected a thousandth of the side"},
    {"terrain.vertical_scale", -1e6, "expected a height within 1e+06 m"},
    {"terrain.vertical_scale", 1e6, "expected a height within 1e+06 m"},
    {"terrain.offset_m", -1e9, "expected a height within 1e+06 m"},
    {"terrain.offset_m", 1e9, "expected a height within 1e+06 m"},
    {"terrain.band", 65535, "expected a band 65535, found 1 bands"},
    {"terrain.raw_columns", 0, "a file without a header, expected its size in posts"},
    {"terrain.raw_rows", 0, "a file without a header, expected its size in posts"},
    {"terrain.raw_columns", 1e6, "1000000x17 posts of UInt16 take 34000000 bytes, found 578"},
    {"terrain.raw_rows", 1e6, "17x1000000 posts of UInt16 take 34000000 bytes, found 578"},
    {"lake.x_m", -1e7, "expected a place on the map"},
    {"lake.x_m", 1e7, "expected a place on the map"},
    {"lake.z_m", -1e7, "expected a place on the map"},
    {"lake.z_m", 1e7, "expected a place on the map"},
    {"lake.level_m", -2e4, "expected a level above the ground"},
    {"lake.level_m", 2e4, "expected a level up to its spill level"},
    {"body.draught_m", 1e4, "expected a water level between -1 and 1 m of its mesh, found 9999 m"},
    {"body.mass_kg", 1e12, "expected a mass that displaces less than the hull's 8 m3"},
    {"ocean.swell_bandwidth_hz", 0.1, "expected a number within [8.33333e-05, 0.0416667]"},
    {"ocean.record", 1e9, "expected a record within [0, 2]"},
    {"cloud.size_m", 0.1, "0.1 m is too small for density that rises over 55 m"},
    {"cloud.depth_m", 0.1, "enclose no cell of"},
    {"cloud.thickness_m", 1e5, "500 m is too small for density that rises over"},
    {"cloud.fluff_m", 1e5, "500 m is too small for density that rises over"},
};

bool is_whole(const Parameter& row) {
  return std::holds_alternative<ValueAt<int>>(row.storage) ||
         std::holds_alternative<ValueAt<std::uint64_t>>(row.storage);
}

bool is_number(const Parameter& row) {
  return is_triple(row) || is_whole(row) || std::holds_alternative<ValueAt<double>>(row.storage) ||
         std::holds_alternative<ValueAt<std::optional<double>>>(row.storage) ||
         std::holds_alternative<ValueAt<std::vector<double>>>(row.storage);
}

WrittenValue written(const Parameter& row, double number) {
  WrittenValue value{.value = number, .shown = fmt::format("{:g}", number)};
  if (is_triple(row)) value.value = std::vector<double>(3, number);
  if (is_whole(row)) {
    constexpr double beyond = 9.2e18;  // of which no double is a 64-bit integer
    value.value =
        number > beyond ? std::numeric_limits<std::int64_t>::max() : static_cast<std::int64_t>(number);
  }
  return value;
}

/// Why a row that is set has no part in a scene; "" where it has.
std::string unused_line(Scene scene, const Parameter& row) {
  scene.set_at = {{{row.key, last_element(scene, *row.section)}, "value"}};
  const std::vector<std::string> lines =
      scene.has_sea() ? unused_parameters(scene, prepare_sea(scene, Warnings::left_out))
                      : unused_parameters(scene);
  return lines.empty() ? "" : lines.front();
}

/// Groups whose values change the maps of `offing ocean bake`.
bool is_of_sea(ParameterGroup group) {
  using enum ParameterGroup;
  return std::set{world, time, wind, sea, grid, swell, raindrop, foam}.contains(group);
}

struct Outcome {
  test::ProgramResult result;
  double seconds = 0.0;
  bool ended = false;
};

Outcome run(const char* program, const std::vector<std::string>& arguments) {
  constexpr double longest_s = 60.0;
  const Clock::time_point begin = Clock::now();
  test::OffingProgram process(arguments, program);
  Outcome outcome;
  while (process.is_running()) {
    outcome.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    if (outcome.seconds > longest_s) return outcome;  // which kills it
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  outcome.ended = true;
  outcome.result = process.wait();
  return outcome;
}

/// "" or why the EXR of this name, or those of a folder, are not to keep.
std::string fault_of(const std::filesystem::path& place) {
  std::vector<std::filesystem::path> files{place};
  if (std::filesystem::is_directory(place)) {
    files.assign(std::filesystem::directory_iterator(place), std::filesystem::directory_iterator());
  }
  std::size_t pictures = 0;
  try {
    for (const std::filesystem::path& file : files) {
      if (file.extension() != ".exr") continue;
      ++pictures;
      for (const auto& channel : read_exr(file).channels) {
        const auto is_nan = [](float value) { return std::isnan(value); };
        if (std::any_of(channel.values.begin(), channel.values.end(), is_nan))
          return "NaN in " + channel.name;
      }
    }
  } catch (const Error& error) {
    return error.what();
  }
  return pictures == 0 ? "no picture" : "";
}

class ParameterExtremes : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    unsetenv("OFFING_LONGEST_WAIT_S");
    std::ofstream map(folder_.path() / "map.r16", std::ios::binary);
    for (int i = 0; i < 17 * 17; ++i) map.put(static_cast<char>(7 * i % 100)).put(0);
    map.close();
    std::ofstream(file("map.asc")) << "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 30\n1 2\n3 4\n";
    std::ofstream(file("bowl.asc"))
        << "ncols 5\nnrows 5\nxllcorner 0\nyllcorner 0\ncellsize 30\n30 30 30 30 30\n30 40 40 40 30\n"
           "30 40 20 40 30\n30 40 40 40 30\n30 30 30 30 30\n";
    for (const char* top_m : {"2", "3"}) {
      std::ofstream(file(fmt::format("mesh_{}.obj", top_m)))
          << "v 0 0 0\nv 2 0 0\nv 0 " << top_m << " 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    }
    const auto tile =
        run(OFFING_MAIN_PROGRAM, {"terrain", "tile", file("map.r16"), "-o", file("store"), "--raw-size",
                                  "17x17", "--raw-type", "u16", "--spacing-m", "30", "--quiet"});
    ASSERT_EQ(tile.result.exit_code, 0) << tile.result.errors;
  }

  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }

  std::string text_of(std::string_view base) const {
    std::string text = "version = 1\n" + std::string(base);
    for (const auto& [name, path] :
         {std::pair("MEASURED", std::string(OFFING_SCENES "/example_sea.data_spec")),
          std::pair("MAP", file("map.r16")), std::pair("GRID", file("map.asc")),
          std::pair("BOWL", file("bowl.asc")), std::pair("STORE", file("store")),
          std::pair("SEQUENCE", file("mesh_%d.obj")),
          std::pair("WAMIT", std::string(OFFING_HYDRODYNAMICS "/box.1"))}) {
      if (const std::size_t at = text.find(name); at != std::string::npos)
        text.replace(at, std::string(name).size(), path);
    }
    return text;
  }

  void try_value(const Parameter& row, double number) {
    const std::string what = fmt::format("{} = {:g}", row.key, number);
    const BaseScene* base = base_of(row);
    ASSERT_NE(base, nullptr) << what << ": add a scene in which it means something to `bases`";
    Scene scene = parse_scene(text_of(base->text), "base.toml", "");
    ASSERT_FALSE(elements_of(scene, *row.section).empty()) << what << ": its scene has no element";
    ASSERT_EQ(unused_line(scene, row), "") << what << ": choose another scene in `bases`";
    if (drawn_.insert(base->text).second) draw(*base, scene);
    clear_list(scene, row);
    store(scene, row, written(row, number), {.subject = what});
    std::ofstream(file("scene.toml")) << scene_text(scene, folder_.path());
    std::filesystem::remove(file("a.exr"));
    check(what, row.key, number, run(OFFING_VIEW_PROGRAM, image_arguments(scene)), file("a.exr"));
    if (!is_of_sea(row.group)) return;
    std::filesystem::remove_all(file("frames"));
    check(
        what + ", baked", row.key, number,
        run(OFFING_MAIN_PROGRAM,
            {"ocean", "bake", file("scene.toml"), "-o", file("frames"), "--frames",
             fmt::format("{:.0f}", std::ceil(scene.time.start_s * scene.time.frames_per_second)), "--quiet"}),
        file("frames"));
  }

  /// Draws a base scene itself, which also has drivers compile what the others need.
  void draw(const BaseScene& base, const Scene& scene) const {
    std::ofstream(file("scene.toml")) << scene_text(scene, folder_.path());
    std::filesystem::remove(file("a.exr"));
    test::OffingProgram program(image_arguments(scene), OFFING_VIEW_PROGRAM);
    const test::ProgramResult result = program.wait();
    ASSERT_EQ(result.exit_code, 0) << base.text << result.errors;
    ASSERT_EQ(result.errors, "") << base.text;
  }

  std::vector<std::string> image_arguments(const Scene& scene) const {
    return {file("scene.toml"), "--headless", "--size",     "48x27",
            "--detail",         "low",        "--time",     fmt::format("{:.12g}", scene.time.start_s),
            "--quiet",          "-o",         file("a.exr")};
  }

  void check(const std::string& what, std::string_view key, double number, const Outcome& outcome,
             const std::filesystem::path& exr) {
    const int exit_code = outcome.result.exit_code;
    const std::string& errors = outcome.result.errors;
    const std::string line = errors.substr(0, errors.find('\n'));
    fmt::print("{}: {}, {:.1f} s{}{}\n", what, outcome.ended ? fmt::format("exit {}", exit_code) : "no end",
               outcome.seconds, line.empty() ? "" : ": ", line);
    std::fflush(stdout);
    ++tried_;
    longest_s_ = std::max(longest_s_, outcome.seconds);
    if (!outcome.ended) {
      ADD_FAILURE() << what << ": expected an end within 60 s, found none";
      return;
    }
    const auto* contradiction =
        std::find_if(std::begin(contradictions), std::end(contradictions),
                     [&](const Contradiction& each) { return each.key == key && each.value == number; });
    if (contradiction != std::end(contradictions)) {
      EXPECT_EQ(exit_code, 2) << what;
      EXPECT_NE(errors.find(contradiction->words), std::string::npos) << what << ": " << errors;
    } else if (exit_code == 0) {
      EXPECT_EQ(fault_of(exr), "") << what;
      return;
    } else {
      // What is refused for its cost says what it would take.
      static const std::regex needed(
          R"(error: .*((needs?|would need|of) [0-9.e+]+ (MB|GB|MiB|GiB|bytes)|would take about [0-9]+ (s|min|h|d)))");
      EXPECT_TRUE(exit_code == 1 || exit_code == 2) << what << ": " << errors;
      EXPECT_TRUE(std::regex_search(errors, needed)) << what << ": " << errors;
      ++refused_by_cost_;
    }
    ++refused_;
    EXPECT_NE(errors.find("hint: "), std::string::npos) << what << ": " << errors;
    EXPECT_EQ(errors.find("NaN"), std::string::npos) << what << ": " << errors;
  }

  std::set<std::string_view> drawn_;  // base scenes
  int tried_ = 0, refused_ = 0, refused_by_cost_ = 0;
  double longest_s_ = 0.0;
  TemporaryFolder folder_;
};

// Fails if a value within its range makes a program crash, go on for more than a minute, write NaN, or refuse
// without saying what it needs.
TEST_P(ParameterExtremes, AreDrawnOrRefused) {
  for (const Parameter& row : parameter_table()) {
    if (section_of(row.key) != GetParam() || !is_number(row)) continue;
    try_value(row, row.low);
    if (row.high != row.low) try_value(row, row.high);
  }
  fmt::print(
      "{}: {} tried, {} drawn, {} refused for what they need, {} as contradictions, {:.1f} s at most\n",
      GetParam(), tried_, tried_ - refused_, refused_by_cost_, refused_ - refused_by_cost_, longest_s_);
}

// Fails if a table here names what there is not, as after a key has got another name.
TEST(ParameterExtremesTables, NameWhatThereIs) {
  const auto is_section = [](std::string_view name) {
    return std::ranges::any_of(parameter_table(),
                               [&](const Parameter& row) { return section_of(row.key) == name; });
  };
  for (const BaseScene& base : bases) {
    std::istringstream names{std::string(base.names)};
    for (std::string name; names >> name;)
      EXPECT_TRUE(find_parameter(name) != nullptr || is_section(name)) << name;
  }
  for (const Contradiction& each : contradictions) {
    const Parameter* row = find_parameter(each.key);
    ASSERT_NE(row, nullptr) << each.key;
    EXPECT_TRUE(each.value == row->low || each.value == row->high) << each.key;
  }
}

std::vector<std::string> sections() {
  std::vector<std::string> names;
  for (const Parameter& row : parameter_table()) {
    const std::string name(section_of(row.key));
    if (is_number(row) && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Sections, ParameterExtremes, testing::ValuesIn(sections()), [](const auto& section) {
  std::string name = section.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '.'; }, '_');
  return name;
});

}  // namespace
}  // namespace offing::scene
