#pragma once

#include <CLI/App.hpp>

#include "host/io/file_trust.h"

namespace offing {

/// Adds --untrusted to a command that reads files which lead to others. `trust` must outlive it.
void add_trust_flag(CLI::App& command, Trust& trust);

}  // namespace offing
