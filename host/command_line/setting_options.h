#pragma once

#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/command_line/option_rows.h"
#include "host/scene/schema/schema.h"

/// Options of commands that are rows of a schema, as the parameters of scenes are: unit, range and default
/// are written once, for the check, the help and the messages.
namespace offing {

/// What a row is, and on a line of its own "a number in m/s within [0.1, 60]; default 10".
std::string option_help(const scene::Parameter& row, std::string_view usual);

/// What stands for the value in a usage line. The help beside it gives unit and range.
const char* option_placeholder(const scene::Parameter& row);

/// The facts of a scene's row, for a flag that sets the same: its limits are written once.
scene::Parameter like_scene(std::string_view key, std::string_view flag);
/// The same with a help of its own.
scene::Parameter like_scene(std::string_view key, std::string_view flag, std::string_view help);
/// The same for a flag whose default is the scene's own value.
scene::Parameter over_scene(std::string_view key, std::string_view flag);

/// The facts of --time, which several commands take: any time for which waves can be computed.
scene::Parameter time_facts(std::string_view help, std::string_view absent = {});

/// The names of a scene's choice, for a flag that makes the same.
std::vector<std::string_view> names_in_scene(std::string_view key);

/// A narrower range than a row's, by other values or by what a file holds.
struct NarrowedRange {
  std::string_view flag;
  double low = std::numeric_limits<double>::lowest(), high = std::numeric_limits<double>::max();
};

/// Flags whose values lie in the struct of their settings, erased.
class SettingFlags {
 public:
  SettingFlags() = default;
  // CLI11 keeps references to the texts.
  SettingFlags(const SettingFlags&) = delete;
  SettingFlags& operator=(const SettingFlags&) = delete;

  bool is_given(std::string_view flag) const;
  bool are_given() const;

 protected:
  /// `usual` is the default that the help shows, unless the row has its own text for that (`absent`). It is
  /// also the example of a row without one.
  CLI::Option* add(CLI::App& command, const char* group, scene::Parameter row, std::string usual);
  void read_into(void* settings, const std::optional<NarrowedRange>& narrowed) const;

 private:
  struct Flag {
    scene::Parameter row;
    std::string flags, name, example, text;
    const CLI::Option* option = nullptr;
    std::optional<OptionRow> bound = std::nullopt;
  };

  std::deque<Flag> flags_;
};

/// Flags that fill a struct whose members hold the defaults.
template <class Settings>
class SettingOptions : public SettingFlags {
 public:
  /// Adds the flag of each row to `command`, which this object must outlive. The help lists it below `group`.
  /// The flag of the key step_m is --step-m, unless the row has another. `usual` holds the defaults that the
  /// help shows.
  void add_to(CLI::App& command, std::vector<scene::Row<Settings>> rows, const char* group = "Options",
              const Settings& usual = {}) {
    for (scene::Row<Settings>& row : rows) {
      scene::Parameter facts = std::move(row.facts);
      facts.storage = std::move(row.where.storage);
      std::string text = scene::text_in(&usual, facts, scene::Digits::readable);
      add(command, group, std::move(facts), std::move(text));
    }
  }

  /// The settings with the values of the flags that were given. The row's word for an absent value leaves a
  /// setting as it is. Throws Error(bad_input) that names the flag.
  Settings read(Settings settings = {}, const std::optional<NarrowedRange>& narrowed = {}) const {
    read_into(&settings, narrowed);
    return settings;
  }
};

}  // namespace offing
