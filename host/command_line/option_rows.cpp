#include "host/command_line/option_rows.h"

#include <map>

namespace offing {
namespace {

// Programs make one command line, on one thread.
std::map<const CLI::Option*, const scene::Parameter*>& rows() {
  static std::map<const CLI::Option*, const scene::Parameter*> all;
  return all;
}

}  // namespace

OptionRow::OptionRow(const CLI::Option& option, const scene::Parameter& row) : option_(&option) {
  rows().emplace(option_, &row);
}

OptionRow::~OptionRow() {
  rows().erase(option_);
}

const scene::Parameter* row_of(const CLI::Option& option) {
  const auto found = rows().find(&option);
  return found == rows().end() ? nullptr : found->second;
}

}  // namespace offing
