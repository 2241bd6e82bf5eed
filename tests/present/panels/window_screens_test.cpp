// What a window shows with each kind of selection and each dialog, in windows of four usual sizes.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <epoxy/gl.h>
#include <fmt/format.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
// Windows of the panels, which only ImGui knows.
#include <imgui_internal.h>

#include "host/io/png_image.h"
#include "host/scene/file/scene_file.h"
#include "present/editing/objects/selection.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

using present::ObjectKind;
using present::SceneObject;

/// One of each kind of object and list, with long names.
constexpr const char* all_kinds = R"(version = 1
[camera]
y_m = 5
z_m = 14
pitch_deg = -8
[ocean]
size = 32
cascade_count = 1
[[ocean.wake]]
centre = "place"
length_m = 24
cells = 32
history_s = 1
[terrain]
file = "crater.asc"
origin_z_m = -500
[[terrain.material]]
name = "black sand of the beaches"
highest_m = 5
[[lake]]
name = "the lake in the crater"
x_m = 0
z_m = -340
[[mesh]]
name = "the hull of the ferry to the outer islands"
shape = "ship"
size_m = 6
detail = 1
highlights = "off"
[[mesh]]
name = "ball"
shape = "sphere"
size_m = 1.5
detail = 2
y_m = 4
x_m = { keys = [{ t = 0, value = -4 }, { t = 2, value = 4 }] }
[[mesh.highlight]]
[[light]]
name = "lantern"
kind = "place"
x_m = -2
y_m = 7
z_m = 4
[[body]]
name = "ferry"
mesh = "the hull of the ferry to the outer islands"
draught_m = 0.4
x_m = 3
z_m = -4
[clouds]
quality = 0.1
[[cloud]]
name = "heap"
y_m = 300
z_m = -1200
[[cloud_layer]]
coverage = 0
extent_m = 500
y_m = 400
[[bookmark]]
name = "from the pier"
y_m = 3
)";

struct WindowSize {
  int width, height;
  double scale;
};

class WindowScreensTest : public WindowTest, public testing::WithParamInterface<WindowSize> {
 protected:
  /// The largest of the windows: the mouse cannot leave the display.
  std::string display_size() const override { return "3840x2160x24"; }
  void open_all() {
    std::filesystem::create_directory(folder_.path() / "scenes");
    const std::string file = (folder_.path() / "scenes" / "harbour.toml").string();
    std::ofstream(file) << all_kinds;
    std::ofstream map(folder_.path() / "scenes" / "crater.asc");
    map << "ncols 9\nnrows 9\nxllcenter 0\nyllcenter 0\ncellsize 40\n";
    for (int post = 0; post < 81; ++post) {
      const int ring = std::max(std::abs(post / 9 - 4), std::abs(post % 9 - 4));
      map << (ring > 2 ? -12 : 8 + 10 * ring) << (post % 9 == 8 ? '\n' : ' ');
    }
    map.close();
    present::ViewOptions options = quick_options();
    options.scene = scene::load_scene(file);
    options.scene_file = file;
    options.scene_name = "harbour";
    options.render_scale = 0.1;
    options.ui_scale = GetParam().scale;
    open(options);
    glfwSetWindowSize(viewer_->window(), GetParam().width, GetParam().height);
    turn(5);
    open_parts();
    wait_for_clouds();
    settle();
  }
  static ImGuiWindow* list_of_objects() {
    const unsigned list_id = main_panel()->GetID("objects");
    return ImGui::FindWindowByName(fmt::format("Offing/objects_{:08X}", list_id).c_str());
  }
  /// The rows of the ferry's parts.
  static void open_parts() {
    const int kind = static_cast<int>(ObjectKind::body), index = 0;
    ImGuiWindow* list = list_of_objects();
    const unsigned row = ImHashData(&index, sizeof index, ImHashData(&kind, sizeof kind, list->ID));
    list->StateStorage.SetBool(ImHashStr("is open", 0, row), true);
  }
  void select(const SceneObject& object) {
    const std::vector<SceneObject> objects = present::objects_of(state().scene);
    const auto number = static_cast<float>(std::ranges::find(objects, object) - objects.begin());
    ImGuiWindow* list = list_of_objects();
    ASSERT_NE(list, nullptr);
    const float row_px = ImGui::GetFontSize() + ImGui::GetStyle().ItemSpacing.y;
    // A second click at the same place would rename. ImGui's own clock stands while the window rests.
    const double end_s = glfwGetTime() + double{ImGui::GetIO().MouseDoubleClickTime};
    while (glfwGetTime() < end_s) turn();
    ImGui::SetScrollY(main_panel(), 0.0f);
    ImGui::SetScrollY(list, std::max(0.0f, (number - 1.0f) * row_px));
    // Panels that nothing happens to are drawn now and then alone.
    hands_->move_to(static_cast<int>(list->Pos.x), static_cast<int>(list->Pos.y));
    turn(3);
    const float y_px = list->DC.CursorStartPos.y + (number + 0.4f) * row_px;
    click({static_cast<int>(list->Pos.x + 6.0f * ImGui::GetFontSize()), static_cast<int>(y_px)});
    turn(2);
    EXPECT_EQ(present::selected_object(state()), object);
  }
  void hold_and_press(const char* first, const char* second, const char* key) {
    hands_->key(first, Hands::Motion::down);
    if (second != nullptr) hands_->key(second, Hands::Motion::down);
    turn();
    press(key);
    if (second != nullptr) hands_->key(second, Hands::Motion::up);
    hands_->key(first, Hands::Motion::up);
    turn(4);
  }

  /// Checks what is shown now, and keeps a picture of it in the folder of OFFING_SCREENS, if it is set.
  void expect_readable(const std::string& what) {
    SCOPED_TRACE(what);
    turn(2);
    keep_picture(what);
    std::vector<const ImGuiWindow*> panels;
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
      const std::string_view name = window->Name;
      if (!window->WasActive || window->Hidden || name == "Debug##Default" || name == "panel edge") continue;
      expect_content_fits(*window);
      if (window->ParentWindow != nullptr) continue;
      EXPECT_GE(window->Pos.x, 0.0f) << name;
      EXPECT_GE(window->Pos.y, 0.0f) << name;
      EXPECT_LE(window->Pos.x + window->Size.x, static_cast<float>(GetParam().width)) << name;
      EXPECT_LE(window->Pos.y + window->Size.y, static_cast<float>(GetParam().height)) << name;
      constexpr ImGuiWindowFlags in_front =
          ImGuiWindowFlags_Popup | ImGuiWindowFlags_Modal | ImGuiWindowFlags_Tooltip;
      if ((window->Flags & in_front) != 0) continue;
      if (name == "Message") continue;  // window_layout_test.cpp: it lies over the picture
      for (const ImGuiWindow* other : panels)
        EXPECT_FALSE(window->Rect().Overlaps(other->Rect())) << name << " and " << other->Name;
      panels.push_back(window);
    }
  }
  /// Nothing is wider than its window, and no letter is cut at its sides.
  static void expect_content_fits(const ImGuiWindow& window) {
    EXPECT_LE(window.ContentSize.x, window.WorkRect.GetWidth() + 1.0f) << window.Name;
    // Letters are small quads of the font's texture; lines are others.
    const float widest_px = 1.5f * ImGui::GetFontSize();
    const ImDrawList& list = *window.DrawList;
    const ImVec2 white = ImGui::GetFont()->ContainerAtlas->TexUvWhitePixel;
    for (const ImDrawCmd& command : list.CmdBuffer) {
      for (unsigned i = 0; i + 5 < command.ElemCount; i += 6) {
        float low = 1e9f, high = -1e9f;
        bool is_letter = true;
        for (unsigned corner = 0; corner < 6; ++corner) {
          const unsigned index = list.IdxBuffer[static_cast<int>(command.IdxOffset + i + corner)];
          const ImDrawVert& vertex = list.VtxBuffer[static_cast<int>(command.VtxOffset + index)];
          is_letter = is_letter && (vertex.uv.x != white.x || vertex.uv.y != white.y);
          low = std::min(low, vertex.pos.x);
          high = std::max(high, vertex.pos.x);
        }
        if (!is_letter || high - low > widest_px) continue;
        if (low < command.ClipRect.x - 1.0f || high > command.ClipRect.z + 1.0f) {
          ADD_FAILURE() << window.Name << ": a letter at " << low << " to " << high << " is cut at "
                        << command.ClipRect.x << " or " << command.ClipRect.z;
          return;
        }
      }
    }
  }
  void keep_picture(const std::string& what) const {
    const char* folder = std::getenv("OFFING_SCREENS");
    if (folder == nullptr) return;
    const int width = GetParam().width, height = GetParam().height;
    const auto row = static_cast<std::size_t>(3 * width);
    RgbImage image{.width = width, .height = height, .rgb = {}};
    image.rgb.resize(row * static_cast<std::size_t>(height));
    std::vector<std::uint8_t> upward(image.rgb.size());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glReadBuffer(GL_BACK);  // which a swap leaves as it is where the CPU draws
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, upward.data());
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
      std::copy_n(upward.end() - static_cast<std::ptrdiff_t>((y + 1) * row), row,
                  image.rgb.begin() + static_cast<std::ptrdiff_t>(y * row));
    write_png(std::filesystem::path(folder) / fmt::format("{}_{}.png", width, what), image, Existing::replace,
              PngCompression::fast);
  }
};

// Fails if a panel leaves the window or covers another, or something is wider than its panel, whatever is
// selected.
TEST_P(WindowScreensTest, OfEachSelection) {
  open_all();
  expect_readable("nothing");
  for (const SceneObject& object : {SceneObject{ObjectKind::camera, 0},
                                    {ObjectKind::bookmark, 0},
                                    {ObjectKind::sky, 0},
                                    {ObjectKind::sea, 0},
                                    {ObjectKind::wake, 0},
                                    {ObjectKind::terrain, 0},
                                    {ObjectKind::lake, 0},
                                    {ObjectKind::cloud_layer, 0},
                                    {ObjectKind::cloud, 0},
                                    {ObjectKind::mesh, 0},
                                    {ObjectKind::mesh, 1},
                                    {ObjectKind::body, 0},
                                    {ObjectKind::light, 0}}) {
    select(object);
    expect_readable(present::label_of(state().scene, object));
  }
}

// Fails as above for dialogs and the other panels.
TEST_P(WindowScreensTest, OfEachDialog) {
  open_all();
  press("h");
  expect_readable("help");
  press("h");
  press_with_control("f");
  turn(2);
  type("height");
  expect_readable("search");
  press_with_control("a");
  press("BackSpace");
  press("Return");
  press_with_control("o");
  expect_readable("open");
  press("Escape");
  hold_and_press("Shift_L", "Control_L", "s");
  expect_readable("save as");
  press("Escape");
  press_with_control("r");
  expect_readable("record");
  type("100000");
  press("Return");
  turn(2);
  ASSERT_TRUE(viewer_->is_recording());
  expect_readable("recording");
  click(find(timeline(), "cancel##recording", static_cast<int>(timeline()->Size.x) - 30));
  while (viewer_->is_recording()) turn();
  click(find(main_panel(), "add##objects", 20));
  expect_readable("new objects");
  press("Escape");
  select({ObjectKind::sea, 0});
  press_with_control("1");
  expect_readable("message");
  press_with_control("q");
  expect_readable("quit");
  press("Escape");
  press("c");
  expect_readable("place clouds");
}

INSTANTIATE_TEST_SUITE_P(Sizes, WindowScreensTest,
                         testing::Values(WindowSize{900, 500, 1.0}, WindowSize{1280, 720, 1.0},
                                         WindowSize{1920, 1080, 1.0}, WindowSize{3840, 2160, 2.0}),
                         [](const auto& size) { return fmt::format("{}", size.param.width); });

}  // namespace
}  // namespace offing::test
