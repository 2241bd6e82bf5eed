// `offing terrain tile`: a height map as a store of tiles, which threads write.
#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include <CLI/Option.hpp>
#include <fmt/format.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "host/base/error.h"
#include "host/base/progress.h"
#include "host/cli/ocean/bounded_queue.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_input.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/io/tile_store/tile_store.h"
#include "host/terrain/tiles/tile_builder.h"

namespace offing::cli {
namespace {

/// Threads that write tiles, most of whose time is waiting for the disk.
class TileWriters {
 public:
  /// Both must outlive the writers.
  TileWriters(const TileStoreWriter& store, Progress& progress);
  TileWriters(const TileWriters&) = delete;
  TileWriters& operator=(const TileWriters&) = delete;
  ~TileWriters();

  /// Waits for room. Throws what writing threw.
  void add(HeightTile tile);
  /// Waits until all is written. Throws what writing threw.
  void finish();

  long long written() const { return written_; }
  long long kept() const { return kept_; }

 private:
  void work();
  void join();
  void throw_if_failed();

  const TileStoreWriter& store_;
  Progress& progress_;
  BoundedQueue<HeightTile> tiles_;
  std::atomic<long long> written_{0}, kept_{0};
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

constexpr std::size_t writers = 4;
constexpr std::size_t most_waiting = 64;  // 34 MB

TileWriters::TileWriters(const TileStoreWriter& store, Progress& progress)
    : store_(store), progress_(progress), tiles_(most_waiting) {
  for (std::size_t i = 0; i < writers; ++i) threads_.emplace_back([this] { work(); });
}

TileWriters::~TileWriters() {
  join();
}

void TileWriters::work() {
  while (auto tile = tiles_.pop()) {
    try {
      if (store_.write(*tile)) {
        ++written_;
        progress_.advance();
      } else {
        ++kept_;
        progress_.skip();
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      tiles_.close();
    }
  }
}

void TileWriters::join() {
  tiles_.close();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

void TileWriters::throw_if_failed() {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
}

void TileWriters::add(HeightTile tile) {
  if (!tiles_.push(std::move(tile))) throw_if_failed();
}

void TileWriters::finish() {
  join();
  throw_if_failed();
}

struct TerrainTileArguments {
  TerrainInput input;
  std::string output;
  bool json = false;
  Existing existing = Existing::keep;
};

/// From rows to a store.
class Tiling {
 public:
  Tiling(const TerrainTileArguments& arguments, const GlobalOptions& options)
      : arguments_(arguments), options_(options) {
    XXH3_64bits_reset(&heights_hash_);
  }

  void begin(const HeightMapFile& about) {
    warn_of_assumed_spacing(arguments_.input.file(), about.source);
    header_.shape = TileSetShape::of(about.map.columns, about.map.rows);
    header_.spacing_x_m = about.map.spacing_x_m;
    header_.spacing_z_m = about.map.spacing_z_m;
    header_.georeference = about.map.georeference;
    header_.centre_latitude_deg = about.source.centre_latitude_deg;
    header_.centre_longitude_deg = about.source.centre_longitude_deg;
    require_storable(arguments_.input.file(), header_.shape);
    store_.emplace(arguments_.output, arguments_.existing);
    progress_.emplace(static_cast<int>(header_.shape.tile_count()), "tiles", options_.verbosity);
    writers_.emplace(*store_, *progress_);
    builder_.emplace(header_.shape, [this](HeightTile tile) { writers_->add(std::move(tile)); });
  }

  void add_row(std::span<const float> heights_m, std::span<const std::uint8_t> is_void) {
    options_.cancel.throw_if_cancelled("run the same command again to resume");
    XXH3_64bits_update(&heights_hash_, heights_m.data(), heights_m.size_bytes());
    for (const float height_m : heights_m) {
      lowest_m_ = std::min(lowest_m_, height_m);
      highest_m_ = std::max(highest_m_, height_m);
    }
    builder_->add_row(heights_m, is_void);
  }

  const TileStoreHeader& finish(const HeightMapSource& source) {
    writers_->finish();
    progress_.reset();
    header_.lowest_m = lowest_m_;
    header_.highest_m = highest_m_;
    header_.void_posts = source.void_posts;
    header_.heights_checksum = XXH3_64bits_digest(&heights_hash_);
    store_->finish(header_);
    return header_;
  }

  /// Leaves a finished store as it was found.
  void discard() {
    writers_.reset();  // waits for its threads
    if (store_) store_->discard();
  }

  long long written() const { return writers_->written(); }
  long long kept() const { return writers_->kept(); }

 private:
  const TerrainTileArguments& arguments_;
  const GlobalOptions& options_;
  TileStoreHeader header_;
  XXH3_state_t heights_hash_;
  float lowest_m_ = std::numeric_limits<float>::max(), highest_m_ = std::numeric_limits<float>::lowest();
  std::optional<TileStoreWriter> store_;
  std::optional<Progress> progress_;
  std::optional<TileWriters> writers_;
  std::optional<terrain::TileBuilder> builder_;
};

std::vector<std::filesystem::path> files_below(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code status;
  for (std::filesystem::recursive_directory_iterator entry(folder, status), end; !status && entry != end;
       entry.increment(status)) {
    files.push_back(entry->path());
  }
  return files;
}

void run(const TerrainTileArguments& arguments, const GlobalOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  require_file_name(arguments.output);
  Tiling tiling(arguments, options);
  require_not_read(files_below(arguments.output), {{arguments.input.file()}, arguments.input.trust()});
  const HeightMapSource source = [&] {
    try {
      return stream_height_map(
          arguments.input.file(), arguments.input.options(),
          [&](const HeightMapFile& about) { tiling.begin(about); },
          [&](std::span<const float> heights_m, std::span<const std::uint8_t> is_void) {
            tiling.add_row(heights_m, is_void);
          });
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::cancelled) tiling.discard();  // one that was stopped may be gone on with
      throw;
    }
  }();
  const TileStoreHeader& header = tiling.finish(source);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (arguments.json) {
    print_json({{"store", arguments.output},
                {"columns", header.shape.columns},
                {"rows", header.shape.rows},
                {"levels", header.shape.levels},
                {"tiles", header.shape.tile_count()},
                {"tiles_kept", tiling.kept()},
                {"lowest_m", header.lowest_m},
                {"highest_m", header.highest_m},
                {"void_posts", header.void_posts},
                {"seconds", taken.count()}});
  } else {
    print_summary("{}: {} x {} posts in {} tiles of {} levels, {} of them kept, {}\n",
                  one_line(arguments.output), header.shape.columns, header.shape.rows,
                  header.shape.tile_count(), header.shape.levels, tiling.kept(),
                  duration_text(taken.count()));
  }
}

}  // namespace

void add_terrain_tile_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainTileArguments>();
  CLI::App* command = terrain.add_subcommand("tile", "convert a height map of any size into a tile store");
  arguments->input.add_to(*command);
  command->add_option("-o,--output", arguments->output, "folder to write the store to")
      ->type_name("STORE")
      ->required();
  add_force_flag(*command, arguments->existing)
      ->description("replace a finished store when the new one is complete; equal tiles are kept");
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_global_options(*command, options, DeviceUse::none);
  command->footer(R"(
FILE may also be a VRT or a folder of rasters. It is read row by row, so memory for a few hundred rows is
enough. An interrupted run resumes when you start it again, and gives the same bytes. A store takes 6.1
bytes per post, or 3.4 if heights are whole metres.

Examples:
  offing terrain tile srtm/ -o alps.tiles
  offing terrain tile ground.r32 --raw-size 32768x32768 --spacing-m 2 -o ground.tiles
  offing terrain render alps.tiles --camera fly -o alps.png)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
