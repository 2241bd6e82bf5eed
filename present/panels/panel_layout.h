#pragma once

#include <string_view>

#include "present/window/free_camera.h"

namespace offing::present {

/// Where panels lie: the timeline at the bottom, the main one at the left with that of values below it,
/// others below each other at the right, none over another as long as the window has room, and none beyond
/// its edge. Messages lie over the picture between them. Sizes are of ImGui's screen.
class PanelLayout {
 public:
  /// At the begin of each frame.
  void begin();
  /// Of the picture between the main panel and those at the right, by the last frame; all of it where that
  /// is narrow.
  FreeWidth free_width() const;
  /// Between panels, and between them and the window's edge.
  static float margin();

  /// Before Begin() of the main panel, whose width is so many heights of letters.
  void place_main(float width_em);
  /// Between its Begin() and End(): the height that is left for it below what is drawn.
  float main_room() const;
  /// Before its End().
  void end_main();
  /// Before Begin() of the panel of values, as wide as the main one, and as high as its content up to what is
  /// free below that.
  void place_values() const;
  /// After the End() of both: a bar at their edge that the mouse pulls; the new width.
  float draw_main_edge(float width_em);
  /// Before Begin() of a panel at the right that is as large as its content, up to what is free.
  void place_right();
  /// Before End() of such a panel.
  void end_right();
  /// How wide such a panel can be.
  float right_width() const;
  /// Before Begin() of what stands at the bottom, beside the main panel or at the right, and before its
  /// End().
  void place_low_left() const;
  void end_low_left();
  void place_low_right() const;
  void end_low_right();
  /// Before Begin() of the timeline, as wide as the window, and before its End().
  void place_timeline() const;
  void end_timeline();
  /// Before Begin() of the message, which moves nothing else; and how wide it can be.
  void place_message() const;
  float message_width() const;

 private:
  float timeline_top() const;
  float bottom() const;

  float main_px_ = 0.0f, main_end_px_ = 0.0f;  // right and lower end of the main panel
  float right_px_ = 0.0f;                      // where the next panel at the right begins
  // Of the frame before: heights, and the left end of the panels at the right.
  float low_px_ = 0.0f, low_left_px_ = 0.0f, timeline_px_ = 0.0f, right_begin_px_ = 0.0f;
  float next_low_px_ = 0.0f, next_low_left_px_ = 0.0f, next_timeline_px_ = 0.0f, next_right_begin_px_ = 0.0f;
};

/// Shows help on the last item while the mouse is over it: beside its panel, so that it covers none of the
/// panel's names, or below or above the item if there is no room beside the panel.
void explain_item(std::string_view help);

/// A button that is to be drawn next stays in the line of the last one, unless it leaves the panel there.
void stay_in_line(const char* label);

}  // namespace offing::present
