#include "host/io/modes/mode_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/io/file_extension.h"
#include "host/io/file_mark.h"
#include "host/io/module.h"
#include "host/io/spectra/netcdf_module.h"
#include "host/io/spectra/text_cursor.h"
#include "host/io/whole_file.h"

namespace offing {
namespace {

using spectra::NetcdfLayout;
using spectra::TextCursor;

/// A column of the table and what a NetCDF file says of it.
struct Column {
  const char* name;
  double SeaMode::*value;  ///< none: the patch
  int digits;
  const char* unit;
  const char* meaning;
};
constexpr std::array<Column, 6> column_table{
    {{"amplitude_m", &SeaMode::amplitude_m, 9, "m", "amplitude A"},
     {"kx_radpm", &SeaMode::kx_radpm, 12, "rad m-1", "wavenumber along x, east"},
     {"kz_radpm", &SeaMode::kz_radpm, 12, "rad m-1", "wavenumber along z, south"},
     {"omega_radps", &SeaMode::omega_radps, 12, "rad s-1", "angular frequency"},
     {"phase_rad", &SeaMode::phase_rad, 9, "rad", "phase at the origin and time 0"},
     {"patch", nullptr, 0, "1", "index of the patch whose lattice the wave is on, -1 for none"}}};
constexpr std::size_t required_columns = 5;

enum Fact : std::size_t { patch_length, patch_size, split, choppy, depth, loop };
struct FactFacts {
  const char* name;
  const char* unit;
  const char* meaning;
};
constexpr std::array<FactFacts, 6> fact_table{
    {{"patch_length_m", "m", "side of each square patch"},
     {"size", "1", "modes of a patch are at multiples of 2 pi / side up to size / 2 - 1"},
     {"split_radpm", "rad m-1", "least wavenumber on a patch"},
     {"choppiness", "1", "factor on horizontal displacement"},
     {"depth_m", "m", "depth of the water"},
     {"loop_period_s", "s", "all repeats after this time"}}};

constexpr const char* formula =
    "height = sum of amplitude_m cos p, p = kx_radpm x + kz_radpm z - omega_radps t + phase_rad, x east and "
    "z south of "
    "the origin in m, t in s; water at rest at (x, z) moves by -choppiness (kx, kz) / k amplitude_m sin p";

/// What a file says, before it is checked.
struct Table {
  std::array<std::vector<double>, column_table.size()> columns;
  std::array<std::vector<double>, fact_table.size()> facts;
};

constexpr std::size_t most_alone = 128;  // Gerstner waves of a sea
constexpr std::size_t most_patches = 4;

/// Builds ModalSea of a table; `place` names a row of it.
template <class Place>
ModalSea modes_of(const Table& table, std::string_view file_name, Place place) {
  const auto fail = [](const std::string& where, const std::string& expected, double got, const char* hint) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: expected {}, got {:g}", where, expected, got), hint);
  };
  const std::string name = spectra::printable_name(file_name);
  ModalSea modes;
  const auto fact = [&](Fact which, double low, double high, double otherwise) {
    const std::vector<double>& values = table.facts[which];
    if (values.empty()) return otherwise;
    const std::string expected = fmt::format("one {} within [{:g}, {:g}]", fact_table[which].name, low, high);
    if (values.size() > 1) fail(name, expected, static_cast<double>(values.size()), "give one value");
    if (!(values[0] >= low && values[0] <= high))
      fail(name, expected, values[0], "correct the value in the file");
    return values[0];
  };
  const double infinity = std::numeric_limits<double>::infinity();
  const double samples = fact(patch_size, 16, 4096, modes.size);
  modes.size = static_cast<int>(samples);
  if (samples != modes.size || (modes.size & (modes.size - 1)) != 0) {
    fail(name, "a power of two as size", samples,
         "write the number of samples along a side of a patch, such as 64");
  }
  modes.split_radpm = fact(split, 0.0, 1e4, 0.0);
  modes.choppiness = fact(choppy, 0.0, 10.0, modes.choppiness);
  modes.depth_m = fact(depth, 0.01, infinity, infinity);
  if (!table.facts[loop].empty()) modes.loop_period_s = fact(loop, 0.1, 1e5, 0.0);

  const std::vector<double>& lengths_m = table.facts[patch_length];
  if (lengths_m.size() > most_patches) {
    fail(name, "up to 4 patches", static_cast<double>(lengths_m.size()),
         "list at most 4 lengths in patch_length_m");
  }
  for (const double length_m : lengths_m) {
    if (!(length_m >= 0.01 && length_m <= 1e6)) {
      fail(name, "patch_length_m within [0.01, 1e6]", length_m, "correct the value in the file");
    }
  }
  // From long to short, with the rank of each.
  std::vector<std::size_t> order(lengths_m.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return lengths_m[a] > lengths_m[b]; });
  std::vector<int> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    rank[order[i]] = static_cast<int>(i);
    modes.patch_lengths_m.push_back(lengths_m[order[i]]);
    if (i > 0 && lengths_m[order[i]] == lengths_m[order[i - 1]]) {
      fail(name, "patches of different lengths", lengths_m[order[i]], "give each length once");
    }
  }

  std::size_t alone = 0;
  modes.modes.resize(table.columns[0].size());
  for (std::size_t row = 0; row < modes.modes.size(); ++row) {
    SeaMode& mode = modes.modes[row];
    for (std::size_t i = 0; i < required_columns; ++i) {
      const double value = table.columns[i][row];
      if (!(std::abs(value) <= 1e6)) {
        fail(place(row), fmt::format("{} within [-1e6, 1e6]", column_table[i].name), value,
             "correct the value in the file");
      }
      mode.*column_table[i].value = value;
    }
    if (mode.amplitude_m < 0.0 || mode.omega_radps <= 0.0) {
      fail(place(row), "amplitude_m >= 0 and omega_radps > 0",
           mode.amplitude_m < 0.0 ? mode.amplitude_m : mode.omega_radps,
           "for a negative amplitude, add pi to phase_rad; for a negative omega, negate omega, kx, kz and "
           "phase");
    }
    const double patch = table.columns.back().empty() ? SeaMode::alone : table.columns.back()[row];
    if (patch == SeaMode::alone) {
      if (++alone > most_alone) {
        fail(place(row), fmt::format("at most {} waves that are on no patch", most_alone),
             static_cast<double>(alone),
             "put other waves on a patch: add a column patch and their patch_length_m");
      }
      continue;
    }
    if (!(patch >= 0.0 && patch < static_cast<double>(rank.size())) || patch != std::floor(patch)) {
      fail(place(row),
           rank.empty() ? "patch -1, because the file has no patch_length_m"
                        : fmt::format("a patch within [0, {}], or -1 for none", std::ssize(rank) - 1),
           patch, "list the length of each patch in patch_length_m, or write -1 for waves on no patch");
    }
    mode.patch = rank[static_cast<std::size_t>(patch)];
    const double step_radpm =
        2.0 * std::numbers::pi / modes.patch_lengths_m[static_cast<std::size_t>(mode.patch)];
    for (const double k_radpm : {mode.kx_radpm, mode.kz_radpm}) {
      const double index = k_radpm / step_radpm;
      if (std::abs(index - std::round(index)) > 1e-3 || std::abs(index) > 0.5 * modes.size - 0.5) {
        fail(place(row),
             fmt::format("kx and kz at whole multiples of {:g} rad/m, up to {} of them", step_radpm,
                         modes.size / 2 - 1),
             k_radpm, "round kx and kz to multiples of 2 pi / patch_length_m; for larger ones raise size");
      }
    }
    if (std::hypot(mode.kx_radpm, mode.kz_radpm) < 0.5 * step_radpm) {
      fail(place(row), "kx or kz other than 0", 0.0,
           "leave out the wave of infinite length, which is a mean level");
    }
  }
  if (modes.modes.empty()) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: expected at least one wave, got none", name),
                "write a row for each wave");
  }
  return modes;
}

std::vector<std::string> split_words(std::string_view text) {
  std::vector<std::string> words;
  while (!spectra::is_blank(text)) words.emplace_back(spectra::take_cell(text));
  return words;
}

// "# patch_length_m = 1000, 270"
void parse_fact(TextCursor& cursor, Table& table) {
  const std::string_view line = cursor.line().substr(cursor.line().find('#') + 1);
  const std::size_t equals = line.find('=');
  const std::string_view name = spectra::trimmed(line.substr(0, equals));
  for (std::size_t i = 0; i < fact_table.size() && equals != std::string_view::npos; ++i) {
    if (name != fact_table[i].name) continue;
    table.facts[i].clear();
    for (std::string_view rest = line.substr(equals + 1); !spectra::is_blank(rest);) {
      const std::optional<double> value = spectra::take_number(rest);
      if (!value) {
        cursor.fail(fmt::format("numbers after {} =", name), fmt::format("\"{}\"", printable(rest)),
                    "write a number; separate several by commas");
      }
      table.facts[i].push_back(*value);
    }
  }
}

NetcdfLayout layout_of(const ModalSea& modes, const Table& table) {
  NetcdfLayout layout;
  layout.attributes = {{"Conventions", "CF-1.8"}, {"title", "Waves of a sea"}, {"comment", formula}};
  layout.dimensions = {{"mode", modes.modes.size()}};
  if (!modes.patch_lengths_m.empty())
    layout.dimensions.push_back({"patch_index", modes.patch_lengths_m.size()});
  for (const Column& column : column_table) {
    layout.variables.push_back(
        {column.name,
         column.value != nullptr ? NetcdfLayout::Type::float64 : NetcdfLayout::Type::int32,
         {0},
         {{"units", column.unit}, {"long_name", column.meaning}}});
  }
  for (std::size_t i = 0; i < fact_table.size(); ++i) {
    if (table.facts[i].empty()) continue;
    layout.variables.push_back({fact_table[i].name,
                                i == patch_size ? NetcdfLayout::Type::int32 : NetcdfLayout::Type::float64,
                                i == patch_length ? std::vector<std::size_t>{1} : std::vector<std::size_t>{},
                                {{"units", fact_table[i].unit}, {"long_name", fact_table[i].meaning}}});
  }
  return layout;
}

Table table_of(const ModalSea& modes) {
  Table table;
  for (const SeaMode& mode : modes.modes) {
    for (std::size_t i = 0; i < column_table.size(); ++i) {
      table.columns[i].push_back(column_table[i].value ? mode.*column_table[i].value : mode.patch);
    }
  }
  table.facts[patch_length] = modes.patch_lengths_m;
  table.facts[patch_size] = {static_cast<double>(modes.size)};
  table.facts[split] = {modes.split_radpm};
  table.facts[choppy] = {modes.choppiness};
  if (std::isfinite(modes.depth_m)) table.facts[depth] = {modes.depth_m};
  if (modes.loop_period_s) table.facts[loop] = {*modes.loop_period_s};
  return table;
}

bool is_netcdf(std::string_view bytes) {
  return is_hdf5(bytes) || bytes.starts_with("CDF");
}

}  // namespace

std::string modes_csv(const ModalSea& modes) {
  const Table table = table_of(modes);
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "# {}\n", formula);
  for (std::size_t i = 0; i < fact_table.size(); ++i) {
    if (!table.facts[i].empty())
      fmt::format_to(out, "# {} = {}\n", fact_table[i].name, fmt::join(table.facts[i], ", "));
  }
  for (std::size_t i = 0; i < column_table.size(); ++i)
    fmt::format_to(out, "{}{}", i == 0 ? "" : ",", column_table[i].name);
  text.push_back('\n');
  for (const SeaMode& mode : modes.modes) {
    for (const Column& column : column_table) {
      if (column.value) {
        fmt::format_to(out, "{:.{}g},", mode.*column.value + 0.0, column.digits);  // -0 becomes 0
      } else {
        fmt::format_to(out, "{}\n", mode.patch);
      }
    }
  }
  return fmt::to_string(text);
}

ModalSea parse_modes_csv(std::string_view text, std::string_view file_name) {
  TextCursor cursor(text, file_name);
  Table table;
  const auto is_comment = [&] { return spectra::trimmed(cursor.line()).starts_with('#'); };
  cursor.need_line("a line of column names");
  for (; is_comment(); cursor.need_line("a line of column names")) parse_fact(cursor, table);

  const std::vector<std::string> names = split_words(cursor.line());
  std::array<std::optional<std::size_t>, column_table.size()> places;
  for (std::size_t i = 0; i < column_table.size(); ++i) {
    const auto found = std::find(names.begin(), names.end(), column_table[i].name);
    if (found != names.end()) places[i] = static_cast<std::size_t>(found - names.begin());
    if (!places[i] && i < required_columns) {
      cursor.fail(fmt::format("a column {}", column_table[i].name), "none",
                  "the columns are amplitude_m,kx_radpm,kz_radpm,omega_radps,phase_rad and perhaps patch");
    }
  }
  std::vector<std::size_t> lines;
  while (cursor.next_filled_line()) {
    if (is_comment()) continue;
    lines.push_back(cursor.line_number());
    std::size_t taken = 0;
    for (std::size_t place = 0; place < names.size(); ++place) {
      const std::string_view cell = spectra::take_cell(cursor.rest());
      const auto wanted = std::find(places.begin(), places.end(), place);
      if (wanted == places.end()) continue;
      std::string_view rest = cell;
      const std::optional<double> value = spectra::take_number(rest);
      if (!value || !spectra::is_blank(rest)) {
        cursor.fail(fmt::format("a number in column {}", names[place]),
                    fmt::format("\"{}\"", printable(cell)), "each line has a number for each column name");
      }
      table.columns[static_cast<std::size_t>(wanted - places.begin())].push_back(*value);
      ++taken;
    }
  }
  return modes_of(table, file_name, [&](std::size_t row) {
    return fmt::format("{}:{}", spectra::printable_name(file_name), lines[row]);
  });
}

ModalSea parse_modes_netcdf(std::string_view bytes, std::string_view file_name,
                            decltype(&spectra::read_netcdf_variables) read_variables) {
  std::vector<std::string> names;
  for (const Column& column : column_table) names.emplace_back(column.name);
  for (const FactFacts& fact : fact_table) names.emplace_back(fact.name);
  const auto found = read_variables(std::as_bytes(std::span(bytes)), file_name, names);
  const std::string name = spectra::printable_name(file_name);
  Table table;
  for (std::size_t i = 0; i < column_table.size(); ++i) {
    if (!found[i]) {
      if (i >= required_columns) continue;
      throw Error(
          ErrorKind::bad_input, fmt::format("{}: expected a variable {}, got none", name, names[i]),
          "give a file that `offing ocean modes` has written, or variables of one dimension with its names");
    }
    table.columns[i] = *found[i];
    if (table.columns[i].size() != table.columns[0].size()) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: expected {} values in {}, got {}", name, table.columns[0].size(), names[i],
                              table.columns[i].size()),
                  "give all columns the same dimension");
    }
  }
  for (std::size_t i = 0; i < fact_table.size(); ++i) {
    if (found[column_table.size() + i]) table.facts[i] = *found[column_table.size() + i];
  }
  return modes_of(table, file_name, [&](std::size_t row) { return fmt::format("{}: mode {}", name, row); });
}

ModalSea read_modes(const std::filesystem::path& path, Trust trust) {
  const std::string bytes = read_whole_file(path, {.kind = "a file of modes",
                                                   .most_bytes = std::size_t{1} << 30,
                                                   .hint_of_size = "leave out the smallest waves"});
  if (is_hdf5(bytes) && trust == Trust::untrusted) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format(
            "{}: expected a self-contained file, got HDF5 (NetCDF-4), which can name other files as its "
            "data",
            spectra::printable_name(path.string())),
        "convert it with nccopy -k 64-bit-offset, or leave out --untrusted if you trust the author");
  }
  if (!is_netcdf(bytes)) return parse_modes_csv(bytes, path.string());
  return parse_modes_netcdf(
      bytes, path.string(),
      module_functions<spectra::NetcdfModule>("netcdf", "read NetCDF modes").read_variables);
}

void write_modes(const std::filesystem::path& path, const ModalSea& modes, Existing existing) {
  AtomicFile file(path, existing);
  if (lower_extension(path) != ".nc") {
    file.write(modes_csv(modes));
    file.commit();
    return;
  }
  const Table table = table_of(modes);
  const NetcdfLayout layout = layout_of(modes, table);
  const auto output = module_functions<spectra::NetcdfModule>("netcdf", "write NetCDF modes")
                          .create(file.temporary(), layout, path.string());
  std::size_t variable = 0;
  const auto put = [&](const std::vector<double>& values, std::size_t rank) {
    const std::size_t start = 0, count = values.size();
    output->put(variable++, {&start, rank}, {&count, rank}, values);
  };
  for (const std::vector<double>& column : table.columns) put(column, 1);
  for (std::size_t i = 0; i < fact_table.size(); ++i) {
    if (!table.facts[i].empty()) put(table.facts[i], i == patch_length ? 1 : 0);
  }
  output->close();
  file.commit();
}

}  // namespace offing
