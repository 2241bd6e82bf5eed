#include "host/cli/ocean/frame_files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <regex>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>
#define XXH_INLINE_ALL  // the header is the library
#include <xxhash.h>

#include "host/base/error.h"
#include "host/command_line/new_output.h"
#include "host/io/atomic_file.h"
#include "host/io/whole_file.h"

namespace offing::cli {

namespace fs = std::filesystem;

namespace {

/// All that any bake may have written of a cascade or a wake window; more of them than any had: what a single
/// digit counts.
std::vector<BakedMap> all_maps() {
  constexpr std::size_t most_cascades = 10;
  BakeSettings settings;
  settings.wake_cells.assign(most_cascades, 1);
  settings.channels.set();
  std::vector<BakedMap> all;
  for (const FileLayout layout : {FileLayout::channels, FileLayout::combined, FileLayout::rgb}) {
    settings.layout = layout;
    const std::vector<BakedMap> maps = baked_maps(settings, most_cascades);
    all.insert(all.end(), maps.begin(), maps.end());
  }
  return all;
}

/// The hash that a bake wrote into this file, empty if it is no bake's; nothing if the file is missing or
/// damaged.
template <class ReadAttributes>
std::optional<std::string> hash_in(const fs::path& file, ReadAttributes read) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    return std::nullopt;
  }
  try {
    for (const auto& [name, value] : read(file)) {
      if (name == "scene_hash" && std::holds_alternative<std::string>(value)) {
        return std::get<std::string>(value);
      }
    }
    return std::string();
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// Throws Error(bad_input) for a file whose values are not those that were written.
ExrAttributes read_whole_frame(const fs::path& file) {
  ExrContent content = read_exr(file);
  std::vector<ImageChannel> channels;
  for (const ExrContent::Channel& channel : content.channels)
    channels.push_back({channel.name, channel.values});
  const std::pair<std::string, ExrAttribute> expected{"values_hash", values_hash(std::move(channels))};
  if (std::find(content.attributes.begin(), content.attributes.end(), expected) == content.attributes.end()) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: its values have changed", file.string()),
                "make it again");
  }
  return content.attributes;
}

/// The attributes of a description that tell whose it is.
ExrAttributes read_description(const fs::path& file) {
  const auto json = nlohmann::json::parse(
      read_whole_file(file, {.kind = "the description of a bake", .most_bytes = 1 << 20}), nullptr, false);
  if (!json.is_object() || !json.contains("scene_hash") || !json["scene_hash"].is_string()) return {};
  return {{"scene_hash", json["scene_hash"].get<std::string>()}};
}

void remove_file(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) {
    throw Error(ErrorKind::file, fmt::format("{}: cannot remove it: {}", file.string(), error.message()),
                "remove it yourself, or name another folder with -o");
  }
}

[[noreturn]] void refuse_folder(const fs::path& folder, const std::string& why,
                                const char* hint = "name another folder with -o") {
  throw Error(ErrorKind::file, fmt::format("{}: cannot write frames there: {}", folder.string(), why), hint);
}

}  // namespace

std::string values_hash(std::vector<ImageChannel> channels) {
  std::sort(channels.begin(), channels.end(),
            [](const ImageChannel& a, const ImageChannel& b) { return a.name < b.name; });
  XXH3_state_t state;
  XXH3_128bits_reset(&state);
  for (const ImageChannel& channel : channels) {
    XXH3_128bits_update(&state, channel.values.data(), channel.values.size_bytes());
  }
  const XXH128_hash_t hash = XXH3_128bits_digest(&state);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

FrameFiles::Listing FrameFiles::list_folder(const fs::path& folder) {
  static const std::regex exr_name(R"(ocean(\.[cw][0-9](_[a-z_]+)?)?\.[0-9]{4,}\.exr)");
  static const std::regex product_name(R"(ocean\.[0-9]{4,}\.(obj|ply|png)|contact_sheet\.png|ocean\.json)");
  Listing listing;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (std::regex_match(name, exr_name)) listing.exr_files.push_back(entry->path());
    if (std::regex_match(name, product_name)) listing.products.push_back(entry->path());
  }
  if (error) {
    refuse_folder(folder, "it cannot be listed: " + error.message(),
                  "make it readable, or name another folder with -o");
  }
  return listing;
}

FrameFiles::FrameFiles(const BakeSettings& settings, int cascades, std::string scene_hash)
    : settings_(settings),
      maps_(baked_maps(settings, static_cast<std::size_t>(cascades))),
      possible_maps_(all_maps()),
      scene_hash_(std::move(scene_hash)) {}

void FrameFiles::prepare_folder(const GivenInputs& inputs) const {
  const fs::path& folder = settings_.folder;
  std::error_code error;
  fs::create_directories(folder, error);
  std::error_code status_error;
  if (!fs::is_directory(folder, status_error)) {
    refuse_folder(folder, error ? error.message() : "there is a file of that name");
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    refuse_folder(folder, std::strerror(errno), "make it writable, or name another folder with -o");
  }
  remove_stale_partials(folder, "ocean.");
  remove_stale_partials(folder, "contact_sheet.");
  const Listing listing = list_folder(folder);
  std::vector<fs::path> replaceable = listing.exr_files;
  replaceable.insert(replaceable.end(), listing.products.begin(), listing.products.end());
  require_not_read(replaceable, inputs);
  if (settings_.existing == Existing::keep) require_own_files(listing);
}

void FrameFiles::require_own_files(const Listing& listing) const {
  // Frames come before what is made with them, so that another process that has just begun cannot have made
  // products alone: its frames are looked for after its products.
  const std::optional<std::string> described = hash_in(description(), read_description);
  bool has_own_frames = described == scene_hash_;
  std::vector<fs::path> damaged;
  for (const fs::path& file : list_folder(settings_.folder).exr_files) {
    const std::optional<std::string> hash = hash_in(file, read_exr_attributes);
    if (!hash) {
      damaged.push_back(file);
    } else if (*hash == scene_hash_) {
      has_own_frames = true;
    } else {
      throw Error(
          ErrorKind::bad_input,
          fmt::format("{}: expected only frames of this scene and these output settings, found {} of another",
                      settings_.folder.string(), file.filename().string()),
          "name another folder with -o, or replace the frames with --force");
    }
  }
  const auto refuse = [](const fs::path& file, const char* found) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("{}: expected a file of this bake, found {}", file.string(), found),
                "name another folder with -o, or replace the file with --force");
  };
  if (described && *described != scene_hash_) refuse(description(), "another");
  if (has_own_frames) return;  // an interrupted bake: it resumes, and makes damaged frames again
  for (const std::vector<fs::path>& files : {damaged, listing.products}) {
    for (const fs::path& file : files) {
      if (will_write(file)) refuse(file, "no frame of this bake in the folder");
    }
  }
}

bool FrameFiles::will_write(const fs::path& file) const {
  const std::string name = file.filename().string();
  if (name == description().filename()) return true;
  if (settings_.preview == PreviewUse::pictures && name == contact_sheet().filename()) return true;
  static const std::regex numbered(R"(ocean(\.c[0-9](_[a-z_]+)?)?\.([0-9]{4,9})\.[a-z]+)");
  std::smatch parts;
  if (!std::regex_match(name, parts, numbered)) return false;
  const int frame = std::stoi(parts[3]);
  if (frame < settings_.frames.first || frame > settings_.frames.last) return false;
  std::vector<fs::path> own = exr_files(frame);
  if (settings_.mesh != MeshFormat::none) own.push_back(mesh(frame));
  if (settings_.preview == PreviewUse::pictures) own.push_back(preview(frame));
  return std::any_of(own.begin(), own.end(), [&](const fs::path& path) { return path.filename() == name; });
}

bool FrameFiles::has_preview(int frame) const {
  std::error_code error;
  const bool is_there = fs::exists(preview(frame), error);
  if (error) {
    throw Error(ErrorKind::file,
                fmt::format("{}: cannot be looked up: {}", preview(frame).string(), error.message()),
                "remove it, or check the permissions of the folder");
  }
  return is_there;
}

bool FrameFiles::is_done(int frame) const {
  std::error_code ignored;
  if (settings_.mesh != MeshFormat::none && !fs::exists(mesh(frame), ignored)) {
    return false;
  }
  if (settings_.preview == PreviewUse::pictures && !fs::exists(preview(frame), ignored)) {
    return false;
  }
  const std::vector<fs::path> files = exr_files(frame);
  return std::all_of(files.begin(), files.end(),
                     [&](const fs::path& file) { return hash_in(file, read_whole_frame) == scene_hash_; });
}

void FrameFiles::remove_products(int frame) const {
  if (settings_.mesh != MeshFormat::none) remove_file(mesh(frame));
  if (settings_.preview == PreviewUse::pictures) remove_file(preview(frame));
}

void FrameFiles::remove_foreign_files(int frame) const {
  if (settings_.existing == Existing::keep) {
    return;  // prepare_folder() found none
  }
  const std::vector<fs::path> own = exr_files(frame);
  bool is_foreign = false;
  for (const fs::path& file : possible_exr_files(frame)) {
    const std::string hash = hash_in(file, read_exr_attributes).value_or(scene_hash_);
    if (hash.empty() || hash == scene_hash_) {
      continue;
    }
    is_foreign = true;
    if (std::find(own.begin(), own.end(), file) == own.end()) {
      remove_file(file);
    }
  }
  if (is_foreign) {
    for (const char* extension : {"obj", "ply", "png"}) {
      remove_file(product(frame, extension));
    }
    remove_file(contact_sheet());
  }
}

fs::path FrameFiles::exr(int frame, const std::string& file) const {
  return settings_.folder / fmt::format("{}.{:04}.exr", file, frame);
}

fs::path FrameFiles::mesh(int frame) const {
  return product(frame, settings_.mesh == MeshFormat::obj ? "obj" : "ply");
}

fs::path FrameFiles::preview(int frame) const {
  return product(frame, "png");
}

fs::path FrameFiles::contact_sheet() const {
  return settings_.folder / "contact_sheet.png";
}

fs::path FrameFiles::description() const {
  return settings_.folder / "ocean.json";
}

std::vector<fs::path> FrameFiles::exr_files(int frame) const {
  return exr_files(frame, maps_);
}

std::vector<fs::path> FrameFiles::possible_exr_files(int frame) const {
  return exr_files(frame, possible_maps_);
}

std::vector<fs::path> FrameFiles::exr_files(int frame, const std::vector<BakedMap>& maps) const {
  std::vector<fs::path> files;
  for (const BakedMap& map : maps) {
    const fs::path file = exr(frame, map.file);
    if (files.empty() || files.back() != file) files.push_back(file);
  }
  return files;
}

fs::path FrameFiles::product(int frame, const char* extension) const {
  return settings_.folder / fmt::format("ocean.{:04}.{}", frame, extension);
}

}  // namespace offing::cli
