#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "host/cli/common/global_options.h"
#include "host/cli/terrain/terrain_input.h"
#include "host/command_line/new_output.h"
#include "host/io/number_table.h"

namespace offing::cli {

/// The same question for each line of a file: --points and -o of the commands that ask the ground.
class TerrainBatch {
 public:
  /// Appends the answers to rows [rows][columns] of the table, a line each.
  using Answer =
      std::function<void(const std::vector<double>& rows, const NumberTable& table, std::string& text)>;

  /// `single` is the flag of a single question; the batch cannot be asked with it or with --json. `this` must
  /// outlive the command.
  void add_to(CLI::App& command, NumberColumns columns, const std::string& single);

  bool is_asked() const { return !points_.empty(); }
  /// Throws Error(bad_usage) unless there is a batch or what the flag of a single question says, and what
  /// require_new() throws; `ground` is the file that is asked.
  void require_question(const std::string& single, const TerrainInput& terrain) const;

  /// Answers block by block, under a heading, to the file of -o, whole or not at all, or to standard output.
  /// Throws what NumberTable, AtomicFile and `answer` throw.
  void answer(std::string_view heading, const Answer& answer, const GlobalOptions& options) const;

 private:
  NumberColumns columns_;
  std::string single_, points_, output_;
  Existing existing_ = Existing::keep;
};

}  // namespace offing::cli
