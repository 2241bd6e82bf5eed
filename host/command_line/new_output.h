#pragma once

#include <initializer_list>
#include <span>
#include <string>

namespace offing {

enum class Overwriting { refused, allowed };

/// Throws Error(file) for an output that is one of the inputs, by whatever name.
void require_not_read(const std::string& output, std::span<const std::string> inputs);

/// Throws Error(file), before any work is done, for an output that could not be written after it: one that is
/// there already, unless --force allows to replace it; one that is among the inputs, even with --force; one
/// in a folder that takes no files. An empty name is no output.
void require_new(const std::string& output, Overwriting overwriting,
                 std::initializer_list<std::string> inputs = {});
void require_new(const std::string& output, Overwriting overwriting, std::span<const std::string> inputs);

}  // namespace offing
