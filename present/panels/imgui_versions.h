#pragma once

#include <cstdint>

#include <imgui.h>
// The order matters: the backend builds on imgui.h.
#include <backends/imgui_impl_opengl3.h>

/// What differs between ImGui 1.86 and 1.92, which distributions have.
namespace offing::present {

/// Since 1.92 glyphs are loaded as they are drawn, from fonts that stay open. Before, all are made at once,
/// of ranges of letters, in a texture that the backend is told to renew.
inline constexpr bool imgui_loads_glyphs = IMGUI_VERSION_NUM >= 19200;

inline void renew_font_texture() {
#if IMGUI_VERSION_NUM < 19200
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
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

/// The name of an OpenGL texture: a pointer for ImGui before 1.91.4.
inline ImTextureID texture_id(unsigned name) {
#if IMGUI_VERSION_NUM < 19140
  return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(name));
#else
  return name;
#endif
}

}  // namespace offing::present
