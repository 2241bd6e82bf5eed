#include "present/panels/panel_fonts.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include <fontconfig/fontconfig.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <unistd.h>

#include "present/panels/imgui_versions.h"

namespace offing::present {
namespace {

// The usual font has these, and letters are of 16 bits in ImGui.
constexpr char32_t last_own = 0xFF, last_letter = 0xFFFF;

template <auto destroy>
struct Destroy {
  template <typename T>
  void operator()(T* object) const {
    destroy(object);
  }
};
template <typename T, auto destroy>
using Owned = std::unique_ptr<T, Destroy<destroy>>;

/// Pairs of first and last, each letter alone, 0 at the end: as ImGui takes them.
std::vector<ImWchar> ranges_of(const std::set<char32_t>& letters) {
  std::vector<ImWchar> ranges;
  for (const char32_t letter : letters) ranges.insert(ranges.end(), 2, static_cast<ImWchar>(letter));
  ranges.push_back(0);
  return ranges;
}

/// True if all of the fonts could be made; they are without glyphs otherwise.
bool make_fonts(ImFontAtlas& atlas, const std::optional<SystemFont>& usual,
                const std::vector<SystemFont>& fonts, float height_px) {
  atlas.Clear();
  ImFontConfig first;
  first.SizePixels = height_px;
  if (usual) {
    first.FontNo = usual->number;
    if (atlas.AddFontFromFileTTF(usual->file.c_str(), height_px, &first) == nullptr) return false;
  } else {
    atlas.AddFontDefault(&first);
  }
  std::vector<std::vector<ImWchar>> ranges;  // which ImGui reads until the end
  bool is_made = true;
  for (const SystemFont& font : fonts) {
    ImFontConfig config;
    config.MergeMode = true;
    config.FontNo = font.number;
    ranges.push_back(ranges_of(font.letters));
    const ImWchar* letters = imgui_loads_glyphs ? nullptr : ranges.back().data();
    is_made &= atlas.AddFontFromFileTTF(font.file.c_str(), height_px, &config, letters) != nullptr;
  }
  if (imgui_loads_glyphs) return is_made;
  is_made &= atlas.Build();
  atlas.ClearInputData();  // files of up to 20 MB
  return is_made;
}

std::string_view text_of(FcPattern& font, const char* what) {
  FcChar8* text = nullptr;
  if (FcPatternGetString(&font, what, 0, &text) != FcResultMatch) return {};
  return reinterpret_cast<const char*>(text);
}

/// A font with any of these letters, if ImGui can read it.
std::optional<SystemFont> readable_font(FcPattern& font, const std::set<char32_t>& letters) {
  const std::string_view file = text_of(font, FC_FILE), format = text_of(font, FC_FONTFORMAT);
  FcCharSet* has = nullptr;
  if ((format != "TrueType" && format != "CFF") || access(std::string(file).c_str(), R_OK) != 0 ||
      FcPatternGetCharSet(&font, FC_CHARSET, 0, &has) != FcResultMatch) {
    return {};
  }
  int number = 0;
  FcPatternGetInteger(&font, FC_INDEX, 0, &number);
  constexpr int number_bits = 0xFFFF;  // those above name an instance of a variable font
  SystemFont found{.file = std::string(file), .number = number & number_bits, .letters = {}};
  for (const char32_t letter : letters) {
    if (FcCharSetHasChar(has, letter) == FcTrue) found.letters.insert(letter);
  }
  if (found.letters.empty()) return {};
  return found;
}

}  // namespace

std::vector<SystemFont> fonts_for(std::set<char32_t> letters) {
  if (letters.empty()) return {};
  const Owned<FcConfig, FcConfigDestroy> config(FcInitLoadConfigAndFonts());
  const Owned<FcPattern, FcPatternDestroy> wanted(FcPatternCreate());
  const Owned<FcCharSet, FcCharSetDestroy> charset(FcCharSetCreate());
  if (!config || !wanted || !charset) return {};
  for (const char32_t letter : letters) FcCharSetAddChar(charset.get(), letter);
  FcPatternAddCharSet(wanted.get(), FC_CHARSET, charset.get());
  FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
  FcConfigSubstitute(config.get(), wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Owned<FcFontSet, FcFontSetDestroy> sorted(
      FcFontSort(config.get(), wanted.get(), FcTrue, nullptr, &result));
  std::vector<SystemFont> fonts;
  for (int i = 0; sorted && i < sorted->nfont && !letters.empty(); ++i) {
    std::optional<SystemFont> font = readable_font(*sorted->fonts[i], letters);
    if (!font) continue;
    for (const char32_t letter : font->letters) letters.erase(letter);
    fonts.push_back(std::move(*font));
  }
  return fonts;
}

void PanelFonts::set_height(float height_px) {
  is_new_ = is_new_ || height_px != height_px_;
  height_px_ = height_px;
}

void PanelFonts::need(std::string_view text) {
  const char* at = text.data();
  const char* end = at + text.size();
  while (at < end) {
    unsigned letter = 0;
    at += std::max(1, ImTextCharFromUtf8(&letter, at, end));
    if (letter > last_own && letter <= last_letter && letter != IM_UNICODE_CODEPOINT_INVALID) {
      is_new_ = needed_.insert(letter).second || is_new_;
    }
  }
}

bool PanelFonts::update() {
  if (!std::exchange(is_new_, false)) return false;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  if (!usual_) {
    const std::vector<SystemFont> found = fonts_for({U'a'});
    usual_ = found.empty() ? std::nullopt : std::optional(found.front());
  }
  const float height_px = std::round(height_px_);
  if (!make_fonts(atlas, *usual_, fonts_for(needed_), height_px) &&
      !make_fonts(atlas, *usual_, {}, height_px))
    make_fonts(atlas, {}, {}, height_px);
  return true;
}

}  // namespace offing::present
