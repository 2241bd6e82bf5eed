// `offing scene new`: a scene to start from.
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/cli/scene/scene_commands.h"
#include "host/cli/scene/starter_scene.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/scene/file/scene_writer.h"

namespace offing::cli {

namespace {

struct NewArguments {
  std::string file = "-";
  Existing existing = Existing::keep;
};

void run(const NewArguments& arguments) {
  if (is_standard_output(arguments.file)) {
    fmt::print("{}", starter_scene("scene.toml"));
    return;
  }
  const std::filesystem::path file = arguments.file;
  require_new(arguments.file, arguments.existing);
  scene::save_scene_text(starter_scene(one_line(file.filename().string())), file, arguments.existing);
  print_summary("{}: a sea to start from\n", one_line(arguments.file));
}

}  // namespace

void add_new_command(CLI::App& scene, GlobalOptions& options) {
  const auto arguments = std::make_shared<NewArguments>();
  CLI::App* command = scene.add_subcommand("new", "write a commented scene to start from");
  command->add_option("FILE", arguments->file, "scene file to write (.toml); - or default: standard output")
      ->type_name("");
  add_force_flag(*command, arguments->existing);
  add_global_options(*command, options, DeviceUse::none);
  command->footer(R"(
Example:
  offing scene new harbour.toml)");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace offing::cli
