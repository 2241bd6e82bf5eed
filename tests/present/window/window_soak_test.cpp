// Random keys and mouse for a while: OFFING_SOAK_SECONDS, or 20 s.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/presets.h"
#include "present/panels/parameter_widget.h"
#include "tests/present/editing/holdings.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

class WindowSoakTest : public WindowTest {
 protected:
  /// One thing that a user does, whichever. Not: sizes, which end where the memory does; and other scenes.
  void do_something() {
    static constexpr std::array keys{
        "h",         "Tab", "space", "period", "comma", "bracketleft", "bracketright",
        "BackSpace", "g",   "v",     "F11",    "Home",  "End",         "Up",
        "Down",      "0",   "l",     "Left",   "w",     "a",           "s",
        "d",         "q",   "e",     "Escape"};
    switch (pick(0, 11)) {
      case 0:
      case 1:
      case 2:
        press(keys[static_cast<std::size_t>(pick(0, static_cast<int>(keys.size()) - 1))]);
        break;
      case 3:
        if (pick(0, 9) == 0) press(pick(0, 1) == 0 ? "F5" : "F12");
        break;
      case 4:
        glfwSetWindowSize(viewer_->window(), pick(1, 900), pick(1, 1000));
        turn(2);
        break;
      case 5: {
        const Hands::Button wheel = pick(0, 1) == 0 ? Hands::Button::wheel_up : Hands::Button::wheel_down;
        hands_->button(wheel, Hands::Motion::down);
        hands_->button(wheel, Hands::Motion::up);
        turn();
        break;
      }
      case 6:
        type(fmt::format("{}", pick(0, 99)));
        press("Return");
        break;
      default:
        use_mouse();
    }
  }

  /// What the process holds with the window as large as at the start.
  Holdings holdings_as_at_start() {
    if (glfwGetWindowMonitor(viewer_->window()) != nullptr) press("F11");
    glfwSetWindowSize(viewer_->window(), width_, height_);
    turn(3);
    return holdings();
  }

  int width_ = 0, height_ = 0;

  int pick(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }

 private:
  void use_mouse() {
    // Mostly on the panels.
    const Spot from{pick(0, pick(0, 3) == 0 ? 900 : 350), pick(0, 1000)};
    hands_->move_to(from.x, from.y);
    turn();
    // Another scene is another amount of memory.
    const ImGuiWindow* over = ImGui::GetCurrentContext()->HoveredWindow;
    const std::string_view name = over == nullptr ? "" : over->Name;
    if (name.find("/beside_") != name.npos || name.find("/shipped_") != name.npos) return;
    // ImGui takes all from a window that has been hidden for a minute, also what makes numbers of labels.
    ImGuiWindow *panel = main_panel(), *below = values();
    if (panel != nullptr && panel->WasActive && adds_objects(*panel)) return;
    if (below != nullptr && below->WasActive && is_size_hovered(*below)) return;
    drag(from, {from.x + pick(-60, 60), from.y + pick(-20, 20)});
  }

  /// New objects come with memory of their own.
  static bool adds_objects(ImGuiWindow& panel) {
    return is_hovered(panel, "add##objects") || is_hovered(panel, "duplicate##objects");
  }

  static bool is_size_hovered(ImGuiWindow& panel) {
    const auto is_layer = [&](const scene::Preset& preset) {
      if (preset.group != scene::ParameterGroup::cloud_layer) return false;
      const std::string_view word = preset.name.substr(preset.name.rfind('-') + 1);
      return is_hovered(panel, fmt::format("{}##{}", word, preset.name));
    };
    return std::ranges::any_of(scene::presets(), is_layer) ||
           std::ranges::any_of(sizes, [&](const char* key) {
             return is_hovered(panel, present::parameter_label(*scene::find_parameter(key)));
           });
  }

  /// In any of the first sections, where it is of repeated ones.
  static bool is_hovered(ImGuiWindow& panel, const std::string& label) {
    constexpr int most_sections = 4;
    const unsigned hovered = ImGui::GetCurrentContext()->HoveredId;
    if (hovered == panel.GetID(label.c_str())) return true;
    // The same among the values of what is selected.
    if (hovered == ImHashStr(label.c_str(), 0, panel.GetID("properties"))) return true;
    for (int i = 0; i < most_sections; ++i) {
      if (hovered == ImHashStr(label.c_str(), 0, panel.GetID(i))) return true;
    }
    return false;
  }

  /// Rows by which one pull can make work for hours, as presets of layers can.
  static constexpr std::array sizes{"ocean.size",          "terrain.posts",          "terrain.side_m",
                                    "clouds.quality",      "cloud.target_particles", "cloud_layer.coverage",
                                    "cloud_layer.extent_m"};

  std::mt19937 random_{20'071'204};
};

/// Small scenes of all kinds, and what is dropped into them.
class ScenesSoakTest : public WindowSoakTest {
 protected:
  void write_scenes() {
    write("sea.toml", "version = 1\n[ocean]\nsize = 32\n[camera]\npitch_deg = 60\n");
    write("ufer ü.toml",
          "version = 1\n[terrain]\nposts = 65\nside_m = 4e3\nmean_m = -10\n[ocean]\nsize = 32\n[camera]\n"
          "y_m = 300\npitch_deg = -10\n");
    write("구름.toml",
          "version = 1\n[clouds]\nquality = 0.2\n[camera]\ny_m = 600\nz_m = 2500\npitch_deg = 10\n[[cloud]]\n"
          "y_m = 1000\n[[cloud.ball]]\nradius_m = 150\n");
    write(
        "barco ñ.toml",
        "version = 1\n[ocean]\nsize = 32\n[[ocean.wake]]\nlength_m = 64\ncells = 64\nhistory_s = 2\n"
        "centre = \"body\"\nbody = \"boat\"\n[camera]\ny_m = 4\nz_m = 12\n[[mesh]]\nname = \"hull\"\n"
        "shape = \"boat\"\n[[mesh.highlight]]\n[[body]]\nname = \"boat\"\nmesh = \"hull\"\ndraught_m = 0.15\n"
        "speed_mps = 2\nthrust_n = 500\n");
    // Those that come with Offing take a minute each: only where there is time.
    constexpr double long_s = 600.0;
    if (soak_seconds(usual_s) >= long_s) {
      // Copies: recordings land beside their scenes.
      const std::filesystem::path copies = folder_.path() / "scenes";
      std::filesystem::copy(OFFING_SOURCES "/scenes", copies, std::filesystem::copy_options::recursive);
      for (const auto& file : std::filesystem::directory_iterator(copies))
        if (file.path().extension() == ".toml") scenes_.push_back(file.path());
      std::ranges::sort(scenes_);
    }
    write("tetraeder.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    write("no.toml", "nothing");
  }

  /// As one thing among many: another scene, a file for this one, back and forth.
  void do_something_with_scenes() {
    switch (pick(0, 19)) {
      case 0:
        drop({scenes_[static_cast<std::size_t>(pick(0, static_cast<int>(scenes_.size()) - 1))]});
        break;
      case 1:
        drop({files_[static_cast<std::size_t>(pick(0, static_cast<int>(files_.size()) - 1))]});
        break;
      case 2:
        undo();
        break;
      case 3:
        redo();
        break;
      case 4:
        if (pick(0, 9) > 0) break;
        press_with_control("r");
        turn(2);
        press("Return");
        break;
      default:
        do_something();
    }
  }

  /// What the process holds in the first scene, once its clouds are made and nothing is recorded.
  Holdings holdings_in_first_scene() {
    end_recording();
    drop({scenes_.front()});
    EXPECT_FALSE(state().message.is_fault) << message();
    wait_for_clouds();
    return holdings_as_at_start();
  }

  /// The least memory of some measurements. It leaves out what panels, undo steps and sizes of pictures take
  /// for a while, some 10 %.
  static double least_mb(std::span<const Holdings> measured) {
    return std::ranges::min(measured, {}, &Holdings::memory_mb).memory_mb;
  }

  static constexpr double usual_s = 30.0;
  std::vector<std::filesystem::path> scenes_, files_{OFFING_SOURCES "/scenes/example_sea.data_spec"};

 private:
  void end_recording() {
    press("Escape");
    if (!viewer_->is_recording()) return;
    holdings_as_at_start();
    if (!timeline()->WasActive) press("Tab");
    click(find(timeline(), "cancel##recording", static_cast<int>(timeline()->Size.x) - 30));
    constexpr double longest_s = 60.0;
    const double end_s = glfwGetTime() + longest_s;
    while (viewer_->is_recording()) {
      ASSERT_LT(glfwGetTime(), end_s) << "the recording never ends";
      turn();
    }
  }

  void write(const char* name, const char* text) {
    const std::filesystem::path path = folder_.path() / name;
    std::ofstream(path) << text;
    (path.extension() == ".toml" && std::string_view(text) != "nothing" ? scenes_ : files_).push_back(path);
  }
};

// Fails if the window cannot take what users do for long: an OpenGL error, an exception, or memory, threads
// or descriptors that grow. Memory: at the end within 10 % of what there was after the first quarter, both in
// a window of the usual size; what the scene has become by then differs, by swells and pictures of some MB.
TEST_F(WindowSoakTest, TakesWhateverComes) {
  open(quick_options());
  glfwGetWindowSize(viewer_->window(), &width_, &height_);
  press("F5");  // what is compiled again stays loaded
  const double lasts_s = soak_seconds(20.0), end_s = glfwGetTime() + lasts_s;
  const double warm_s = end_s - 0.75 * lasts_s;
  std::optional<Holdings> warm;
  int deeds = 0;
  double largest_mb = 0.0;
  while (glfwGetTime() < end_s) {
    do_something();
    ++deeds;
    ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << "after deed " << deeds;
    largest_mb = std::max(largest_mb, holdings().memory_mb);
    if (!warm && glfwGetTime() > warm_s) warm = holdings_as_at_start();
  }
  const Holdings last = holdings_as_at_start();
  ASSERT_TRUE(warm);
  fmt::print("{} deeds; memory {:.0f} -> {:.0f} MB (most {:.0f}), threads {} -> {}, descriptors {} -> {}\n",
             deeds, warm->memory_mb, last.memory_mb, largest_mb, warm->threads, last.threads,
             warm->descriptors, last.descriptors);
  EXPECT_LT(last.memory_mb, 1.1 * warm->memory_mb);
  EXPECT_EQ(last.threads, warm->threads);
  EXPECT_EQ(last.descriptors, warm->descriptors);
}

// Fails if other scenes, files, recordings, undo across scenes and a control of quality that never rests
// leave anything behind: an OpenGL error, an exception, memory, threads or descriptors. Memory: the least of
// the second half within 10 % of the least of the first, each of some measurements in the first scene of a
// window of the usual size, after one pass through all scenes.
TEST_F(ScenesSoakTest, LeaveNothingBehind) {
  write_scenes();
  present::ViewOptions options = quick_options();
  options.kept_hz = 60.0;
  open(options);
  glfwGetWindowSize(viewer_->window(), &width_, &height_);
  press("F5");
  for (const std::filesystem::path& scene : scenes_) {
    drop({scene});
    ASSERT_FALSE(state().message.is_fault) << message();
    wait_for_clouds();
    press("space");
    turn(3);
    press("space");
  }
  constexpr int measurements = 12;  // and one at the start
  const Holdings warm = holdings_in_first_scene();
  std::vector<Holdings> measured;
  const double start_s = glfwGetTime(), lasts_s = soak_seconds(usual_s);
  int deeds = 0, switches = 0, levels = 0;
  double largest_mb = 0.0;
  // Without the mark for edits.
  const auto shown_name = [&] {
    const std::string& title = viewer_->shown_title();
    return title.substr(0, title.find(" *"));
  };
  std::string name = shown_name();
  present::Quality quality = viewer_->quality();
  constexpr int least_deeds = 60;  // where the machine is busy: fewer may leave the scene alone
  while (measured.size() < measurements || deeds < least_deeds) {
    do_something_with_scenes();
    ++deeds;
    ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << "after deed " << deeds;
    if (std::exchange(name, shown_name()) != name) ++switches;
    if (std::exchange(quality, viewer_->quality()) != viewer_->quality()) ++levels;
    largest_mb = std::max(largest_mb, holdings().memory_mb);
    const double part = static_cast<double>(measured.size() + 1) / measurements;
    if (glfwGetTime() > start_s + part * lasts_s) measured.push_back(holdings_in_first_scene());
  }
  const std::span half = std::span(measured).first(measurements / 2);
  const double before_mb = least_mb(half), after_mb = least_mb(std::span(measured).subspan(half.size()));
  fmt::print(
      "{} scenes; {} deeds, {} switches, {} changes of quality; memory {:.0f}, {:.0f} -> {:.0f} MB (most "
      "{:.0f})\n",
      scenes_.size(), deeds, switches, levels, warm.memory_mb, before_mb, after_mb, largest_mb);
  EXPECT_GT(switches, 0);
  EXPECT_GT(levels, 0);
  EXPECT_LT(after_mb, 1.1 * before_mb);
  for (const Holdings& held : measured) {
    EXPECT_EQ(held.threads, warm.threads);
    EXPECT_EQ(held.descriptors, warm.descriptors);
  }
}

}  // namespace
}  // namespace offing::test
