#include "host/cli/terrain/terrain_input.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/command_line/general_flags.h"
#include "host/io/tile_store/tile_store.h"

namespace offing::cli {
namespace {

enum class Finite { required, optional };

/// A number, if the flag was given.
std::optional<double> number_of(std::string_view flag, const std::string& text, Finite finite,
                                std::string_view example) {
  if (text.empty()) {
    return std::nullopt;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() ||
      (finite == Finite::required && !std::isfinite(value))) {
    throw bad_argument(flag, finite == Finite::required ? "a finite number" : "a number, nan or inf", text,
                       example);
  }
  return value;
}

/// The value of the word that was given, or `usual` without one.
template <typename Value>
Value word_of(std::string_view flag, const std::string& text, Value usual,
              std::initializer_list<std::pair<std::string_view, Value>> words) {
  if (text.empty()) {
    return usual;
  }
  std::string known;
  for (const auto& [word, value] : words) {
    if (text == word) {
      return value;
    }
    known += fmt::format("{}{}", known.empty() ? "" : ", ", word);
  }
  throw bad_argument(flag, "one of " + known, text, words.begin()->first);
}

constexpr int most_posts_a_side = 1'000'000;

}  // namespace

void HeightMapFlags::add_to(CLI::App& command) {
  const auto add = [&](const char* group, const char* names, std::string& target, const char* placeholder,
                       const char* help) {
    return command.add_option(names, target, help)->type_name(placeholder)->group(group);
  };
  constexpr const char* heights = "Heights";
  add(heights, "--encoding", encoding_, "NAME", "mapbox or terrarium: heights packed into 8-bit RGB");
  add(heights, "--scale", scale_, "S",
      "metres a unit of the file's heights (default 1, or as the file says)");
  add(heights, "--offset-m", offset_, "H", "added to the scaled heights, m (default 0)");
  add(heights, "--band", band_, "N", "band that holds heights, counted from 1 (default 1)");
  add(heights, "--channel", channel_, "NAME",
      "channel of an EXR (default: the only one, or height, Y, Z, R)");
  add(heights, "--nodata", nodata_, "V", "another value that marks voids in the file; may be nan");
  add(heights, "--void-height-m", void_height_, "H", "height of voids (default: from the posts around them)");
  constexpr const char* place = "Spacing";
  CLI::Option* both = add(place, "--spacing-m", spacing_, "S", "distance of posts, m");
  add(place, "--spacing-x-m", spacing_x_, "S", "the same along x (east) alone")->excludes(both);
  add(place, "--spacing-z-m", spacing_z_, "S", "the same along z (south) alone")->excludes(both);
  add(place, "--unit", unit_, "UNIT", "metre or degree, of coordinates whose file does not say");
  add(place, "--reproject", reproject_to_, "SYSTEM",
      "resample to metres: utm, or a coordinate system such as EPSG:32719");
  constexpr const char* raw = "Files without a header (.r16, .r32, .raw, .bin)";
  add(raw, "--raw-size", raw_size_, "WxH", "posts along x and z");
  add(raw, "--raw-type", raw_type_, "TYPE", "u16, s16 or f32 (default by the ending: .r16 u16, .r32 f32)");
  add(raw, "--raw-order", raw_order_, "ORDER", "little or big: byte order (default little)");
}

bool HeightMapFlags::are_given() const {
  const std::array all{&encoding_, &scale_,        &offset_,   &band_,      &channel_,
                       &nodata_,   &void_height_,  &spacing_,  &spacing_x_, &spacing_z_,
                       &unit_,     &reproject_to_, &raw_size_, &raw_type_,  &raw_order_};
  return std::any_of(all.begin(), all.end(), [](const std::string* text) { return !text->empty(); });
}

HeightMapOptions HeightMapFlags::read() const {
  HeightMapOptions options;
  options.encoding = word_of("--encoding", encoding_, HeightEncoding::plain,
                             {{"terrarium", HeightEncoding::terrarium}, {"mapbox", HeightEncoding::mapbox}});
  if (!band_.empty()) {
    options.band = static_cast<int>(read_whole("--band", band_, 1, 65535, "1"));
  }
  options.exr_channel = channel_;
  if (!raw_size_.empty()) {
    const std::size_t cross = raw_size_.find('x');
    if (cross == std::string::npos) {
      throw bad_argument("--raw-size", "COLUMNSxROWS", raw_size_, "1025x1025");
    }
    const auto side = [&](std::string_view text) {
      return static_cast<int>(read_whole("--raw-size", text, 1, most_posts_a_side, "1025x1025"));
    };
    const std::string_view text = raw_size_;
    options.raw_columns = side(text.substr(0, cross));
    options.raw_rows = side(text.substr(cross + 1));
  }
  if (!raw_type_.empty()) {
    options.raw_type =
        word_of("--raw-type", raw_type_, RawType::unsigned_16,
                {{"u16", RawType::unsigned_16}, {"s16", RawType::signed_16}, {"f32", RawType::float_32}});
  }
  options.raw_byte_order = word_of("--raw-order", raw_order_, ByteOrder::little_endian,
                                   {{"little", ByteOrder::little_endian}, {"big", ByteOrder::big_endian}});
  options.vertical_scale = number_of("--scale", scale_, Finite::required, "0.1").value_or(1.0);
  options.offset_m = number_of("--offset-m", offset_, Finite::required, "-200").value_or(0.0);
  options.spacing_x_m = options.spacing_z_m = number_of("--spacing-m", spacing_, Finite::required, "30");
  if (spacing_.empty()) {
    options.spacing_x_m = number_of("--spacing-x-m", spacing_x_, Finite::required, "20.6");
    options.spacing_z_m = number_of("--spacing-z-m", spacing_z_, Finite::required, "30.9");
  }
  options.nodata = number_of("--nodata", nodata_, Finite::optional, "-9999");
  options.void_height_m = number_of("--void-height-m", void_height_, Finite::required, "0");
  options.horizontal_unit = word_of("--unit", unit_, HorizontalUnit::of_file,
                                    {{"metre", HorizontalUnit::metre}, {"degree", HorizontalUnit::degree}});
  options.reproject_to = reproject_to_;
  return options;
}

void TerrainInput::add_to(CLI::App& command) {
  command
      .add_option("FILE", file_,
                  "GeoTIFF, SRTM .hgt (.hgt.zip), USGS DEM, ASCII grid, PNG, EXR, .r16, .r32, or another "
                  "raster of docs/terrain.md; or a tile store")
      ->required()
      ->type_name("");
  flags_.add_to(command);
  add_trust_flag(command, trust_);
}

HeightMapOptions TerrainInput::options() const {
  HeightMapOptions options = flags_.read();
  options.trust.trust = trust_;
  return options;
}

HeightMapFile TerrainInput::read() const {
  if (is_tile_store(file_)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a height map, found a tile store", one_line(file_)),
                "give this command the map that it was made of");
  }
  HeightMapFile file = read_height_map(file_, options());
  warn_of_assumed_spacing(file_, file.source);
  return file;
}

terrain::HeightField make_field(const HeightMap& map, const ocl::Device& device) {
  return {device, terrain::post_grid(map), map.heights_m};
}

}  // namespace offing::cli
