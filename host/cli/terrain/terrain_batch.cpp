#include "host/cli/terrain/terrain_batch.h"

#include <utility>

#include <CLI/Option.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"

namespace offing::cli {

namespace {

constexpr std::size_t block_rows = 65536;
constexpr const char* batch_group = "Many at once";

}  // namespace

std::string points_help(const NumberColumns& columns, std::string_view gis) {
  return fmt::format(
      "GeoPackage or GeoJSON with {}, or CSV with columns {}\nwith a header line: in any order, "
      "among others; without: exactly these, in this order.\nWith --crs lonlat the columns of a place are "
      "longitude_deg,latitude_deg, with other systems x,y",
      gis, fmt::join(columns.names, ","));
}

void add_layer_option(CLI::App& command, std::string& layer, const char* group) {
  command.add_option("--layer", layer, "layer of the GeoPackage or GeoJSON (default: the only one)")
      ->type_name("NAME")
      ->group(group)
      ->needs("--points");
}

void TerrainBatch::add_to(CLI::App& command, QuestionColumns columns, const std::string& single) {
  columns_ = std::move(columns);
  single_ = single;
  const bool has_points = columns_.places.size() == 1;
  CLI::Option* points =
      command
          .add_option(
              "--points", points_,
              points_help(columns_.numbers, has_points ? "points, and the other columns as attributes"
                                                       : "lines of two points, and heights as attributes"))
          ->type_name("FILE")
          ->group(batch_group)
          ->excludes(command.get_option(single))
          ->excludes(command.get_option("--json"));
  add_layer_option(command, layer_, batch_group);
  command
      .add_option(
          "-o,--output", output_,
          "CSV file or GeoPackage (.gpkg) to write, complete or not at all (- or default: standard output)")
      ->type_name("FILE")
      ->group(batch_group)
      ->needs(points);
  add_force_flag(command, existing_)->group(batch_group)->needs(points);
}

void TerrainBatch::require_question(const std::string& single, const TerrainInput& terrain) const {
  require_answer_name(output_);
  if (!is_standard_output(output_))
    require_new(output_, existing_, {{terrain.file(), points_}, terrain.trust()});
  if (is_asked() || !single.empty()) return;
  throw Error(ErrorKind::bad_usage, fmt::format("expected {} or --points, found neither", single_),
              fmt::format("give {} for one answer, or --points FILE for many", single_));
}

std::unique_ptr<QuestionFile> TerrainBatch::open(const MapFrame& map, const std::string& crs) const {
  return open_questions({points_, layer_}, map, crs, columns_);
}

void TerrainBatch::answer(QuestionFile& questions, const MapFrame& map,
                          const std::vector<AnswerColumn>& answers, const Answer& answer,
                          const GlobalOptions& options) const {
  const std::unique_ptr<AnswerFile> file = create_answers(output_, existing_, map, questions, answers);
  std::vector<AttributeValue> values;
  for (QuestionBlock block = questions.next(block_rows); block.count > 0;
       block = questions.next(block_rows)) {
    options.cancel.throw_if_cancelled();
    values.clear();
    answer(block, values);
    file->write(block, values);
  }
  file->commit();
}

}  // namespace offing::cli
