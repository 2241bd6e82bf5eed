#include "present/panels/look.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <imgui.h>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/io/atomic_file.h"
#include "present/panels/imgui_versions.h"

namespace offing::present {
namespace {

// Of the letters that ImGui's own sizes are made for.
constexpr float imgui_text_px = 13.0f;

int window_side(const std::string& value, int usual) {
  constexpr int least = 200, most = 16'384;
  const int read = std::atoi(value.c_str());
  return read > 0 ? std::clamp(read, least, most) : usual;
}

}  // namespace

Look read_look(const std::filesystem::path& file) {
  Look look;
  std::ifstream lines(file);
  for (std::string name, value; lines >> name >> value;) {
    if (name == "theme") look.theme = value == theme_names[1] ? Theme::light : Theme::dark;
    const auto number = [&](float least, float most, float usual) {
      const double read = std::atof(value.c_str());
      return read > 0.0 ? std::clamp(static_cast<float>(read), least, most) : usual;
    };
    if (name == "text_scale")
      look.text_scale = number(text_scales.front(), text_scales.back(), look.text_scale);
    if (name == "window_width") look.window.width = window_side(value, look.window.width);
    if (name == "window_height") look.window.height = window_side(value, look.window.height);
    if (name == "maximised") look.window.is_maximised = value == "yes";
    if (name == "panel_em") look.panel_em = number(least_panel_em, most_panel_em, look.panel_em);
  }
  return look;
}

void write_look(const std::filesystem::path& file, const Look& look) {
  if (file.empty()) return;
  try {
    std::error_code failed;
    std::filesystem::create_directories(file.parent_path(), failed);
    write_file_atomically(
        file,
        fmt::format("theme {}\ntext_scale {}\npanel_em {}\nwindow_width {}\nwindow_height {}\nmaximised {}\n",
                    theme_names[static_cast<std::size_t>(look.theme)], look.text_scale, look.panel_em,
                    look.window.width, look.window.height, look.window.is_maximised ? "yes" : "no"));
  } catch (const Error& error) {
    spdlog::debug("{}", error.what());
  }
}

void set_style(Theme theme, float text_px) {
  ImGuiStyle style;
  style.WindowRounding = 4.0f;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = 3.0f;
  style.ScaleAllSizes(text_px / imgui_text_px);
  if (theme == Theme::light) {
    ImGui::StyleColorsLight(&style);
    style.FrameBorderSize = 1.0f;
  } else {
    ImGui::StyleColorsDark(&style);
  }
  style.Colors[ImGuiCol_ModalWindowDimBg] = ImVec4(0.0f, 0.0f, 0.0f, 0.45f);
  style.Colors[ImGuiCol_PopupBg].w = 1.0f;  // what a menu covers is text
  ImGui::GetStyle() = style;
  set_font_height(std::round(text_px));
}

unsigned fault_colour() {
  const ImVec4& back = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
  constexpr float middle = 0.5f;
  return back.x > middle ? IM_COL32(190, 40, 15, 255) : IM_COL32(255, 115, 90, 255);
}

}  // namespace offing::present
