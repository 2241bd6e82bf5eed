#pragma once

#include <string>

namespace offing::present {

/// Where panels lie: the timeline at the bottom, messages above it, the main one at the left, others below
/// each other at the right, none over another as long as the window has room, and none beyond its edge. Sizes
/// are of ImGui's screen.
class PanelLayout {
 public:
  /// At the begin of each frame.
  void begin();
  /// Between panels, and between them and the window's edge.
  static float margin();

  /// Before Begin() of the main panel, whose width is so many heights of letters.
  void place_main(float width_em);
  /// After its End(): a bar at its edge that the mouse pulls; the new width.
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
  void place_low_right() const;
  void end_low();
  /// Before Begin() of the timeline, as wide as the window, and before its End().
  void place_timeline() const;
  void end_timeline();
  /// Before Begin() of the message, and before its End().
  void place_message() const;
  void end_message();

 private:
  float timeline_top() const;
  float bottom() const;

  float main_px_ = 0.0f;                                          // right end of the main panel
  float right_px_ = 0.0f;                                         // where the next panel at the right begins
  float low_px_ = 0.0f, message_px_ = 0.0f, timeline_px_ = 0.0f;  // heights of the frame before
  float next_low_px_ = 0.0f, next_message_px_ = 0.0f, next_timeline_px_ = 0.0f;
};

/// A button that is to be drawn next stays in the line of the last one, unless it leaves the panel there.
void stay_in_line(const char* label);

}  // namespace offing::present
