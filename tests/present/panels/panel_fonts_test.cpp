// Letters of other languages in the panels.
#include "present/panels/panel_fonts.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "present/panels/imgui_versions.h"

namespace offing::present {
namespace {

class PanelFontsTest : public testing::Test {
 protected:
  void SetUp() override {
    ImGui::CreateContext();
    EXPECT_TRUE(fonts_.update()) << "there is none before";
  }
  void TearDown() override { ImGui::DestroyContext(); }

  static bool is_shown(ImWchar letter) { return has_glyph(*ImGui::GetIO().Fonts->Fonts[0], letter); }

  PanelFonts fonts_;
};

// Fails if names in Korean, Japanese or Polish are shown as question marks where a font of the system has
// their letters, or fonts are made anew with each frame; if what was shown before goes.
TEST_F(PanelFontsTest, LettersAreFoundAsTheyAreNeeded) {
  if (fonts_for({U'배', U'海', U'ł'}).empty()) GTEST_SKIP() << "no font here has Korean, Japanese or Polish";
  fonts_.need("ł");
  EXPECT_TRUE(fonts_.update());
  EXPECT_FALSE(is_shown(U'배'));
  fonts_.need("배와 海.toml");
  EXPECT_TRUE(fonts_.update());
  fonts_.need("배와 海.toml");
  EXPECT_FALSE(fonts_.update());
  for (const char32_t letter : {U'배', U'와', U'海', U'ł'}) {
    EXPECT_EQ(is_shown(static_cast<ImWchar>(letter)), !fonts_for({letter}).empty());
  }
  EXPECT_TRUE(is_shown('a'));
}

// Fails if windows that need no other letters pay for them.
TEST_F(PanelFontsTest, WesternEuropeNeedsNone) {
  fonts_.need("año über ship.toml");
  EXPECT_FALSE(fonts_.update());
}

// Fails if letters do not get the height that is asked for, or fonts are made anew without need.
TEST_F(PanelFontsTest, HaveTheirHeight) {
  fonts_.set_height(32.0f);
  EXPECT_TRUE(fonts_.update());
  EXPECT_EQ(height_of(*ImGui::GetIO().Fonts->Fonts[0]), 32.0f);
  fonts_.set_height(32.0f);
  EXPECT_FALSE(fonts_.update());
}

// Fails if text that no font has, or that is no UTF-8, ends the window or is looked for over and over.
TEST_F(PanelFontsTest, WhatIsNowhereIsAQuestionMark) {
  fonts_.need("\xEE\x80\x80 \xFF\xC3");  // private use; broken
  EXPECT_TRUE(fonts_.update());
  EXPECT_FALSE(is_shown(0xE000) && fonts_for({U'\xE000'}).empty());
  EXPECT_TRUE(is_shown('a'));
  fonts_.need("\xEE\x80\x80");
  EXPECT_FALSE(fonts_.update());
}

}  // namespace
}  // namespace offing::present
