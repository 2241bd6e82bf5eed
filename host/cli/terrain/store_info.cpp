#include "host/cli/terrain/store_info.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/command_line/print_results.h"
#include "host/io/tile_store/tile_store.h"

namespace offing::cli {

void print_store_info(const std::string& folder, InfoStyle style) {
  const TileStoreHeader header = TileStore(folder).header();
  const TileSetShape& shape = header.shape;
  const double width_m = header.spacing_x_m * (shape.columns - 1),
               depth_m = header.spacing_z_m * (shape.rows - 1);
  if (style == InfoStyle::json) {
    nlohmann::ordered_json json = {{"file", folder},
                                   {"format", "tile store"},
                                   {"columns", shape.columns},
                                   {"rows", shape.rows},
                                   {"spacing_x_m", header.spacing_x_m},
                                   {"spacing_z_m", header.spacing_z_m},
                                   {"extent_x_m", width_m},
                                   {"extent_z_m", depth_m},
                                   {"lowest_m", header.lowest_m},
                                   {"highest_m", header.highest_m},
                                   {"void_posts", header.void_posts},
                                   {"levels", shape.levels},
                                   {"tiles", shape.tile_count()},
                                   {"heights_checksum", fmt::format("{:016x}", header.heights_checksum)}};
    const auto or_null = [](const std::optional<double>& value) {
      return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
    };
    json["centre_latitude_deg"] = or_null(header.centre_latitude_deg);
    json["centre_longitude_deg"] = or_null(header.centre_longitude_deg);
    print_json(json);
    return;
  }
  fmt::print("{}: tile store, {} tiles of {} levels\n", one_line(folder), shape.tile_count(), shape.levels);
  fmt::print("  posts      {} x {}\n", shape.columns, shape.rows);
  fmt::print("  spacing    {:.6g} m along x, {:.6g} m along z\n", header.spacing_x_m, header.spacing_z_m);
  fmt::print("  extent     {:.6g} m x {:.6g} m\n", width_m, depth_m);
  fmt::print("  heights    {:g} ... {:g} m\n", header.lowest_m, header.highest_m);
  fmt::print("  voids      {}\n",
             header.void_posts == 0 ? "none" : fmt::format("{} posts, filled", header.void_posts));
  if (header.centre_latitude_deg && header.centre_longitude_deg) {
    fmt::print("  centre     {:.6f} N, {:.6f} E\n", *header.centre_latitude_deg,
               *header.centre_longitude_deg);
  }
}

}  // namespace offing::cli
