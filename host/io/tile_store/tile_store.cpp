#include "host/io/tile_store/tile_store.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include "host/base/error.h"
#include "host/io/atomic_file.h"
#include "host/io/tile_store/tile_file.h"
#include "host/io/toml_depth.h"

namespace offing {
namespace {

namespace fs = std::filesystem;

constexpr const char* header_name = "store.toml";
constexpr const char* new_tiles_name = ".new";  ///< tiles that wait to replace those of a finished store
constexpr int format_version = 2;

fs::path tile_path(const fs::path& folder, const TileKey& key) {
  return folder / std::to_string(key.level) / fmt::format("{:04}", key.row) /
         fmt::format("{:04}.tile", key.column);
}

std::optional<std::string> content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::error_code status;
  const auto bytes = fs::file_size(path, status);
  if (status) return std::nullopt;
  std::string content(bytes, '\0');
  file.read(content.data(), static_cast<std::streamsize>(bytes));
  content.resize(static_cast<std::size_t>(file.gcount()));
  return content;
}

[[noreturn]] void refuse_header(const fs::path& path, const std::string& what) {
  throw Error(ErrorKind::bad_input, fmt::format("{}: {}", path.string(), what),
              "make the store with `offing terrain tile MAP -o STORE`");
}

/// Values of a header by name.
class HeaderReader {
 public:
  HeaderReader(fs::path path, const toml::table& table) : path_(std::move(path)), table_(table) {}

  template <class T>
  T value(const char* name) const {
    if (const auto found = optional<T>(name)) return *found;
    refuse_header(path_, fmt::format("expected a value for {}, found none", name));
  }
  template <class T>
  std::optional<T> optional(const char* name) const {
    // toml++ would convert 2e56 to a whole number, which C++ leaves undefined.
    if constexpr (std::is_same_v<T, std::int64_t>) {
      return table_[name].value_exact<T>();
    } else {
      return table_[name].value<T>();
    }
  }
  int whole(const char* name, std::int64_t low, std::int64_t high) const {
    const auto number = value<std::int64_t>(name);
    if (number >= low && number <= high) return static_cast<int>(number);
    refuse_header(path_, fmt::format("{}: expected {} ... {}, found {}", name, low, high, number));
  }
  double within(const char* name, double farthest) const {
    const auto number = value<double>(name);
    if (std::abs(number) <= farthest) return number;
    refuse_header(path_,
                  fmt::format("{}: expected a number within {:g}, found {:g}", name, farthest, number));
  }
  std::optional<double> finite(const char* name) const {
    const auto number = optional<double>(name);
    if (!number || std::isfinite(*number)) return number;
    refuse_header(path_, fmt::format("{}: expected a finite number, found {:g}", name, *number));
  }
  double above_zero(const char* name) const {
    const auto number = value<double>(name);
    if (number > 0.0 && number < 1e9) return number;
    refuse_header(path_, fmt::format("{}: expected metres above 0, found {:g}", name, number));
  }

 private:
  fs::path path_;
  const toml::table& table_;
};

std::uint64_t checksum_of(const fs::path& path, const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (error == std::errc{} && end == text.data() + text.size()) return value;
  refuse_header(path, fmt::format("heights_checksum: expected 16 hexadecimal digits, found \"{}\"", text));
}

TileStoreHeader read_header(const fs::path& folder, Trust trust) {
  const fs::path path = folder / header_name;
  if (trust == Trust::untrusted) require_below(folder, path);
  const auto content = content_of(path);
  if (!content) refuse_header(path, "expected the header of a tile store, found no such file");
  if (const std::optional<TomlPlace> place = too_deep_toml(*content)) {
    refuse_header(path, fmt::format("expected at most {} nested names or brackets, found more in line {}",
                                    most_toml_levels, place->line));
  }
  toml::table table;
  try {
    table = toml::parse(*content);
  } catch (const toml::parse_error& error) {
    refuse_header(path, fmt::format("expected TOML, found {} in line {}", one_line(error.description()),
                                    error.source().begin.line));
  }
  const HeaderReader reader(path, table);
  reader.whole("version", format_version, format_version);
  reader.whole("tile_cells", tile_cells, tile_cells);
  TileStoreHeader header;
  header.shape = TileSetShape::of(reader.whole("columns", 2, most_stored_posts),
                                  reader.whole("rows", 2, most_stored_posts));
  reader.whole("levels", header.shape.levels, header.shape.levels);
  header.spacing_x_m = reader.above_zero("spacing_x_m");
  header.spacing_z_m = reader.above_zero("spacing_z_m");
  constexpr double farthest_height_m = 1e6;
  header.lowest_m = static_cast<float>(reader.within("lowest_m", farthest_height_m));
  header.highest_m = static_cast<float>(reader.within("highest_m", farthest_height_m));
  if (header.lowest_m > header.highest_m) {
    refuse_header(path, fmt::format("highest_m: expected {:g} or more, as lowest_m is, found {:g}",
                                    header.lowest_m, header.highest_m));
  }
  header.void_posts =
      static_cast<std::uint64_t>(std::max<std::int64_t>(0, reader.value<std::int64_t>("void_posts")));
  header.heights_checksum = checksum_of(path, reader.value<std::string>("heights_checksum"));
  header.georeference = {reader.optional<std::string>("coordinate_system").value_or(""),
                         reader.finite("first_post_x").value_or(0.0),
                         reader.finite("first_post_y").value_or(0.0), reader.finite("step_x").value_or(0.0),
                         reader.finite("step_y").value_or(0.0)};
  header.centre_latitude_deg = reader.finite("centre_latitude_deg");
  header.centre_longitude_deg = reader.finite("centre_longitude_deg");
  return header;
}

/// A number that reads as a float of TOML, with all its digits.
std::string digits(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string header_text(const TileStoreHeader& header) {
  std::string text = "# A height map in tiles, made by `offing terrain tile`.\n";
  const auto line = [&](const char* name, const std::string& value) {
    text += fmt::format("{} = {}\n", name, value);
  };
  line("version", std::to_string(format_version));
  line("columns", std::to_string(header.shape.columns));
  line("rows", std::to_string(header.shape.rows));
  line("tile_cells", std::to_string(tile_cells));
  line("levels", std::to_string(header.shape.levels));
  line("spacing_x_m", digits(header.spacing_x_m));
  line("spacing_z_m", digits(header.spacing_z_m));
  line("lowest_m", digits(header.lowest_m));
  line("highest_m", digits(header.highest_m));
  line("void_posts", std::to_string(header.void_posts));
  line("heights_checksum", fmt::format("\"{:016x}\"", header.heights_checksum));
  if (header.centre_latitude_deg && header.centre_longitude_deg) {
    line("centre_latitude_deg", digits(*header.centre_latitude_deg));
    line("centre_longitude_deg", digits(*header.centre_longitude_deg));
  }
  const Georeference& place = header.georeference;
  if (place.step_x != 0.0) {
    line("first_post_x", digits(place.origin_x));
    line("first_post_y", digits(place.origin_y));
    line("step_x", digits(place.step_x));
    line("step_y", digits(place.step_y));
    if (!place.coordinate_system.empty()) line("coordinate_system", "'''" + place.coordinate_system + "'''");
  }
  return text;
}

/// Whether an entry of a folder could be of a store that was not finished: a level, new tiles, or a temporary
/// of the header's.
bool is_of_store(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  const bool is_level = name.size() == 1 && name[0] >= '0' && name[0] <= '8' && entry.is_directory();
  return is_level || name == new_tiles_name || name.starts_with(fmt::format(".{}.", header_name));
}

/// The number that a file or folder of a store is named by; nothing where it is some other file.
std::optional<int> number_of(const fs::path& path, std::string_view extension) {
  const std::string stem = path.stem().string();
  int number = 0;
  const auto [end, failure] = std::from_chars(stem.data(), stem.data() + stem.size(), number);
  if (failure != std::errc() || end != stem.data() + stem.size() || path.extension() != extension) {
    return std::nullopt;
  }
  return number;
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code status;
  for (fs::directory_iterator entry(folder, status), end; !status && entry != end; entry.increment(status)) {
    entries.push_back(entry->path());
  }
  return entries;
}

/// Removes the tiles that a map of another shape had. What cannot be removed is never read and may stay.
void remove_others(const fs::path& folder, const TileSetShape& shape) {
  std::error_code ignored;
  for (const fs::path& level_folder : entries_of(folder)) {
    const std::optional<int> level = number_of(level_folder, "");
    if (!level) continue;
    for (const fs::path& row_folder : entries_of(level_folder)) {
      const std::optional<int> row = number_of(row_folder, "");
      if (!row) continue;
      const bool has_row = *level < shape.levels && *row < shape.tiles_z(*level);
      for (const fs::path& tile : entries_of(row_folder)) {
        const std::optional<int> column = number_of(tile, ".tile");
        if (column && !(has_row && *column < shape.tiles_x(*level))) fs::remove(tile, ignored);
      }
      if (!has_row) fs::remove(row_folder, ignored);  // if it is empty now
    }
    if (*level >= shape.levels) fs::remove(level_folder, ignored);
  }
}

void make_folder(const fs::path& folder) {
  std::error_code status;
  fs::create_directories(folder, status);
  if (!status) return;
  throw Error(ErrorKind::file,
              fmt::format("{}: cannot create the folder: {}", folder.string(), status.message()),
              "name a folder that does not exist yet, where you may write");
}

/// Whether a file is a tile of this place that was damaged. No run leaves one half-written.
bool is_damaged_tile(const fs::path& path, const std::string& bytes, const TileKey& key) {
  if (!tile_store::is_begun_as_tile(bytes)) return false;
  try {
    tile_store::decode_tile(path, bytes, key);
    return false;
  } catch (const Error&) {
    return true;
  }
}

[[noreturn]] void fail_to(const char* action, const fs::path& path, const std::error_code& reason) {
  throw Error(ErrorKind::file, fmt::format("{}: cannot be {}: {}", path.string(), action, reason.message()),
              "check the permissions of the folder");
}

void remove_file(const fs::path& path) {
  std::error_code status;
  fs::remove(path, status);
  if (status) fail_to("removed", path, status);
}

void move_file(const fs::path& from, const fs::path& to) {
  std::error_code status;
  fs::rename(from, to, status);
  if (status) fail_to("replaced", to, status);
}

}  // namespace

bool is_tile_store(const fs::path& path) {
  std::error_code status;
  return fs::is_directory(path, status) && fs::is_regular_file(path / header_name, status);
}

TileStore::TileStore(fs::path folder, Trust trust)
    : folder_(std::move(folder)), trust_(trust), header_(read_header(folder_, trust)) {}

fs::path TileStore::path_of(const TileKey& key) const {
  return tile_path(folder_, key);
}

HeightTile TileStore::read(const TileKey& key) const {
  const fs::path path = path_of(key);
  if (trust_ == Trust::untrusted) require_below(folder_, path);
  const auto content = content_of(path);
  if (content) return tile_store::decode_tile(path, *content, key);
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected a tile, found none that can be read", path.string()),
              "make the store again with `offing terrain tile`: tiles that are whole are kept");
}

void require_storable(const std::string& map, const TileSetShape& shape) {
  if (shape.columns <= most_stored_posts && shape.rows <= most_stored_posts) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected at most {} posts per side, found {} x {}", map, most_stored_posts,
                          shape.columns, shape.rows),
              "cut the map with gdal_translate -srcwin, or make it coarser with gdal_translate -outsize");
}

TileStoreWriter::TileStoreWriter(fs::path folder, Existing existing)
    : folder_(std::move(folder)), existing_(existing), is_replacement_(is_tile_store(folder_)) {
  if (is_replacement_ && existing == Existing::keep) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("{}: expected a new folder, found a finished tile store", folder_.string()),
                "--force makes it again, or name another folder with -o");
  }
  make_folder(folder_);
  std::error_code status;
  for (fs::directory_iterator entry(folder_, status), end; !status && entry != end; entry.increment(status)) {
    if (entry->path().filename() == header_name || is_of_store(*entry)) continue;
    throw Error(ErrorKind::bad_usage,
                fmt::format("{}: expected an empty folder or a tile store, found {} in it", folder_.string(),
                            entry->path().filename().string()),
                "name a new folder with -o");
  }
  if (status) {
    throw Error(ErrorKind::file, fmt::format("{}: cannot be read: {}", folder_.string(), status.message()),
                "check the permissions of the folder");
  }
  remove_partials();
}

void TileStoreWriter::remove_partials() const {
  for (const fs::path& top : {folder_, folder_ / new_tiles_name}) {
    remove_stale_partials(top);
    for (const fs::path& level : entries_of(top)) {
      if (!number_of(level, "")) continue;
      for (const fs::path& row : entries_of(level)) remove_stale_partials(row);
    }
  }
}

bool TileStoreWriter::write(const HeightTile& tile) const {
  const std::string bytes = tile_store::encode_tile(tile);
  const fs::path path = tile_path(folder_, tile.key), waiting = tile_path(folder_ / new_tiles_name, tile.key);
  const std::optional<std::string> found = content_of(path);
  if (found == bytes) {
    std::error_code ignored;
    if (is_replacement_) fs::remove(waiting, ignored);  // of a run for another map that was stopped
    return false;
  }
  if (found && existing_ == Existing::keep && !is_damaged_tile(path, *found, tile.key)) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("{}: expected a tile of this map, found another file", path.string()),
                "add --force to replace it, or name another folder with -o");
  }
  const fs::path& target = is_replacement_ ? waiting : path;
  if (is_replacement_ && content_of(waiting) == bytes) return false;
  make_folder(target.parent_path());
  write_file_atomically(target, bytes);
  return true;
}

void TileStoreWriter::finish(const TileStoreHeader& header) const {
  if (is_replacement_) {
    remove_file(folder_ / header_name);  // until all tiles have moved it is no store
    for (const fs::path& level : entries_of(folder_ / new_tiles_name)) {
      for (const fs::path& row : entries_of(level)) {
        const fs::path rows = folder_ / level.filename() / row.filename();
        make_folder(rows);
        for (const fs::path& tile : entries_of(row)) move_file(tile, rows / tile.filename());
      }
    }
  }
  discard();
  remove_others(folder_, header.shape);
  write_file_atomically(folder_ / header_name, header_text(header));
}

void TileStoreWriter::discard() const {
  std::error_code ignored;
  fs::remove_all(folder_ / new_tiles_name, ignored);
}

}  // namespace offing
