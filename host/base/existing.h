#pragma once

namespace offing {

/// What becomes of an existing file, or folder, of an output's name.
enum class Existing { keep, replace };

}  // namespace offing
