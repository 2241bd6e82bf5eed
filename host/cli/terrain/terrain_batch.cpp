#include "host/cli/terrain/terrain_batch.h"

#include <optional>
#include <utility>

#include <CLI/Option.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/io/atomic_file.h"

namespace offing::cli {

namespace {

constexpr std::size_t block_rows = 65536;
constexpr const char* batch_group = "Many at once";

}  // namespace

void TerrainBatch::add_to(CLI::App& command, NumberColumns columns, const std::string& single) {
  columns_ = std::move(columns);
  single_ = single;
  CLI::Option* points =
      command
          .add_option(
              "--points", points_,
              fmt::format(
                  "CSV file with columns {}\nwith a header line: in any order, among others; without: "
                  "exactly these, in this order",
                  fmt::join(columns_.names, ",")))
          ->type_name("FILE")
          ->group(batch_group)
          ->excludes(command.get_option(single))
          ->excludes(command.get_option("--json"));
  command
      .add_option("-o,--output", output_,
                  "CSV file to write, complete or not at all (- or default: standard output)")
      ->type_name("FILE")
      ->group(batch_group)
      ->needs(points);
  add_force_flag(command, existing_)->group(batch_group)->needs(points);
}

void TerrainBatch::require_question(const std::string& single, const TerrainInput& terrain) const {
  if (!is_standard_output(output_))
    require_new(output_, existing_, {{terrain.file(), points_}, terrain.trust()});
  if (is_asked() || !single.empty()) return;
  throw Error(ErrorKind::bad_usage, fmt::format("expected {} or --points, found neither", single_),
              fmt::format("give {} for one answer, or --points FILE for many", single_));
}

void TerrainBatch::answer(std::string_view heading, const Answer& answer,
                          const GlobalOptions& options) const {
  NumberTable table(points_, columns_);
  std::optional<AtomicFile> file;
  if (!output_.empty() && !is_standard_output(output_)) file.emplace(output_, existing_);
  std::string text = fmt::format("{}\n", heading);
  for (auto rows = table.next(block_rows); !rows.empty(); rows = table.next(block_rows)) {
    options.cancel.throw_if_cancelled();
    answer(rows, table, text);
    if (file) {
      file->write(text);
    } else {
      fmt::print("{}", text);
    }
    text.clear();
  }
  if (file) file->commit();
}

}  // namespace offing::cli
