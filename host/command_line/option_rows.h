// Which row of a schema each option of a command line has. A test lists all options and finds those without
// a row.
#pragma once

#include "host/scene/schema/parameter.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's, whose header takes long to compile
class App;
class Option;
}  // namespace CLI

namespace offing {

/// Records the row of an option during its lifetime. Both must outlive it.
class OptionRow {
 public:
  OptionRow(const CLI::Option& option, const scene::Parameter& row);
  ~OptionRow();
  OptionRow(const OptionRow&) = delete;
  OptionRow& operator=(const OptionRow&) = delete;

 private:
  const CLI::Option* option_;
};

/// The row of an option; nullptr if it has none.
const scene::Parameter* row_of(const CLI::Option& option);

}  // namespace offing
