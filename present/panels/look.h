#pragma once

#include <array>
#include <filesystem>

namespace offing::present {

enum class Theme { dark, light };
inline constexpr std::array<const char*, 2> theme_names{"dark", "light"};

/// How large a window is, in its system's units.
struct WindowExtent {
  int width = 1280, height = 720;  ///< while it is not maximised
  bool is_maximised = false;

  bool operator==(const WindowExtent&) const = default;
};

/// How the window and its panels look, as far as the user chooses it and windows remember it.
struct Look {
  Theme theme = Theme::dark;
  float text_scale = 1.0f;  ///< on top of the monitor's scale
  float panel_em = 25.0f;   ///< width of the main panel, in heights of its letters
  WindowExtent window = {};

  bool operator==(const Look&) const = default;
};
inline constexpr std::array<float, 8> text_scales{0.7f, 0.8f, 0.9f, 1.0f, 1.25f, 1.5f, 2.0f, 3.0f};
inline constexpr float least_panel_em = 18.0f, most_panel_em = 60.0f;

/// As write_look() has written it; what is missing or out of range is as usual.
Look read_look(const std::filesystem::path& file);
/// A file that cannot be written stays as it is. An empty name is no file.
void write_look(const std::filesystem::path& file, const Look& look);

/// ImGui's colours and sizes, for letters of this height.
void set_style(Theme theme, float text_px);
/// A text that tells of a fault, in colours that the theme shows.
unsigned fault_colour();

}  // namespace offing::present
