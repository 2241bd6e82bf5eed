#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "host/base/work.h"
#include "host/scene/schema/parameter.h"
#include "present/window/viewer.h"
#include "tests/io/temporary_folder.h"
#include "tests/present/virtual_display.h"
#include "tests/present/window/hands.h"

struct ImGuiWindow;

namespace offing::test {

/// A window of the presenter on a display server of its own, with the hands of a user. Cases skip, with the
/// reason, where there is no Xvfb.
class WindowTest : public testing::Test {
 protected:
  struct Spot {
    int x = 0, y = 0;
  };

  void SetUp() override;
  void TearDown() override;

  /// Of the display: WIDTHxHEIGHTxDEPTH.
  virtual std::string display_size() const { return VirtualDisplay::usual_screen; }

  /// A small sea, seen by a camera that looks at the sky, in few pixels: frames are quick to draw.
  static present::ViewOptions quick_options();
  /// Opens the window, paused, as large as the display allows.
  void open(const present::ViewOptions& options);
  void turn(int count = 1);
  /// Frames in which panels are drawn anew, until sizes that depend on each other have settled.
  void settle();
  /// What a user has done so far: keys, alone or with others held, clicks, drags and words that were typed.
  int steps() const { return steps_; }
  void press(const char* key);
  void press_with_control(const char* key);
  void click(Spot spot);
  /// Presses, moves and releases, a frame each.
  void drag(Spot from, Spot to);
  static Spot spot(glm::dvec2 px);
  /// Takes hold, goes there in steps, stays for some frames and lets go.
  void pull(glm::dvec2 from_px, glm::dvec2 to_px, int frames_held = 0);
  /// Into the field that has the keyboard.
  void type(const std::string& text);
  void enter(Spot spot, const std::string& text);
  /// Into a slider: Ctrl and a click.
  void enter_into_slider(Spot spot, const std::string& text);
  /// Ctrl Z so many times, and Ctrl Shift Z.
  void undo(int count = 1);
  void redo(int count = 1);
  /// Ctrl Shift S and a name.
  void save_as(const std::string& name);
  /// As the window's system tells of files that are dropped on it.
  void drop(const std::vector<std::filesystem::path>& files);

  const present::ViewState& state() const { return viewer_->state(); }
  std::string message() const { return state().message.text; }
  /// The scene but for its camera, whose moves are no edits.
  std::string edited_text() const;
  /// Looks down at the sea by dragging the mouse, beside the panels.
  void look_at_sea();
  /// The picture without panels, sRGB; while time stands the one that nothing is left to add to.
  std::vector<unsigned char> picture();
  int width() const;
  int height() const;

  /// The main panel, the values below it, the timeline, the list that a combo box has opened, or the menu
  /// that a button has.
  static ImGuiWindow* main_panel();
  static ImGuiWindow* values();
  static ImGuiWindow* timeline();
  static ImGuiWindow* open_list();
  static ImGuiWindow* open_menu();
  /// Moves the mouse over a window, `x_px` right of its edge, then elsewhere, until it hovers the item of
  /// this label, scrolling as far as needed; a failure if it is not there. Items of repeated sections have
  /// the number of their element.
  Spot find(ImGuiWindow* window, const std::string& label, int x_px = 60, std::optional<int> element = {});
  /// The first field of three.
  Spot find_triple(ImGuiWindow* window, const std::string& label, std::optional<int> element = {});
  void toggle_header(const std::string& title) { click(find(values(), title)); }
  void choose(const std::string& combo, const std::string& name, std::optional<int> element = {});
  /// The same of an item that ImGui knows by this id.
  Spot find_item(ImGuiWindow* window, const std::string& label, unsigned id, int x_px);
  /// Where the timeline shows a time.
  Spot on_timeline(double time_s) const;
  /// Frames go by until all clouds are made.
  void wait_for_clouds();

  TemporaryFolder folder_;
  std::unique_ptr<VirtualDisplay> display_;
  std::unique_ptr<Hands> hands_;
  CancelToken cancel_;  // of nobody
  std::unique_ptr<present::Viewer> viewer_;

 private:
  bool is_hovered(unsigned id) const;
  std::optional<Spot> spot_of(ImGuiWindow* window, unsigned id, int x_px);

  int last_y_ = 0;  // of the last item found
  int steps_ = 0;
};

}  // namespace offing::test
