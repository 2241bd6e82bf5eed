#pragma once

#include <string>
#include <string_view>

#include "host/base/error.h"

namespace offing {

/// Prints an error to stderr as its two lines, `error: ...` and `hint: ...`; of an ErrorList all errors.
void report(const Error& error);

/// One printable line: control characters, as hostile file names hold them, become \xNN.
std::string one_line(std::string_view text);

/// Words of a file fit for one line of an error message: control and non-ASCII bytes as \xNN, cut after 60
/// characters.
std::string printable(std::string_view text);

}  // namespace offing
