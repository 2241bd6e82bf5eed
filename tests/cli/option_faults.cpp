#include "tests/cli/option_faults.h"

#include <utility>

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/command_line/option_rows.h"
#include "host/scene/schema/checked_value.h"
#include "host/scene/schema/parameter_table.h"

namespace offing::test {
namespace {

/// Texts that hold several numbers, or one that no range fits, in any command.
const std::set<std::string_view> compound_texts{"at",   "camera", "chunk",  "direction", "frames",
                                                "from", "lake",   "nodata", "observer",  "raw-size",
                                                "size", "sun",    "times",  "to"};

bool has_equal_limits(const scene::Parameter& a, const scene::Parameter& b) {
  return a.unit == b.unit && a.low == b.low && a.high == b.high && a.scale == b.scale && a.rule == b.rule;
}

class Walk {
 public:
  explicit Walk(const std::set<std::string_view>& texts) : texts_(texts) {}

  void visit(const CLI::App& command, const std::string& path) {
    for (const CLI::Option* option : command.get_options()) {
      if (option->get_items_expected_max() == 0) continue;  // a flag, which takes no value
      const std::string name = option->get_single_name(), where = fmt::format("{} {}", path, name);
      if (const scene::Parameter* row = row_of(*option)) {
        check_row(*option, *row, where);
      } else if (!texts_.contains(name) && !compound_texts.contains(name)) {
        fault(where, "expected a row, found an option written by hand");
      }
    }
    for (const CLI::App* inner : command.get_subcommands({})) {
      visit(*inner, path + ' ' + inner->get_name());
    }
  }

  OptionReport take() { return std::move(report_); }

 private:
  void fault(const std::string& where, const std::string& what) {
    report_.faults.push_back(fmt::format("{}: {}", where, what));
  }

  void check_row(const CLI::Option& option, const scene::Parameter& row, const std::string& where) {
    const std::string expected = scene::expected_text(row), &help = option.get_description();
    const std::size_t at = help.rfind(expected + "; default ");
    if (at == std::string::npos || help.ends_with("; default ")) {
      fault(where, fmt::format("expected a help of range and default, found {}", help));
    }
    if (const scene::Parameter* of_scene = scene::find_parameter(row.key)) {
      if (!has_equal_limits(row, *of_scene)) fault(where, fmt::format("expected the limits of {}", row.key));
    }
    if (scene::is_text(row)) return;
    if (!(row.low < row.high)) fault(where, "expected a range");
    report_.numbers.push_back(fmt::format("{}: {}", where, at == std::string::npos ? help : help.substr(at)));
    for (const scene::Parameter& other : scene::parameter_table()) {
      if (other.flag == "--" + option.get_single_name() && !has_equal_limits(row, other)) {
        fault(where, fmt::format("expected the limits of {}, which has this flag", other.key));
      }
    }
  }

  const std::set<std::string_view>& texts_;
  OptionReport report_;
};

}  // namespace

OptionReport report_options(const CLI::App& program, const std::set<std::string_view>& texts) {
  Walk walk(texts);
  walk.visit(program, program.get_name());
  return walk.take();
}

}  // namespace offing::test
