#include "present/window/key_bindings.h"

#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace offing::present {
namespace {

// Fails if two actions share a key, of which one would be lost.
TEST(KeyBindingsTest, KeysAreNotShared) {
  std::set<std::pair<int, int>> keys;
  for (const KeyBinding& binding : key_bindings()) {
    for (int key = binding.key; key < binding.key + binding.keys; ++key)
      EXPECT_TRUE(keys.insert({key, binding.modifiers}).second) << binding.name;
  }
}

// Fails if a key with Ctrl does what it does without, a number is lost, or keys that do nothing do something.
TEST(KeyBindingsTest, AreFoundByKeyAndModifiers) {
  const auto expect = [](int key, int modifiers, ViewAction action, int number) {
    const std::optional<KeyPress> press = press_of(key, modifiers);
    ASSERT_TRUE(press) << key;
    EXPECT_EQ(press->action, action) << key;
    EXPECT_EQ(press->number, number) << key;
  };
  expect(GLFW_KEY_7, 0, ViewAction::go_to_bookmark, 7);
  expect(GLFW_KEY_1, GLFW_MOD_SHIFT, ViewAction::go_to_bookmark, 1);
  expect(GLFW_KEY_9, GLFW_MOD_CONTROL, ViewAction::set_bookmark, 9);
  expect(GLFW_KEY_Z, GLFW_MOD_CONTROL, ViewAction::undo, 1);
  expect(GLFW_KEY_Z, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT, ViewAction::redo, 1);
  expect(GLFW_KEY_Y, GLFW_MOD_CONTROL, ViewAction::redo, 1);
  expect(GLFW_KEY_S, GLFW_MOD_CONTROL, ViewAction::save, 1);
  expect(GLFW_KEY_S, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT, ViewAction::save_as, 1);
  expect(GLFW_KEY_Q, GLFW_MOD_CONTROL, ViewAction::quit, 1);
  expect(GLFW_KEY_ESCAPE, 0, ViewAction::deselect, 1);
  expect(GLFW_KEY_H, GLFW_MOD_ALT, ViewAction::toggle_help, 1);
  expect(GLFW_KEY_0, 0, ViewAction::reset_camera, 1);
  EXPECT_FALSE(press_of(GLFW_KEY_H, GLFW_MOD_CONTROL));
  EXPECT_FALSE(press_of(GLFW_KEY_Z, 0));
  EXPECT_FALSE(press_of(GLFW_KEY_U, 0));
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
