#pragma once

#include <initializer_list>
#include <string>

namespace offing {

enum class Overwriting { refused, allowed };

/// Throws Error(file), before any work is done, for an output that could not be written after it: one that is
/// there already, unless --force allows to replace it; one that is among the inputs, even with --force; one
/// in a folder that takes no files. An empty name is no output.
void require_new(const std::string& output, Overwriting overwriting,
                 std::initializer_list<std::string> inputs = {});

}  // namespace offing
