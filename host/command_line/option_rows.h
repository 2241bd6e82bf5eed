// Which row an option of a command line has: a test lists all options and finds those that were written
// without one.
#pragma once

#include "host/scene/schema/parameter.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's, whose header takes long to compile
class App;
class Option;
}  // namespace CLI

namespace offing {

/// Binds a row to an option for as long as it lives; both must outlive it.
class OptionRow {
 public:
  OptionRow(const CLI::Option& option, const scene::Parameter& row);
  ~OptionRow();
  OptionRow(const OptionRow&) = delete;
  OptionRow& operator=(const OptionRow&) = delete;

 private:
  const CLI::Option* option_;
};

/// nullptr for an option without one.
const scene::Parameter* row_of(const CLI::Option& option);

}  // namespace offing
