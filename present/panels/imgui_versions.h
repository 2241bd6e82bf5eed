#pragma once

#include <cstdint>

#include <dlfcn.h>
#include <imgui.h>
// The order matters: these build on imgui.h.
#include <backends/imgui_impl_opengl3.h>
#include <imgui_internal.h>

/// What differs between ImGui 1.86 and 1.92, which distributions have.
namespace offing::present {

/// Since 1.92 glyphs are loaded as they are drawn, from fonts that stay open. Before, all are made at once,
/// of ranges of letters, in a texture that the backend is told to renew.
inline constexpr bool imgui_loads_glyphs = IMGUI_VERSION_NUM >= 19200;

/// Since 1.92 the backend lets go of OpenGL's library as it shuts down, and when it starts again calls
/// functions where they were before (https://github.com/ocornut/imgui/pull/8792). For a second window the
/// library stays.
inline void keep_opengl_loaded() {
#if IMGUI_VERSION_NUM >= 19200
  for (const char* library : {"libOpenGL.so.0", "libGL.so.1"})
    dlopen(library, RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
#endif
}

inline void renew_font_texture() {
#if IMGUI_VERSION_NUM < 19200
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

/// Since 1.92 the height is one of the style, whatever the fonts were made for.
inline void set_font_height([[maybe_unused]] float height_px) {
#if IMGUI_VERSION_NUM >= 19200
  ImGui::GetStyle().FontSizeBase = height_px;
#endif
}

/// That a font was made for.
inline float height_of(const ImFont& font) {
#if IMGUI_VERSION_NUM >= 19200
  return font.LegacySize;
#else
  return font.FontSize;
#endif
}

/// Whether the font has the letter itself, not only a sign in its place.
inline bool has_glyph(ImFont& font, ImWchar letter) {
#if IMGUI_VERSION_NUM < 19200
  return font.FindGlyphNoFallback(letter) != nullptr;
#else
  return font.IsGlyphInFont(letter);
#endif
}

/// Since 1.87 keys and clicks that came at once wait, and a frame takes one of them.
inline constexpr bool imgui_keeps_input = IMGUI_VERSION_NUM >= 18700;

/// Whether some wait.
inline bool has_waiting_input() {
#if IMGUI_VERSION_NUM < 18700
  return false;
#else
  return !ImGui::GetCurrentContext()->InputEventsQueue.empty();
#endif
}

/// Whether a key has gone down since the last frame: before 1.87 keys are counted otherwise.
inline bool is_pressed(ImGuiKey key) {
  constexpr bool repeats = false;
#if IMGUI_VERSION_NUM < 18700
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), repeats);
#else
  return ImGui::IsKeyPressed(key, repeats);
#endif
}

/// The name of an OpenGL texture: a pointer for ImGui before 1.91.4.
inline ImTextureID texture_id(unsigned name) {
#if IMGUI_VERSION_NUM < 19140
  return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(name));
#else
  return name;
#endif
}

}  // namespace offing::present
