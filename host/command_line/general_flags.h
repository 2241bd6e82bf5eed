#pragma once

#include <string>
#include <string_view>

#include <CLI/App.hpp>

#include "host/base/log.h"
#include "host/io/file_trust.h"

/// Flags that most commands of all programs have.
namespace offing {

/// Where the help lists what every command understands.
inline constexpr const char* general_group = "General";

/// Adds --device to a command. `device` must outlive it. `also` is the help for what the flag takes besides
/// one device.
void add_device_flag(CLI::App& command, std::string& device, std::string_view also = {});

/// Adds --quiet and --verbose to a command, and has the log follow them. `verbosity` must outlive it.
void add_verbosity_flags(CLI::App& command, Verbosity& verbosity);

/// Adds --untrusted to a command that reads files which lead to others. `trust` must outlive it.
void add_trust_flag(CLI::App& command, Trust& trust);

}  // namespace offing
