#include "present/key_bindings.h"

#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace offing::present {
namespace {

// Fails if two actions share a key, of which one would be lost.
TEST(KeyBindingsTest, KeysAreNotShared) {
  std::set<std::pair<int, int>> keys;
  for (const KeyBinding& binding : key_bindings())
    EXPECT_TRUE(keys.insert({binding.key, binding.modifiers}).second) << binding.name;
}

// Fails if the page of the window lacks a key.
TEST(KeyBindingsTest, AreDocumented) {
  std::ifstream file(OFFING_SOURCES "/docs/window.md");
  const std::string page(std::istreambuf_iterator<char>(file), {});
  for (const KeyBinding& binding : key_bindings()) {
    EXPECT_NE(page.find(fmt::format("\n| {} | ", binding.name)), std::string::npos) << binding.name;
  }
  for (const CameraControl& control : camera_controls()) {
    EXPECT_NE(page.find(fmt::format("\n| {} | {} |", control.name, control.help)), std::string::npos)
        << control.name;
  }
}

}  // namespace
}  // namespace offing::present
