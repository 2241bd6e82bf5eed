#pragma once

#include "host/cli/common/global_options.h"

namespace offing::cli {

/// `offing ocean query [SCENE] --at X,Z --time T | --points FILE --times A:B:DT [-o FILE]`.
void add_query_command(CLI::App& ocean, GlobalOptions& options);

}  // namespace offing::cli
