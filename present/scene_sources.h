#pragma once

#include <span>

#include "present/embedded_file.h"

namespace offing::present {

/// The one scene that is shown where none is asked for; it names no other files.
std::span<const EmbeddedFile> scene_sources();

}  // namespace offing::present
