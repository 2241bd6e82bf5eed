// Saving a scene into text that a person wrote.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "host/scene/model/scene.h"

namespace offing::scene {

/// The text of a scene file with the values of `scene` in it: comments, order and layout stay, and so does
/// the text of every value that is equal. A changed value is replaced; a new one follows the last value of
/// its section; a new section follows its like, or ends the file. An absent value and a removed element lose
/// their lines, the element also the comment above it.
///
/// File names in `text` are relative to `text_folder`; in the result to `folder`.
///
/// None if the text cannot be kept: the scene has changed in a table whose values stand outside of its
/// section, such as `wind.speed_mps = 10`, or the text is no scene. Throws as scene_text() does.
std::optional<std::string> edited_scene_text(std::string_view text, const std::filesystem::path& text_folder,
                                             const Scene& scene, const std::filesystem::path& folder);

}  // namespace offing::scene
