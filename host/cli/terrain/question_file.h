#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "host/cli/terrain/place_system.h"
#include "host/io/height_maps/map_features.h"
#include "host/io/number_table.h"

namespace offing::cli {

/// A place among the columns of a question: those of its x and z.
struct PlaceColumns {
  std::string prefix;  ///< of the names of its columns, such as "from_"
  std::size_t x, z;
  bool is_on_map = true;  ///< must be; otherwise it may lie beyond
};

/// The columns of a question with local places.
struct QuestionColumns {
  NumberColumns numbers;
  std::vector<PlaceColumns> places;  ///< one or two
};

/// Some questions of a file.
struct QuestionBlock {
  std::size_t count = 0;
  std::vector<double> rows;             ///< [questions][columns], places as x and z in m on the map
  std::vector<double> given;            ///< [questions][columns], as the file has them and in its order
  std::vector<glm::dvec3> ends;         ///< [questions][places], as the file has them
  std::vector<double> optional;         ///< [questions][optional columns], NaN where there is none
  std::vector<AttributeValue> carried;  ///< [questions][carried columns]
  PlaceSystem::NameOfPlace place_of;
};

/// A file of questions: a table of text, or the points (or lines between two places) of a GIS file, whose
/// attributes are the other columns.
class QuestionFile {
 public:
  QuestionFile(const QuestionFile&) = delete;
  QuestionFile& operator=(const QuestionFile&) = delete;
  virtual ~QuestionFile() = default;

  /// The system of its places: that of --crs, or the layer's own.
  const PlaceSystem& system() const { return system_; }
  /// Names of the columns as the file has them.
  const std::vector<std::string>& names() const { return names_; }
  /// Which of them are coordinates.
  bool is_coordinate(std::size_t column) const { return is_coordinate_[column]; }
  FeatureShape shape() const;
  /// Attributes that are no part of the question.
  const std::vector<AttributeColumn>& carried() const { return carried_; }

  /// The next questions; none at the end. Throws Error(bad_input) that names the line or the feature.
  QuestionBlock next(std::size_t most);

 protected:
  QuestionFile(PlaceSystem system, QuestionColumns columns);
  const std::vector<std::string>& optional() const { return columns_.numbers.optional; }
  /// Columns as a table of this system has them.
  NumberColumns table_columns() const;

  std::vector<AttributeColumn> carried_;

 private:
  /// Fills in count, given, optional, carried and place_of.
  virtual void read(std::size_t most, QuestionBlock& block) = 0;

  PlaceSystem system_;
  QuestionColumns columns_;
  std::vector<std::string> names_;
  std::vector<std::size_t> of_local_;  // the local column that each is
  std::vector<bool> is_coordinate_;
};

/// Where questions lie.
struct QuestionSource {
  std::string file;
  std::string layer;  ///< of a GIS file; empty: the only one
};

/// `crs` is what --crs says. Throws what the readers throw, and Error(bad_usage) where both --crs and the
/// layer name a system, or --layer a part of a table.
std::unique_ptr<QuestionFile> open_questions(const QuestionSource& source, const MapFrame& map,
                                             const std::string& crs, const QuestionColumns& columns);

}  // namespace offing::cli
