// Answers to files of questions, as CSV and as GeoPackage.
#include "host/cli/terrain/answer_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/command_line/new_output.h"

namespace offing::cli {
namespace {

constexpr int local_digits = 12, placed_digits = 14;

std::string lower(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

/// The carried columns under names that none of `taken` has, in any case of letters: so SQLite compares
/// names.
std::vector<AttributeColumn> renamed(std::vector<AttributeColumn> carried, std::set<std::string> taken) {
  for (AttributeColumn& column : carried) {
    while (!taken.insert(lower(column.name)).second) column.name = "given_" + column.name;
  }
  return carried;
}

std::set<std::string> names_in_use(const QuestionFile& questions, const std::vector<AnswerColumn>& answers) {
  std::set<std::string> names;
  for (const std::string& name : questions.names()) names.insert(lower(name));
  for (const AnswerColumn& column : answers) names.insert(lower(column.name));
  return names;
}

/// A text as a field of CSV (RFC 4180).
std::string field_of(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char letter : text) field += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return field + "\"";
}

void append_text(const AttributeValue& value, int digits, std::string& text) {
  const auto out = std::back_inserter(text);
  if (const auto* number = std::get_if<double>(&value)) {
    if (digits > 0) {
      fmt::format_to(out, "{:.{}g}", *number, digits);
    } else {
      fmt::format_to(out, "{}", *number);
    }
  } else if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    fmt::format_to(out, "{}", *whole);
  } else if (const auto* word = std::get_if<std::string>(&value)) {
    text += field_of(*word);
  }
}

class CsvAnswers : public AnswerFile {
 public:
  CsvAnswers(const std::string& output, Existing existing, const QuestionFile& questions,
             const std::vector<AnswerColumn>& answers)
      : questions_(questions), answers_(answers) {
    if (!output.empty() && !is_standard_output(output)) file_.emplace(output, existing);
    for (const std::string& name : questions.names()) text_ += (text_.empty() ? "" : ",") + name;
    for (const AttributeColumn& column : renamed(questions.carried(), names_in_use(questions, answers)))
      text_ += "," + field_of(column.name);
    for (const AnswerColumn& column : answers) text_ += "," + column.name;
    text_ += '\n';
  }

  void write(const QuestionBlock& block, const std::vector<AttributeValue>& values) override {
    const std::size_t width = questions_.names().size(), carried = questions_.carried().size();
    const int digits = questions_.system().is_local() ? local_digits : placed_digits;
    for (std::size_t row = 0; row < block.count; ++row) {
      for (std::size_t i = 0; i < width; ++i) {
        fmt::format_to(std::back_inserter(text_), "{}{:.{}g}", i == 0 ? "" : ",",
                       block.given[row * width + i], digits);
      }
      for (std::size_t i = 0; i < carried; ++i) {
        text_ += ',';
        append_text(block.carried[row * carried + i], 0, text_);
      }
      for (std::size_t i = 0; i < answers_.size(); ++i) {
        text_ += ',';
        append_text(values[row * answers_.size() + i], answers_[i].digits, text_);
      }
      text_ += '\n';
    }
    flush();
  }

  void commit() override {
    flush();
    if (file_) file_->commit();
  }

 private:
  void flush() {
    if (file_) {
      file_->write(text_);
    } else {
      fmt::print("{}", text_);
    }
    text_.clear();
  }

  const QuestionFile& questions_;
  std::vector<AnswerColumn> answers_;
  std::optional<AtomicFile> file_;
  std::string text_;
};

class PackageAnswers : public AnswerFile {
 public:
  PackageAnswers(const std::string& output, Existing existing, const MapFrame& map,
                 const QuestionFile& questions, const std::vector<AnswerColumn>& answers)
      : questions_(questions) {
    if (map.georeference.step_x == 0.0) {
      throw Error(
          ErrorKind::bad_input,
          fmt::format("{}: expected a map with a place in the world for a GeoPackage, found none in {}",
                      one_line(output), one_line(map.file)),
          "write CSV, or place the map with gdal_edit.py -a_ullr");
    }
    if (questions.system().is_local()) in_map_.emplace(map, map_places);
    const PlaceSystem& system = in_map_ ? *in_map_ : questions.system();
    if (system.coordinate_system().empty()) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: expected a map with a coordinate system for a GeoPackage, found none",
                              one_line(map.file)),
                  "write CSV, or give the map a system with gdal_edit.py -a_srs EPSG:CODE");
    }
    NewFeatures features{.shape = questions.shape(),
                         .layer = std::filesystem::path(output).stem().string(),
                         .coordinate_system = system.coordinate_system(),
                         .columns = {}};
    std::set<std::string> taken = names_in_use(questions, answers);
    taken.insert({"fid", "geom"});
    for (std::size_t i = 0; i < questions.names().size(); ++i) {
      if (!questions.is_coordinate(i))
        features.columns.push_back({questions.names()[i], AttributeKind::number});
    }
    for (const AttributeColumn& column : renamed(questions.carried(), taken))
      features.columns.push_back(column);
    for (const AnswerColumn& column : answers) features.columns.push_back({column.name, column.kind});
    answers_ = answers.size();
    writer_ = create_features(output, features, existing);
  }

  void write(const QuestionBlock& block, const std::vector<AttributeValue>& values) override {
    const std::size_t width = questions_.names().size(), carried = questions_.carried().size();
    const std::size_t ends = ends_of(questions_.shape());
    std::vector<glm::dvec3> places = block.ends;
    if (in_map_) {
      std::vector<glm::dvec2> local_m;
      for (const glm::dvec3& end : block.ends) local_m.emplace_back(end.x, end.y);
      const std::vector<glm::dvec2> in_map = in_map_->of_map(local_m);
      for (std::size_t i = 0; i < places.size(); ++i) places[i] = {in_map[i], 0.0};
    }
    for (std::size_t row = 0; row < block.count; ++row) {
      std::vector<AttributeValue> attributes;
      for (std::size_t i = 0; i < width; ++i) {
        if (!questions_.is_coordinate(i)) attributes.emplace_back(block.given[row * width + i]);
      }
      for (std::size_t i = 0; i < carried; ++i) attributes.push_back(block.carried[row * carried + i]);
      for (std::size_t i = 0; i < answers_; ++i) attributes.push_back(values[row * answers_ + i]);
      writer_->add(std::span(places).subspan(row * ends, ends), attributes);
    }
  }

  void commit() override { writer_->commit(); }

 private:
  const QuestionFile& questions_;
  std::optional<PlaceSystem> in_map_;  // of local questions
  std::size_t answers_ = 0;
  std::unique_ptr<FeatureWriter> writer_;
};

}  // namespace

std::unique_ptr<AnswerFile> create_answers(const std::string& output, Existing existing, const MapFrame& map,
                                           const QuestionFile& questions,
                                           const std::vector<AnswerColumn>& answers) {
  if (lower_extension(output) == ".gpkg")
    return std::make_unique<PackageAnswers>(output, existing, map, questions, answers);
  return std::make_unique<CsvAnswers>(output, existing, questions, answers);
}

}  // namespace offing::cli
