// Panels with a mouse that the test moves, drawn without a window.
#include "present/panels/panels.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>
// The order matters: the backend builds on imgui.h.
#include <backends/imgui_impl_opengl3.h>

#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "present/gl/render_target.h"
#include "present/panels/panel_layer.h"
#include "present/panels/parameter_widget.h"
#include "tests/present/gl_test.h"

namespace offing::present {
namespace {

class PanelsTest : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    layer_ = std::make_unique<PanelLayer>(nullptr);
    target_ = RenderTarget(640, 900, GL_RGBA8, RenderTarget::Depth::none);
    ImGui::GetIO().DisplaySize = ImVec2(640.0f, 900.0f);
    ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
  }
  void TearDown() override {
    layer_.reset();
    target_ = {};
    GlTest::TearDown();
  }

  /// One frame of one widget, or of whatever is drawn; where its item lies.
  template <class Draw>
  void frame(const Draw& draw) {
    layer_->begin();
    ImGui::SetNextWindowPos(ImVec2(0.0f, 0.0f));
    ImGui::SetNextWindowSize(ImVec2(600.0f, 400.0f));
    ImGui::Begin("test");
    draw();
    ImGui::End();
    target_.bind();
    layer_->end();
  }

  std::unique_ptr<PanelLayer> layer_;
  RenderTarget target_;
  scene::Scene scene_;
};

/// Clicks at a share of a widget's width, twice, so that popups and check boxes see it; the last edit.
class WidgetClicks {
 public:
  explicit WidgetClicks(scene::Scene& scene) : scene_(scene) {}

  void draw(const scene::Parameter& row, scene::ElementIndex element = {}) {
    const Edit edit = parameter_widget(scene_, row, edit_, element);
    if (edit != Edit::none) last_edit_ = edit;
    lower_ = ImGui::GetItemRectMin();
    upper_ = ImGui::GetItemRectMax();
  }
  ImVec2 place(float share) const {
    // The label is right of the slider, which takes two thirds.
    return {lower_.x + share * 0.6f * (upper_.x - lower_.x), 0.5f * (lower_.y + upper_.y)};
  }
  Edit last_edit() const { return last_edit_; }
  const std::string& fault() const { return edit_.fault; }

 private:
  scene::Scene& scene_;
  ImVec2 lower_, upper_;
  Edit last_edit_ = Edit::none;
  EditInProgress edit_;
};

// Fails if the copy of panels that repeat() draws is off by more than rounding from ImGui's own picture:
// windows beside each other, one over another, one partly outside, and lines over all of them.
TEST_F(PanelsTest, RepeatsWhatImGuiDraws) {
  const auto clear = [&] {
    target_.bind();
    glClearColor(0.3f, 0.6f, 0.2f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  };
  clear();
  for (const bool has_lines : {false, true}) {
    layer_->begin();
    for (const ImVec2 at :
         {ImVec2(10.0f, 20.0f), ImVec2(60.0f, 100.0f), ImVec2(330.0f, 40.0f), ImVec2(560.0f, 700.0f)}) {
      ImGui::SetNextWindowPos(at);
      ImGui::SetNextWindowSize(ImVec2(200.0f, 150.0f));
      ImGui::SetNextWindowBgAlpha(0.6f);
      ImGui::Begin(std::to_string(at.x).c_str());
      ImGui::TextUnformatted("a value");
      ImGui::End();
    }
    if (has_lines)
      ImGui::GetForegroundDrawList()->AddLine({5.0f, 5.0f}, {600.0f, 850.0f}, IM_COL32(255, 80, 0, 128),
                                              3.0f);
    clear();
    layer_->end();
    const std::vector<unsigned char> first = target_.read_bytes();
    clear();
    layer_->repeat();
    EXPECT_EQ(target_.read_bytes(), first) << has_lines;
    clear();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    const std::vector<unsigned char> direct = target_.read_bytes();
    int off = 0;
    for (std::size_t i = 0; i < direct.size(); ++i) off = std::max(off, std::abs(direct[i] - first[i]));
    EXPECT_LE(off, 2) << has_lines;
    EXPECT_NE(first, std::vector<unsigned char>(first.size(), first.front()));
  }
}

// Fails if a widget cannot be drawn for some kind of row, or changes a scene that nobody touched.
TEST_F(PanelsTest, DrawWithoutChangingAnything) {
  const auto texts = [&] {
    std::vector<std::string> values;
    for (const scene::Parameter& row : scene::parameter_table()) {
      values.push_back(scene::value_text(scene_, row, scene::Digits::exact));
    }
    return values;
  };
  for (const scene::Parameter& row : scene::parameter_table()) {
    if (scene::elements_of(scene_, *row.section).empty()) scene::append_element(scene_, row, {});
  }
  const std::vector<std::string> before = texts();
  for (int i = 0; i < 3; ++i) {
    frame([&] {
      for (const scene::Parameter& row : scene::parameter_table()) {
        EditInProgress edit;
        EXPECT_EQ(parameter_widget(scene_, row, edit), Edit::none) << row.key;
        EXPECT_EQ(edit.fault, "") << row.key;
      }
    });
  }
  EXPECT_EQ(texts(), before);
}

// Fails if a slider's ends are not those of the row, or the end of an edit is missed: a drag to the right end
// of each slider of the wind and the sun; or if a pull asks for an hour of simulation.
TEST_F(PanelsTest, SlidersReachTheirRange) {
  ImGui::GetIO().MouseDoubleClickTime = 0.0f;  // which would type
  scene_.ocean.wakes.resize(1);
  scene_.ocean.parameters.foam.width = 0.6;
  for (const char* key : {"wind.speed_mps", "ocean.gamma", "sun.elevation_deg", "ocean.foam.width",
                          "camera.fov_deg", "ocean.wake.history_s"}) {
    const scene::Parameter& row = *scene::find_parameter(key);
    const double end = row.slider ? row.slider->high : row.high;
    WidgetClicks clicks(scene_);
    const auto step = [&](float share, bool is_down) {
      frame([&] { clicks.draw(row); });
      const ImVec2 place = clicks.place(share);
      ImGui::GetIO().MousePos = place;
      ImGui::GetIO().MouseDown[0] = is_down;
    };
    step(0.1f, false);
    step(0.1f, false);
    step(0.1f, true);
    step(0.5f, true);
    step(2.0f, true);
    step(2.0f, true);
    step(2.0f, false);
    step(2.0f, false);
    step(2.0f, false);
    EXPECT_EQ(clicks.last_edit(), Edit::done) << key;
    EXPECT_EQ(clicks.fault(), "");
    EXPECT_NEAR(std::stod(scene::value_text(scene_, row)), end, 1e-3 * end) << key;
  }
  EXPECT_EQ(scene_.ocean.wakes.front().history_s, 60.0);
}

// Fails if a value that the scene leaves open does not show as what the world takes, or its name is
// elsewhere than beside a value that is set.
TEST_F(PanelsTest, ValuesInForceShow) {
  const scene::Parameter& row = *scene::find_parameter("ocean.foam.fraction");
  EditInProgress edit;
  float name_ends = 0.0f;
  const auto picture = [&] {
    target_.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    frame([&] {
      parameter_widget(scene_, row, edit);
      name_ends = ImGui::GetItemRectMax().x;
    });
    return target_.read_bytes();
  };
  picture();
  const std::vector<unsigned char> unknown = picture();
  edit.computed["ocean.foam.fraction"] = 0.02;
  const std::vector<unsigned char> little = picture();
  EXPECT_EQ(picture(), little);
  const float name_ends_without = name_ends;
  edit.computed["ocean.foam.fraction"] = 0.3;
  const std::vector<unsigned char> much = picture();
  EXPECT_NE(little, unknown);
  EXPECT_NE(much, little);
  scene_.ocean.parameters.foam.fraction = 0.1;
  picture();
  EXPECT_NEAR(name_ends, name_ends_without, 1.0f);
}

// Fails if a value without effect looks like others: the size of generated terrain beside a file.
TEST_F(PanelsTest, ValuesWithoutEffectAreGrey) {
  const scene::Parameter& row = *scene::find_parameter("terrain.side_m");
  scene_.terrain.is_given = true;
  const auto brightest = [&] {
    EditInProgress edit;
    for (int i = 0; i < 2; ++i) {
      target_.bind();
      glClear(GL_COLOR_BUFFER_BIT);
      frame([&] { parameter_widget(scene_, row, edit); });
    }
    const std::vector<unsigned char> pixels = target_.read_bytes();
    int most = 0;
    // Without the letters of the window's title.
    const std::size_t below_title = pixels.size() / 900 * 30;
    for (std::size_t i = below_title; i + 3 <= pixels.size() - below_title; i += 3)
      most = std::max(most, int{std::min({pixels[i], pixels[i + 1], pixels[i + 2]})});
    return most;
  };
  EXPECT_GT(brightest(), 200);
  scene_.terrain.file = "hills.tif";
  EXPECT_LT(brightest(), 180);
}

// Fails if a value that has no default cannot be set and taken away again.
TEST_F(PanelsTest, OptionalValuesComeAndGo) {
  const scene::Parameter& row = *scene::find_parameter("ocean.depth_m");
  WidgetClicks clicks(scene_);
  frame([&] { clicks.draw(row); });
  const ImVec2 box(16.0f, clicks.place(0.0f).y);  // at the left of its row
  const auto click = [&] {
    for (const bool is_down : {false, true, false, false}) {
      ImGui::GetIO().MousePos = box;
      ImGui::GetIO().MouseDown[0] = is_down;
      frame([&] { clicks.draw(row); });
    }
  };
  click();
  EXPECT_TRUE(scene_.ocean.depth_m.has_value());
  EXPECT_EQ(clicks.last_edit(), Edit::done);
  click();
  EXPECT_FALSE(scene_.ocean.depth_m.has_value());
}

// Fails if an edit of an element changes another one, ends only one of its keyframes, or if a triple is not
// stored: a drag to the right over each of three kinds of widgets.
TEST_F(PanelsTest, ElementsAreEditedOnTheirOwn) {
  ImGui::GetIO().MouseDoubleClickTime = 0.0f;  // which would open a field to type in
  scene_.meshes.resize(2);
  scene_.meshes[1].highlights.resize(2);
  const struct {
    const char* key;
    scene::ElementIndex element;
  } cases[] = {{"mesh.colour", {1, 0}}, {"mesh.detail", {1, 0}}, {"mesh.highlight.opacity", {1, 1}}};
  for (const auto& [key, element] : cases) {
    const scene::Parameter& row = *scene::find_parameter(key);
    for (std::size_t i = 0; i < scene::numbers_of(scene_, row, element).size(); ++i) {
      scene_.tracks[{row.key, element, i}] = {.keys = {{0.0, 0.5}}};
    }
    const scene::Scene before = scene_;
    WidgetClicks clicks(scene_);
    for (const auto& [share, is_down] : {std::pair(0.1f, false),
                                         {0.1f, false},
                                         {0.1f, true},
                                         {0.2f, true},
                                         {0.3f, true},
                                         {0.3f, false},
                                         {0.3f, false}}) {
      frame([&] { clicks.draw(row, element); });
      ImGui::GetIO().MousePos = clicks.place(share);
      ImGui::GetIO().MouseDown[0] = is_down;
    }
    frame([&] { clicks.draw(row, element); });
    EXPECT_EQ(clicks.last_edit(), Edit::done) << key << ": " << clicks.fault();
    EXPECT_TRUE(scene_.tracks.empty()) << key;
    for (const scene::ElementIndex each : scene::elements_of(scene_, *row.section)) {
      const bool is_changed = scene::value_text(scene_, row, each, scene::Digits::exact) !=
                              scene::value_text(before, row, each, scene::Digits::exact);
      EXPECT_EQ(is_changed, each == element) << key;
    }
  }
}

// Fails if the panels as a whole cannot be drawn, whatever is shown, or edit a sea that nobody touched.
TEST_F(PanelsTest, AllPanelsDraw) {
  StageTimes times;
  const ocl::DeviceInfo device = ocl::select_device();
  scene::Scene scene;
  scene.ocean.is_given = true;
  scene.meshes.resize(1);  // whose panels are there with one
  ViewState state{.scene = scene, .camera = FreeCamera(Camera{}), .clock = SceneClock(0.0)};
  state.message = {.text = "a message\nof two lines"};
  for (const bool shows_help : {false, true}) {
    state.shows_help = shows_help;
    for (int i = 0; i < 3; ++i) {
      layer_->begin();
      const PanelEdits edits = draw_panels(state, {.times = times,
                                                   .capabilities = context_->capabilities(),
                                                   .device = device,
                                                   .transfer = TransferPath::mapped_pointer,
                                                   .width_px = 640,
                                                   .height_px = 360});
      target_.bind();
      layer_->end();
      EXPECT_EQ(edits.scene, Edit::none);
      EXPECT_FALSE(edits.is_camera_moved);
    }
  }
}

}  // namespace
}  // namespace offing::present
