#include "host/io/height_maps/source_heights.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/host_memory.h"

namespace offing::height_maps {

namespace {

void check_sides(const std::filesystem::path& path, std::int64_t columns, std::int64_t rows) {
  constexpr std::int64_t most = std::numeric_limits<int>::max();
  if (columns < 2 || rows < 2 || columns > most || rows > most) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: a height map of {}x{} posts, expected at least 2x2", path.string(), columns, rows),
        "ground lies between posts: give at least two along each side");
  }
}

}  // namespace

void check_size(const std::filesystem::path& path, std::int64_t columns, std::int64_t rows) {
  check_sides(path, columns, rows);
  constexpr double bytes_a_post = sizeof(float) + sizeof(std::uint8_t);
  const double wanted_bytes = bytes_a_post * static_cast<double>(columns) * static_cast<double>(rows);
  require_host_memory(wanted_bytes, fmt::format("{}: {}x{} posts", path.string(), columns, rows),
                      "convert it to a store that needs little memory with `offing terrain tile`, or make it "
                      "coarser with gdal_translate -outsize");
}

SourceHeights begin_heights(const std::filesystem::path& path, std::int64_t columns, std::int64_t rows,
                            const RowTaker& taker) {
  SourceHeights source;
  source.columns = static_cast<int>(columns);
  source.rows = static_cast<int>(rows);
  source.taker = taker;
  if (taker.rows) {
    check_sides(path, columns, rows);
    return source;
  }
  check_size(path, columns, rows);
  // Reserved memory costs nothing until it is written.
  const std::size_t posts = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  source.heights_m.reserve(posts);
  source.is_void.reserve(posts);
  return source;
}

void hand_over_rows(SourceHeights& source) {
  if (!source.taker.rows) return;
  source.taker.rows(source.heights_m, source.is_void);
  source.posts_taken += source.heights_m.size();
  source.heights_m.clear();
  source.is_void.clear();
}

void append_height(const std::filesystem::path& path, SourceHeights& source, float height_m) {
  if (!(std::abs(height_m) <= farthest_height_m)) {
    const std::size_t place = source.posts_taken + source.heights_m.size();
    const std::size_t columns = static_cast<std::size_t>(source.columns);
    if (std::isfinite(height_m)) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: row {}, column {}: expected a height within {:g} m, found {:g}",
                              path.string(), place / columns, place % columns, farthest_height_m, height_m),
                  "if it marks voids, give it as --nodata; else check --scale and the file's unit");
    }
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: row {}, column {}: expected a finite height, found {}", path.string(),
                            place / columns, place % columns, height_m),
                std::isnan(height_m)
                    ? "if NaN marks voids, give --nodata nan; else repair the file"
                    : "if it marks voids, give --nodata inf or --nodata=-inf; else repair the file");
  }
  source.heights_m.push_back(height_m);
  source.is_void.push_back(0);
}

void append_sample(const std::filesystem::path& path, SourceHeights& source, double sample,
                   const HeightScale& scale, const std::optional<double>& nodata) {
  if (nodata && (sample == *nodata || (std::isnan(sample) && std::isnan(*nodata)))) {
    append_void(source);
    return;
  }
  // Of ESRI and of SRTM.
  if (sample == -9999.0 || sample == -32768.0) {
    source.likely_void = sample;
    ++source.likely_voids;
  }
  append_height(path, source, scale.to_metres(sample));
}

}  // namespace offing::height_maps
