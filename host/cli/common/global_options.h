#pragma once

#include <string>

#include <CLI/App.hpp>

#include "host/base/log.h"
#include "host/base/work.h"

namespace offing::cli {

/// What every command understands.
struct GlobalOptions {
  std::string device;  ///< selector of ocl::select_device; empty: the default device
  Verbosity verbosity = Verbosity::normal;
  const CancelToken& cancel;  ///< set by Ctrl-C
};

enum class DeviceUse { none, one, any_number };

/// Adds --device (where a command uses one), --quiet and --verbose to a command. `options` must outlive it.
void add_global_options(CLI::App& command, GlobalOptions& options, DeviceUse device_use);

}  // namespace offing::cli
