#pragma once

#include <spdlog/spdlog.h>

namespace offing {

/// How much programs print: quiet, errors only; verbose, details too.
enum class Verbosity { quiet, normal, verbose };

/// Sends log lines to stderr as "level: text" and sets how many of them: quiet = errors only. Results of
/// commands go to stdout and never through the log.
void configure_log(Verbosity verbosity);

}  // namespace offing
