// Each number of a scene at its smallest and largest value, alone, in pictures and baked frames. What there
// is to try comes from the table of parameters; a scene in which a value counts is the first below that says
// no word against it.
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
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/io/exr_image.h"
#include "host/scene/parameter_check.h"
#include "host/scene/parameter_table.h"
#include "host/scene/scene_elements.h"
#include "host/scene/scene_file.h"
#include "host/scene/scene_writer.h"
#include "host/scene/sea.h"
#include "host/scene/unused_parameters.h"
#include "tests/cli/offing_program.h"

namespace offing::scene {
namespace {

using Clock = std::chrono::steady_clock;

/// Small scenes that between them use every number. MEASURED, MAP and STORE stand for files.
constexpr std::string_view bases[] = {
    "[ocean]\nsize = 32\ngerstner.count = 4\n[[ocean.swell]]\n[[ocean.raindrop]]\namplitude_m = 0.02\n",
    "[ocean]\nsize = 32\nspectrum = \"phillips\"\n",
    "[ocean]\nsize = 32\nspectrum = \"swell\"\n",
    "[ocean]\nsize = 32\nspectrum = \"tma\"\ndepth_m = 20\n",
    "[ocean]\nsize = 32\nspreading = \"cosine\"\n",
    "[ocean]\nsize = 32\nspectrum_file = \"MEASURED\"\n",
    "[sun]\ntime_utc = 2024-06-21T12:00:00Z\n[ocean]\nsize = 32\n",
    "[ocean]\nsize = 32\n[[ocean.wake]]\ncells = 32\nhistory_s = 2\nrain_per_m2s = "
    "0.01\n[[ocean.wake.hull]]\nspeed_mps = 3\n",
    "[terrain]\nposts = 65\nisland_radius_m = 8000\n",
    "[terrain]\nposts = 65\n[ocean]\nsize = 32\n[camera]\nmode = \"walk\"\n",
    "[terrain]\nfile = \"MAP\"\nraw_columns = 17\nraw_rows = 17\nraw_type = \"u16\"\nspacing_x_m = "
    "30\nspacing_z_m = 30\n",
    "[terrain]\nfile = \"STORE\"\n",
    "[[light]]\nname = \"lamp\"\nkind = \"place\"\n[[mesh]]\nshape = \"sphere\"\nshading = "
    "\"cartoon\"\noutline_px = 2\n"
    "specular = 0.1\n[[mesh.highlight]]\nmask_m = [0, 0, 1]\nsplit = 3\n",
    "[[light]]\nname = \"far\"\n[[mesh]]\nshape = \"knot\"\n[[mesh.highlight]]\ntexture = \"star\"\n",
    "[ocean]\nsize = 32\n[[mesh]]\nname = \"box\"\nshape = \"box\"\n[[body]]\nmesh = \"box\"\n",
    "[ocean]\nsize = 32\n[[mesh]]\nname = \"box\"\nshape = \"box\"\n[[body]]\nmesh = \"box\"\ndraught_m = "
    "0.5\n",
    "[clouds]\nquality = 0.1\n[[cloud]]\ngenus = \"cumulus\"\nheat_k = 1\nobstacle_m = [0, 900, 0]\nwind_mps "
    "= [1, 0, 0]\n"
    "[[cloud.ball]]\nradius_m = 100\n[[cloud.level]]\n[[cloud.particle_edit]]\n",
    "[clouds]\nquality = 0.1\n[[cloud]]\ngenus = \"stratus\"\nmodelling = "
    "\"sampled\"\n[[cloud.ball]]\nradius_m = 100\n",
    "[clouds]\nquality = 0.1\n[[cloud]]\ntext = \"O\"\n",
    "[clouds]\nquality = 0.1\n[[cloud]]\nshape = \"sphere\"\n",
    "[clouds]\nquality = 0.1\n[[cloud_layer]]\nextent_m = 2000\ncoverage = 0.1\n",
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

/// Whether a value that was set in a scene matters to it.
bool counts(const OceanScene& scene) {
  const std::vector<std::string> lines =
      scene.has_sea() ? unused_parameters(scene, prepare_sea(scene, Warnings::left_out))
                      : unused_parameters(scene);
  return std::none_of(lines.begin(), lines.end(),
                      [](const std::string& line) { return line.starts_with("tried value:"); });
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
    std::ofstream map(folder_.path() / "map.r16", std::ios::binary);
    for (int i = 0; i < 17 * 17; ++i) map.put(static_cast<char>(7 * i)).put(static_cast<char>(i % 3));
    map.close();
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
          std::pair("MAP", file("map.r16")), std::pair("STORE", file("store"))}) {
      if (const std::size_t at = text.find(name); at != std::string::npos)
        text.replace(at, std::string(name).size(), path);
    }
    return text;
  }

  /// The first scene that a value counts in, with it; nothing where there is none.
  std::optional<OceanScene> scene_with(const Parameter& row, double number) const {
    for (const std::string_view base : bases) {
      OceanScene scene = parse_scene(text_of(base), "base.toml", "");
      if (row.elements && elements_of(scene, row.elements).empty()) continue;
      if (!row.elements && section_of(row.key) == "terrain" && !scene.terrain.is_given) continue;
      clear_list(scene, row);
      store(scene, row, written(row, number), {.subject = "tried value"});
      try {
        if (counts(scene)) return scene;
      } catch (const Error&) {
        return scene;  // the program says so too
      }
    }
    return std::nullopt;
  }

  void try_value(const Parameter& row, double number) {
    const std::optional<OceanScene> scene = scene_with(row, number);
    const std::string what = fmt::format("{} = {:g}", row.key, number);
    if (!scene) {
      ADD_FAILURE() << what << ": add a scene in which it counts to `bases`";
      return;
    }
    std::ofstream(file("scene.toml")) << scene_text(*scene, folder_.path());
    std::filesystem::remove(file("a.exr"));
    check(what,
          run(OFFING_VIEW_PROGRAM, {file("scene.toml"), "--headless", "--size", "48x27", "--detail", "low",
                                    "--quiet", "-o", file("a.exr")}),
          file("a.exr"));
    if (!is_of_sea(row.group)) return;
    std::filesystem::remove_all(file("frames"));
    check(what + ", baked",
          run(OFFING_MAIN_PROGRAM,
              {"ocean", "bake", file("scene.toml"), "-o", file("frames"), "--frames", "0", "--quiet"}),
          file("frames"));
  }

  void check(const std::string& what, const Outcome& outcome, const std::filesystem::path& exr) {
    const auto& [exit_code, output, errors] = outcome.result;
    const std::string line = errors.substr(0, errors.find('\n'));
    fmt::print("{}: {}, {:.1f} s{}{}\n", what, outcome.ended ? fmt::format("exit {}", exit_code) : "no end",
               outcome.seconds, line.empty() ? "" : ": ", line);
    if (!outcome.ended) {
      ADD_FAILURE() << what << ": expected an end within 60 s, found none";
      return;
    }
    if (exit_code == 0) {
      EXPECT_EQ(fault_of(exr), "") << what;
      return;
    }
    // Refused: by what it would take, or since it does not go with the rest of the scene, where that can be
    // said.
    static const std::regex needed(
        "[0-9.]+ ?(kB|MB|GB|TB|KiB|MiB|GiB|TiB|bytes|s|minutes|hours|days|years)\\b");
    EXPECT_NE(errors.find("error: "), std::string::npos) << what << ": " << errors;
    EXPECT_NE(errors.find("hint: "), std::string::npos) << what << ": " << errors;
    EXPECT_TRUE(exit_code == 2 || (exit_code == 1 && std::regex_search(errors, needed)))
        << what << ": " << errors;
    EXPECT_EQ(errors.find("NaN"), std::string::npos) << what << ": " << errors;
  }

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
