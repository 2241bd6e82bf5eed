#include <optional>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/base/process.h"
#include "host/base/work.h"
#include "present/output/headless.h"
#include "present/output/reference_comparison.h"
#include "present/view_options.h"
#include "present/window/viewer.h"

namespace {

int run(int argc, char** argv, const offing::CancelToken& cancel) {
  namespace present = offing::present;
  offing::configure_log(offing::Verbosity::normal);
  if (const std::optional<present::ViewOptions> options = present::read_view_options(argc, argv)) {
    if (!options->sources.empty()) present::use_sources(options->sources);
    if (options->comparison) {
      present::compare_with_reference(*options, cancel);
    } else if (options->opens_window) {
      present::show_window(*options, cancel);
    } else {
      present::make_images(*options, cancel);
    }
  }
  offing::finish_output();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return offing::run_program([&](const offing::CancelToken& cancel) { return run(argc, argv, cancel); });
}
