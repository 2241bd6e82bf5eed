#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace offing::present {

/// A font of this system, one of those in its file.
struct SystemFont {
  std::string file;
  int number = 0;
  std::set<char32_t> letters;  ///< those that are wanted of it
};
/// The fonts of this system that have these letters, the best one first, each for those that the ones before
/// it lack; without the letters that none has.
std::vector<SystemFont> fonts_for(std::set<char32_t> letters);

/// The letters of the panels: those of Western Europe of this system's usual font without serifs
/// (fontconfig), or of ImGui's own where there is none, and all others of fonts that have them, looked for
/// and loaded once a text needs them, with the glyphs that texts have needed so far and no more. A letter
/// that no font has is shown as "?".
class PanelFonts {
 public:
  /// Height of the letters, from ascender to descender.
  void set_height(float height_px);
  float height_px() const { return height_px_; }
  /// A text that is to be shown, UTF-8.
  void need(std::string_view text);
  /// Between frames: makes the current ImGui context's fonts anew where a letter has come that they lack.
  /// True if it did: what was made of them is to be made anew.
  bool update();

 private:
  std::set<char32_t> needed_;                       // beyond the usual ones
  std::optional<std::optional<SystemFont>> usual_;  // once it was looked for
  float height_px_ = 16.0f;
  bool is_new_ = true;
};

}  // namespace offing::present
