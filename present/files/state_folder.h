#pragma once

#include <filesystem>

namespace offing::present {

/// Where the window keeps what it remembers from one start to the next: $XDG_STATE_HOME/offing, else
/// ~/.local/state/offing. Empty: nowhere, as neither is known.
std::filesystem::path state_folder();
/// A file there; empty if there is none.
std::filesystem::path state_file(const char* name);

}  // namespace offing::present
