#include "host/io/height_maps/read_colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_utils.h>

#include "host/base/error.h"
#include "host/io/height_maps/gdal_session.h"
#include "host/io/height_maps/raster_file.h"
#include "host/io/height_maps/readable_file.h"

namespace offing {
namespace {

using height_maps::Dataset;
using height_maps::GdalSession;
using height_maps::SpatialReference;

constexpr double most_pixels = 268'435'456.0;
using Corner = std::array<double, 6>;
using Colour = std::array<std::uint8_t, 4>;

/// Pixels in red, green, blue and alpha, and where they lie.
struct Pixels {
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> rgba;
  std::optional<Corner> corner;  ///< nothing where they do not say
};

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what, const char* hint) {
  throw Error(ErrorKind::bad_input, fmt::format("{}: {}", path.string(), what), hint);
}

void require_size(const std::filesystem::path& path, int columns, int rows) {
  if (static_cast<double>(columns) * rows <= most_pixels) return;
  refuse(path, fmt::format("expected at most {:.0f} pixels, found {} x {}", most_pixels, columns, rows),
         "cut out a part or make it coarser, for example with gdal_translate -srcwin or -outsize");
}

class Image {
 public:
  Image(const std::filesystem::path& path, const FileTrust& trust) : path_(path) {
    height_maps::require_readable_file(path, "a picture");
    dataset_ = height_maps::open_raster(path, trust);
    if (!dataset_) {
      refuse(path_,
             fmt::format("expected a picture, found a file that cannot be opened as one: {}",
                         session_.failure()),
             "give a GeoTIFF or a PNG; a file that is cut short must be copied again");
    }
    if (bands() == 0) {
      refuse(path_, "expected a picture, found none in it", "name one of its pictures as a file");
    }
    require_size(path_, columns(), rows());
    cache_.emplace(dataset_.get());
    const GDALDataType type = GDALGetRasterDataType(band(1));
    if (type != GDT_Byte && type != GDT_UInt16) {
      refuse(path_, fmt::format("expected colours of 8 or 16 bits, found {}", GDALGetDataTypeName(type)),
             "if these are heights, give them as FILE");
    }
  }

  /// Its coordinate system as WKT; empty where it names none.
  std::string coordinate_system() const {
    const OGRSpatialReferenceH own = GDALGetSpatialRef(dataset_.get());
    return own == nullptr ? "" : height_maps::wkt_of(own);
  }

  Pixels read() const {
    const auto count = static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows());
    Pixels pixels{.columns = columns(), .rows = rows(), .rgba = {}, .corner = corner()};
    pixels.rgba.resize(4 * count);
    const GDALColorTableH palette = GDALGetRasterColorTable(band(1));
    const std::vector<Colour> colours = palette == nullptr ? std::vector<Colour>() : colours_of(palette);
    // Row by row: in most files the bands of a pixel lie together.
    for (int row = 0; row < rows(); ++row) {
      std::uint8_t* const target = pixels.rgba.data() + std::ptrdiff_t{4} * columns() * row;
      read_band(GDALGetMaskBand(band(1)), row, target + 3);
      if (palette != nullptr) {
        read_indices(colours, row, target);
        continue;
      }
      for (int channel = 0; channel < 3; ++channel)
        read_band(band(bands() >= 3 ? channel + 1 : 1), row, target + channel);
    }
    return pixels;
  }

 private:
  int columns() const { return GDALGetRasterXSize(dataset_.get()); }
  int rows() const { return GDALGetRasterYSize(dataset_.get()); }
  int bands() const { return GDALGetRasterCount(dataset_.get()); }
  GDALRasterBandH band(int number) const { return GDALGetRasterBand(dataset_.get(), number); }

  std::optional<Corner> corner() const {
    Corner corner{};
    if (GDALGetGeoTransform(dataset_.get(), corner.data()) != CE_None) return std::nullopt;
    if (corner[2] != 0.0 || corner[4] != 0.0 || !std::isnormal(corner[1]) || !std::isnormal(corner[5]) ||
        corner[1] < 0.0) {
      refuse(path_, "expected columns toward the east and rows along the meridian, found a rotated picture",
             "make a north-up copy with gdalwarp");
    }
    return corner;
  }

  /// Calls take(value, i) for each pixel i of a row.
  template <class Take>
  void for_each(GDALRasterBandH band, int row, Take take) const {
    std::vector<std::uint16_t> values(static_cast<std::size_t>(columns()));
    if (GDALRasterIO(band, GF_Read, 0, row, columns(), 1, values.data(), columns(), 1, GDT_UInt16, 0, 0) !=
        CE_None) {
      refuse(path_,
             fmt::format("expected {} rows, found none that can be read from row {} on: {}", rows(), row,
                         session_.failure()),
             "the file is cut short or damaged: copy or download it again");
    }
    for (std::size_t i = 0; i < values.size(); ++i) take(values[i], i);
  }

  /// Bytes of a row of a band to every fourth byte from `target` on.
  void read_band(GDALRasterBandH band, int row, std::uint8_t* target) const {
    const bool is_wide = GDALGetRasterDataType(band) == GDT_UInt16;
    for_each(band, row, [&](std::uint16_t value, std::size_t i) {
      target[4 * i] = static_cast<std::uint8_t>(is_wide ? (value + 128) / 257 : value);
    });
  }

  static std::vector<Colour> colours_of(GDALColorTableH palette) {
    std::vector<Colour> colours;
    for (int i = 0; i < GDALGetColorEntryCount(palette); ++i) {
      GDALColorEntry entry{};
      GDALGetColorEntryAsRGB(palette, i, &entry);
      const auto byte = [](short value) { return static_cast<std::uint8_t>(std::clamp<int>(value, 0, 255)); };
      colours.push_back({byte(entry.c1), byte(entry.c2), byte(entry.c3), byte(entry.c4)});
    }
    return colours;
  }

  /// Colours for the indices of a row whose mask is in `target` already.
  void read_indices(const std::vector<Colour>& colours, int row, std::uint8_t* target) const {
    for_each(band(1), row, [&](std::uint16_t index, std::size_t i) {
      const bool is_covered = index < colours.size() && target[4 * i + 3] != 0;
      const Colour colour = is_covered ? colours[index] : Colour{};
      std::copy(colour.begin(), colour.end(), target + 4 * i);
    });
  }

  std::filesystem::path path_;
  GdalSession session_;
  Dataset dataset_;
  std::optional<height_maps::CacheBound> cache_;
};

struct FreeList {
  void operator()(char** list) const { CSLDestroy(list); }
};
using WordList = std::unique_ptr<char*, FreeList>;

WordList list_of(std::initializer_list<std::string> words) {
  WordList list;
  for (const std::string& word : words) list.reset(CSLAddString(list.release(), word.c_str()));
  return list;
}

/// A raster in memory of pixels, which must outlive it.
Dataset raster_of(Pixels& pixels, const std::string& coordinate_system) {
  Dataset raster(
      GDALCreate(GDALGetDriverByName("MEM"), "", pixels.columns, pixels.rows, 0, GDT_Byte, nullptr));
  if (!raster) return raster;
  for (std::size_t channel = 0; channel < 4; ++channel) {
    std::array<char, 64> place{};
    CPLPrintPointer(place.data(), pixels.rgba.data() + channel, static_cast<int>(place.size()) - 1);
    const WordList options = list_of({fmt::format("DATAPOINTER={}", place.data()), "PIXELOFFSET=4",
                                      fmt::format("LINEOFFSET={}", 4 * pixels.columns)});
    if (GDALAddBand(raster.get(), GDT_Byte, options.get()) != CE_None) return nullptr;
  }
  GDALSetRasterColorInterpretation(GDALGetRasterBand(raster.get(), 4), GCI_AlphaBand);
  GDALSetGeoTransform(raster.get(), pixels.corner->data());
  GDALSetProjection(raster.get(), coordinate_system.c_str());
  return raster;
}

/// The pixels resampled to a coordinate system, where it is another than their own.
Pixels brought_into(const std::string& wanted, Pixels pixels, const std::string& own,
                    const std::filesystem::path& path) {
  const GdalSession session;
  const SpatialReference to = height_maps::spatial_reference(wanted),
                         from = height_maps::spatial_reference(own);
  if (!to || !from || OSRIsSame(to.get(), from.get()) != 0) return pixels;
  const auto fail = [&] {
    refuse(path, fmt::format("cannot be brought into the map's coordinate system: {}", session.failure()),
           "convert it first, with gdalwarp");
  };
  const Dataset source = raster_of(pixels, own);
  if (!source) fail();
  const WordList words =
      list_of({"-of", "MEM", "-r", "bilinear", "-dstalpha", "-t_srs", height_maps::wkt_of(to.get())});
  const std::unique_ptr<GDALWarpAppOptions, void (*)(GDALWarpAppOptions*)> options(
      GDALWarpAppOptionsNew(words.get(), nullptr), GDALWarpAppOptionsFree);
  GDALDatasetH handle = source.get();
  const Dataset warped(GDALWarp("", nullptr, 1, &handle, options.get(), nullptr));
  if (!warped) fail();
  Pixels result{.columns = GDALGetRasterXSize(warped.get()),
                .rows = GDALGetRasterYSize(warped.get()),
                .rgba = {},
                .corner = Corner{}};
  require_size(path, result.columns, result.rows);
  result.rgba.resize(4 * static_cast<std::size_t>(result.columns) * static_cast<std::size_t>(result.rows));
  if (GDALGetGeoTransform(warped.get(), result.corner->data()) != CE_None ||
      GDALDatasetRasterIOEx(warped.get(), GF_Read, 0, 0, result.columns, result.rows, result.rgba.data(),
                            result.columns, result.rows, GDT_Byte, 4, nullptr, 4,
                            4 * GSpacing{result.columns}, 1, nullptr) != CE_None) {
    fail();
  }
  return result;
}

/// Rows from north to south.
void turn_over(ColourMap& colours) {
  const std::size_t bytes = 4 * static_cast<std::size_t>(colours.columns);
  for (std::size_t top = 0, bottom = static_cast<std::size_t>(colours.rows) - 1; top < bottom;
       ++top, --bottom) {
    const auto begin = colours.rgba.begin();
    std::swap_ranges(begin + static_cast<std::ptrdiff_t>(top * bytes),
                     begin + static_cast<std::ptrdiff_t>((top + 1) * bytes),
                     begin + static_cast<std::ptrdiff_t>(bottom * bytes));
  }
}

}  // namespace

ColourMap read_colour_map(const std::filesystem::path& path, const HeightMap& map, const FileTrust& trust) {
  const Image picture(path, trust);
  const Georeference& place = map.georeference;
  Pixels pixels = picture.read();
  if (pixels.corner && place.step_x != 0.0 && !place.coordinate_system.empty()) {
    pixels = brought_into(place.coordinate_system, std::move(pixels), picture.coordinate_system(), path);
  }
  const std::optional<Corner> corner = pixels.corner;
  ColourMap colours{.columns = pixels.columns,
                    .rows = pixels.rows,
                    .rgba = std::move(pixels.rgba),
                    .left = 0.0,
                    .top = 0.0,
                    .right = map.columns - 1.0,
                    .bottom = map.rows - 1.0};
  if (!corner || place.step_x == 0.0) return colours;
  const Corner& at = *corner;
  colours.left = (at[0] - place.origin_x) / place.step_x;
  colours.right = (at[0] + colours.columns * at[1] - place.origin_x) / place.step_x;
  colours.top = (at[3] - place.origin_y) / place.step_y;
  colours.bottom = (at[3] + colours.rows * at[5] - place.origin_y) / place.step_y;
  if (colours.bottom < colours.top) {
    std::swap(colours.top, colours.bottom);
    turn_over(colours);
  }
  if (colours.right <= 0.0 || colours.bottom <= 0.0 || colours.left >= map.columns - 1.0 ||
      colours.top >= map.rows - 1.0) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected a picture over the height map, found one that covers {:.0f} ... {:.0f} "
                    "of its {} columns and {:.0f} ... {:.0f} of its {} rows",
                    path.string(), colours.left, colours.right, map.columns, colours.top, colours.bottom,
                    map.rows),
        "give a picture of the same ground, or one without a georeference to have it stretched");
  }
  return colours;
}

}  // namespace offing
