#include "mesh_tools/commands/fineness_flags.h"

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::mesh_tools {

void FinenessFlags::add_to(CLI::App& command, std::string_view edge_help, std::string_view faces_help) {
  options_.add_to(command, {{&Fineness::edge_m,
                             {.key = "edge_m",
                              .unit = "m",
                              .low = 1e-9,
                              .high = 1e9,
                              .help = edge_help,
                              .example = "0.05",
                              .absent = "none"}},
                            {&Fineness::faces,
                             {.key = "faces",
                              .low = 4.0,
                              .high = most_faces,
                              .help = faces_help,
                              .example = "5000",
                              .absent = "none"}}});
  command.get_option("--faces")->excludes(command.get_option("--edge-m"));
}

Fineness FinenessFlags::read(std::string_view command) const {
  const Fineness fineness = options_.read();
  if (fineness.edge_m || fineness.faces > 0) return fineness;
  throw Error(ErrorKind::bad_usage,
              fmt::format("offing-mesh {}: expected --edge-m or --faces, got neither", command),
              "give one of them, such as --faces 5000");
}

}  // namespace offing::mesh_tools
