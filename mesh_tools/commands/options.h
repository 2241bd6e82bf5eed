#pragma once

#include "host/base/cancel_token.h"
#include "host/base/log.h"

namespace offing::mesh_tools {

/// What every command understands.
struct Options {
  Verbosity verbosity = Verbosity::normal;
  const CancelToken& cancel;  ///< set by Ctrl-C
};

}  // namespace offing::mesh_tools
