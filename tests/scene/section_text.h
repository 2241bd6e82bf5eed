#pragma once

#include <string>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/file/scene_file.h"

namespace offing::scene::test {

/// A scene of these sections, in a file a.toml.
inline Scene scene_of(const std::string& text, const std::string& folder = "") {
  return parse_scene("version = 1\n" + text, "a.toml", folder);
}

/// What is said of sections that are refused, which must have a hint; empty where they are not.
inline std::string refusal(const std::string& text) {
  try {
    scene_of(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_FALSE(error.hint().empty());
    return error.what();
  }
  return "";
}

}  // namespace offing::scene::test
