#include "host/scene/file/scene_check.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/meshes/mesh_sequence.h"
#include "host/scene/file/scene_reader.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/prepare/scene_wakes.h"
#include "host/scene/prepare/sea.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "host/scene/schema/unused_parameters.h"

namespace offing::scene {

namespace {

/// Takes "14:" from the start of a text; 0, and nothing taken, where it has none.
std::size_t take_number(std::string_view& text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto length = static_cast<std::size_t>(end - text.data());
  if (error != std::errc{} || length == text.size() || text[length] != ':') return 0;
  text.remove_prefix(length + 1);
  return number;
}

bool is_key(std::string_view text) {
  const auto belongs = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '_' || c == '-';
  };
  return !text.empty() && std::ranges::all_of(text, belongs);
}

/// The parts of "storm.toml:14:13: ocean.fetch_m: expected ..., got ...".
SceneMessage message_of(const std::string& file, const std::string& text, std::string hint = {}) {
  SceneMessage message{
      .text = text, .line = 0, .column = 0, .key = {}, .message = {}, .hint = std::move(hint)};
  std::string_view rest = text;
  if (rest.starts_with(file + ':')) {
    rest.remove_prefix(file.size() + 1);
    message.line = take_number(rest);
    message.column = take_number(rest);
    if (rest.starts_with(' ')) rest.remove_prefix(1);
  }
  if (const std::size_t end = rest.find(": "); end != std::string_view::npos && is_key(rest.substr(0, end))) {
    message.key = rest.substr(0, end);
    rest.remove_prefix(end + 2);
  }
  message.message = rest;
  return message;
}

class SceneChecker {
 public:
  SceneChecker(const std::filesystem::path& file, Trust trust) : file_(file), name_(one_line(file.string())) {
    attempt([&] { check(read_scene(read_scene_text(file_), name_, file_.parent_path(), trust)); });
    for (std::vector<SceneMessage>* messages : {&report_.errors, &report_.warnings}) {
      std::ranges::stable_sort(*messages, {},
                               [](const SceneMessage& each) { return std::pair(each.line, each.column); });
    }
  }

  SceneReport report() && { return std::move(report_); }

 private:
  template <class Check>
  void attempt(Check check) {
    try {
      check();
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::bad_input) throw;
      add(error);
    }
  }

  void add(const Error& error) { report_.errors.push_back(message_of(name_, error.what(), error.hint())); }

  void warn(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) report_.warnings.push_back(message_of(name_, line));
  }

  void check(const SceneReading& reading) {
    for (const Error& error : reading.errors) add(error);
    warn(reading.warnings);
    const Scene& scene = reading.scene;
    if (report_.errors.empty()) find_files(scene);
    if (!report_.errors.empty()) return;
    attempt([&] { check_sea(scene); });
    attempt([&] { mesh_rules_at(scene, scene.time.start_s); });
  }

  void find_files(const Scene& scene) {
    for (const Parameter& row : parameter_table()) {
      if (row.rule != ParameterRule::file_name) continue;
      for (const ElementIndex element : elements_of(scene, *row.section)) {
        const auto place = scene.set_at.find({row.key, element});
        if (place == scene.set_at.end()) continue;
        const std::string& named =
            std::get<ValueAt<std::string>>(row.storage).in(struct_at(&scene, *row.section, element));
        std::error_code error;
        if (named.empty() || std::filesystem::exists(named, error)) continue;
        if (!files_of_mesh_sequence(named).empty()) continue;
        add(Error(ErrorKind::bad_input,
                  fmt::format("{}: expected a file, found none: {}", place->second, printable(named)),
                  "check the name: it is relative to the folder of the scene"));
      }
    }
  }

  void check_sea(const Scene& scene) {
    if (!scene.has_sea()) {
      warn(unused_parameters(scene));
      return;
    }
    const Sea sea = prepare_sea(scene, Warnings::left_out);
    warn(unused_parameters(scene, sea));
    for (const std::string& line :
         {steepness_warning(scene, sea.parameters.gerstner_waves), height_warning(scene, sea)}) {
      if (!line.empty()) warn({name_ + ": " + line});
    }
    prepare_wakes(scene, sea.spectrum.dispersion);
  }

  const std::filesystem::path& file_;
  std::string name_;
  SceneReport report_;
};

}  // namespace

SceneReport check_scene(const std::filesystem::path& file, Trust trust) {
  return SceneChecker(file, trust).report();
}

}  // namespace offing::scene
