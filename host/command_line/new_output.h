#pragma once

#include <string>

namespace offing {

enum class Overwriting { refused, allowed };

/// Throws Error(file) for an output that is there already, unless --force allows to replace it; an empty name
/// is no output.
void require_new(const std::string& output, Overwriting overwriting);

}  // namespace offing
