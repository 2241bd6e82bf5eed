#pragma once

#include "host/base/log.h"
#include "host/base/work.h"

namespace offing::mesh_tools {

/// What every command understands.
struct Options {
  Verbosity verbosity = Verbosity::normal;
  const CancelToken& cancel;  ///< set by Ctrl-C
};

}  // namespace offing::mesh_tools
