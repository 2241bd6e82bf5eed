#include "host/io/height_maps/read_colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_utils.h>

#include "host/base/error.h"
#include "host/io/height_maps/gdal_session.h"
#include "host/io/height_maps/readable_file.h"

namespace offing {
namespace {

using height_maps::Dataset;
using height_maps::GdalSession;
using height_maps::SpatialReference;

constexpr double most_pixels = 268'435'456.0;
using Corner = std::array<double, 6>;

class Picture {
 public:
  explicit Picture(const std::filesystem::path& path) : path_(path) {
    height_maps::require_readable_file(path, "a picture");
    dataset_.reset(GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                              nullptr, nullptr, nullptr));
    if (!dataset_) {
      refuse(fmt::format("expected a picture, found what cannot be opened as one: {}", session_.failure()),
             "give a GeoTIFF or a PNG; a file that is cut short must be copied again");
    }
    if (bands() == 0) refuse("expected a picture, found none in it", "name one of its pictures as a file");
    require_size();
    if (GDALGetRasterColorTable(band(1)) != nullptr) {
      take(GDALTranslate("", dataset_.get(), translation({"-of", "MEM", "-expand", "rgba"}).get(), nullptr));
    }
    const GDALDataType type = GDALGetRasterDataType(band(1));
    if (type != GDT_Byte && type != GDT_UInt16) {
      refuse(fmt::format("expected colours of 8 or 16 bits, found {}", GDALGetDataTypeName(type)),
             "if these are heights, give them as FILE");
    }
  }

  int columns() const { return GDALGetRasterXSize(dataset_.get()); }
  int rows() const { return GDALGetRasterYSize(dataset_.get()); }

  /// Where it says that it lies; nothing where it does not.
  std::optional<Corner> corner() const {
    Corner corner{};
    if (GDALGetGeoTransform(dataset_.get(), corner.data()) != CE_None) return std::nullopt;
    if (corner[2] != 0.0 || corner[4] != 0.0 || !std::isnormal(corner[1]) || !std::isnormal(corner[5]) ||
        corner[1] < 0.0) {
      refuse("expected columns toward the east and rows along the meridian, found a rotated picture",
             "make a north-up one of it with gdalwarp");
    }
    return corner;
  }

  /// Resamples it to the coordinate system, where it names another.
  void bring_into(const std::string& coordinate_system) {
    const SpatialReference wanted = height_maps::spatial_reference(coordinate_system);
    const OGRSpatialReferenceH own = GDALGetSpatialRef(dataset_.get());
    if (!wanted || own == nullptr || OSRIsSame(wanted.get(), own) != 0) return;
    char** words = nullptr;
    for (const char* const word : {"-of", "MEM", "-r", "bilinear", "-dstalpha", "-t_srs"}) {
      words = CSLAddString(words, word);
    }
    words = CSLAddString(words, coordinate_system.c_str());
    GDALWarpAppOptions* const options = GDALWarpAppOptionsNew(words, nullptr);
    CSLDestroy(words);
    GDALDatasetH source = dataset_.get();
    Dataset warped(GDALWarp("", nullptr, 1, &source, options, nullptr));
    GDALWarpAppOptionsFree(options);
    take(warped.release());
    require_size();
  }

  std::vector<std::uint8_t> read_rgba() const {
    const int colours = bands() >= 3 ? 3 : 1;
    const auto pixels = static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows());
    std::vector<std::uint8_t> rgba(4 * pixels);
    for (int channel = 0; channel < 3; ++channel) {
      read(band(colours == 3 ? channel + 1 : 1), rgba.data() + channel);
    }
    read(GDALGetMaskBand(band(1)), rgba.data() + 3);
    return rgba;
  }

 private:
  struct FreeTranslation {
    void operator()(GDALTranslateOptions* options) const { GDALTranslateOptionsFree(options); }
  };
  static std::unique_ptr<GDALTranslateOptions, FreeTranslation> translation(
      std::initializer_list<const char*> words) {
    char** list = nullptr;
    for (const char* const word : words) list = CSLAddString(list, word);
    std::unique_ptr<GDALTranslateOptions, FreeTranslation> options(GDALTranslateOptionsNew(list, nullptr));
    CSLDestroy(list);
    return options;
  }

  [[noreturn]] void refuse(const std::string& what, const char* hint) const {
    throw Error(ErrorKind::bad_input, fmt::format("{}: {}", path_.string(), what), hint);
  }
  void require_size() const {
    const double pixels = static_cast<double>(columns()) * rows();
    if (pixels <= most_pixels) return;
    refuse(fmt::format("expected at most {:.0f} pixels, found {} x {}", most_pixels, columns(), rows()),
           "cut out a part or make it coarser, as with gdal_translate -srcwin or -outsize");
  }
  int bands() const { return GDALGetRasterCount(dataset_.get()); }
  GDALRasterBandH band(int number) const { return GDALGetRasterBand(dataset_.get(), number); }

  void take(GDALDatasetH made) {
    if (made == nullptr) {
      refuse(fmt::format("cannot be brought into red, green and blue over the map: {}", session_.failure()),
             "convert it first, with gdalwarp or gdal_translate -expand rgb");
    }
    dataset_.reset(made);
  }

  /// Bytes of a band to every fourth byte from `target` on.
  void read(GDALRasterBandH band, std::uint8_t* target) const {
    const bool is_wide = GDALGetRasterDataType(band) == GDT_UInt16;
    std::vector<std::uint16_t> row(static_cast<std::size_t>(columns()));
    for (int r = 0; r < rows(); ++r) {
      if (GDALRasterIO(band, GF_Read, 0, r, columns(), 1, row.data(), columns(), 1, GDT_UInt16, 0, 0) !=
          CE_None) {
        refuse(fmt::format("expected {} rows, found none that can be read from row {} on: {}", rows(), r,
                           session_.failure()),
               "the file is cut short or damaged: copy or download it again");
      }
      for (const std::uint16_t value : row) {
        *target = static_cast<std::uint8_t>(is_wide ? (value + 128) / 257 : value);
        target += 4;
      }
    }
  }

  std::filesystem::path path_;
  GdalSession session_;
  Dataset dataset_;
};

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

ColourMap read_colour_map(const std::filesystem::path& path, const HeightMap& map) {
  Picture picture(path);
  const Georeference& place = map.georeference;
  std::optional<Corner> corner = picture.corner();
  if (corner && place.step_x != 0.0 && !place.coordinate_system.empty()) {
    picture.bring_into(place.coordinate_system);
    corner = picture.corner();
  }
  ColourMap colours{.columns = picture.columns(),
                    .rows = picture.rows(),
                    .rgba = picture.read_rgba(),
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
