#pragma once

#include <span>
#include <string_view>

#include "present/gl/embedded_file.h"

namespace offing::present {

/// The scenes that come with Offing and name no other files.
std::span<const EmbeddedFile> scene_sources();

/// Throws Error(bad_input) for a name that none of them has.
const EmbeddedFile& shipped_source(std::string_view name);

/// The one that is shown where none is asked for.
inline constexpr std::string_view first_scene = "world.toml";

}  // namespace offing::present
