#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/App.hpp>

#include "host/cli/common/global_options.h"
#include "host/cli/terrain/answer_file.h"
#include "host/cli/terrain/question_file.h"
#include "host/cli/terrain/terrain_input.h"
#include "host/command_line/new_output.h"

namespace offing::cli {

/// Adds --layer, which needs --points.
void add_layer_option(CLI::App& command, std::string& layer, const char* group);

/// How --points explains its files.
std::string points_help(const NumberColumns& columns, std::string_view gis);

/// The same question for each line or feature of a file: --points and -o of the commands that ask the ground.
class TerrainBatch {
 public:
  /// Appends the answers to a block [questions][answer columns].
  using Answer = std::function<void(const QuestionBlock& block, std::vector<AttributeValue>& values)>;

  /// `single` is the flag of a single question; the batch cannot be asked with it or with --json. `this` must
  /// outlive the command.
  void add_to(CLI::App& command, QuestionColumns columns, const std::string& single);

  bool is_asked() const { return !points_.empty(); }
  /// Throws Error(bad_usage) unless there is a batch or what the flag of a single question says, and what
  /// require_answer_name() and require_new() throw; `ground` is the file that is asked.
  void require_question(const std::string& single, const TerrainInput& terrain) const;

  /// The questions about a map; `crs` is what --crs says. Throws what open_questions() throws.
  std::unique_ptr<QuestionFile> open(const MapFrame& map, const std::string& crs) const;
  /// Answers block by block: writes the questions, then the answers, to the file of -o, whole or not at all,
  /// or to standard output. Throws what QuestionFile, AnswerFile and `answer` throw.
  void answer(QuestionFile& questions, const MapFrame& map, const std::vector<AnswerColumn>& answers,
              const Answer& answer, const GlobalOptions& options) const;

 private:
  QuestionColumns columns_;
  std::string single_, points_, layer_, output_;
  Existing existing_ = Existing::keep;
};

}  // namespace offing::cli
