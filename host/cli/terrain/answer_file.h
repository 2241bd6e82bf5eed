#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/cli/terrain/question_file.h"
#include "host/io/atomic_file.h"
#include "host/io/file_extension.h"

namespace offing::cli {

/// A column of answers. `digits` of its numbers are written as text, 0: as many as they need.
struct AnswerColumn {
  std::string name;
  int digits = 0;
  AttributeKind kind = AttributeKind::number;
};

/// Answers beside their questions: the questions' columns, then what is carried through, then the answers. A
/// carried column that has the name of another one becomes given_NAME.
class AnswerFile {
 public:
  AnswerFile() = default;
  AnswerFile(const AnswerFile&) = delete;
  AnswerFile& operator=(const AnswerFile&) = delete;
  virtual ~AnswerFile() = default;

  /// `values` are [questions][answer columns].
  virtual void write(const QuestionBlock& block, const std::vector<AttributeValue>& values) = 0;
  /// Publishes the file, whole or not at all.
  virtual void commit() = 0;
};

/// Throws Error(bad_usage) for the name of a GIS format that create_answers() does not write.
inline void require_answer_name(const std::string& output) {
  refuse_vector_name(output, {".gpkg", ".csv"});
}

/// A GeoPackage for a name that ends in .gpkg, otherwise CSV; standard output for an empty name and "-". A
/// GeoPackage has places in the questions' system, or those of local questions in the map's. Throws
/// Error(bad_input) where the map has none.
std::unique_ptr<AnswerFile> create_answers(const std::string& output, Existing existing, const MapFrame& map,
                                           const QuestionFile& questions,
                                           const std::vector<AnswerColumn>& answers);

}  // namespace offing::cli
