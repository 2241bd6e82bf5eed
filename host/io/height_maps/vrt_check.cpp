// What a VRT may hold: rasters that are joined, and nothing that reads or runs anything else.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include <cpl_minixml.h>
#include <cpl_string.h>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/height_maps/raster_file.h"
#include "host/io/whole_file.h"

namespace offing::height_maps {
namespace {

namespace fs = std::filesystem;

// What gdalbuildvrt and gdal_translate write. Of these, SourceFilename alone names a file.
constexpr std::array<std::string_view, 48> known_elements{"VRTDataset",
                                                          "SRS",
                                                          "GeoTransform",
                                                          "Metadata",
                                                          "MDI",
                                                          "BlockXSize",
                                                          "BlockYSize",
                                                          "VRTRasterBand",
                                                          "MaskBand",
                                                          "OverviewList",
                                                          "Description",
                                                          "UnitType",
                                                          "Offset",
                                                          "Scale",
                                                          "CategoryNames",
                                                          "Category",
                                                          "ColorTable",
                                                          "Entry",
                                                          "NoDataValue",
                                                          "HideNoDataValue",
                                                          "ColorInterp",
                                                          "Histograms",
                                                          "HistItem",
                                                          "HistMin",
                                                          "HistMax",
                                                          "BucketCount",
                                                          "HistCounts",
                                                          "Approximate",
                                                          "IncludeOutOfRange",
                                                          "SimpleSource",
                                                          "ComplexSource",
                                                          "SourceBand",
                                                          "SrcRect",
                                                          "SourceProperties",
                                                          "SourceFilename",
                                                          "AveragedSource",
                                                          "DstRect",
                                                          "NODATA",
                                                          "ScaleOffset",
                                                          "ScaleRatio",
                                                          "SrcMin",
                                                          "SrcMax",
                                                          "DstMin",
                                                          "DstMax",
                                                          "Exponent",
                                                          "LUT",
                                                          "UseMaskBand",
                                                          "ColorTableComponent"};

constexpr int most_vrts = 8;     // in one another
constexpr int most_levels = 16;  // of elements
constexpr std::size_t most_bytes = std::size_t{256} << 20;

class VrtCheck {
 public:
  VrtCheck(fs::path path, Trust trust, CheckedRasters& checked, int depth)
      : path_(std::move(path)), trust_(trust), checked_(checked), depth_(depth) {}

  int run() {
    require_depth(1);
    const std::string text = read_whole_file(path_, {.kind = "a VRT", .most_bytes = most_bytes});
    const std::unique_ptr<CPLXMLNode, void (*)(CPLXMLNode*)> root(CPLParseXMLString(text.c_str()),
                                                                  CPLDestroyXMLNode);
    if (!root) refuse("expected a VRT, found XML that cannot be read");
    for (const CPLXMLNode* node = root.get(); node != nullptr; node = node->psNext) check_node(*node, 0);
    return nested_ + 1;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(ErrorKind::bad_input, fmt::format("{}: {}", one_line(path_.string()), what),
                "convert it to a GeoTIFF: gdal_translate MAP.vrt MAP.tif");
  }

  void require_depth(int nested) const {
    if (depth_ + nested > most_vrts)
      refuse(fmt::format("expected at most {} nested VRTs, found more", most_vrts));
  }

  // GDAL takes names of any case, and attributes for elements.
  void check_node(const CPLXMLNode& node, int level) {
    if (node.eType != CXT_Element && node.eType != CXT_Attribute) return;
    const std::string_view name = node.pszValue;
    if (EQUAL(node.pszValue, "SourceFilename")) return check_source(node);
    if (EQUAL(node.pszValue, "subClass"))
      return refuse("expected a VRT that only joins rasters, found another kind of VRT");
    if (node.eType != CXT_Element || name.starts_with('?')) return;
    if (level > most_levels || std::ranges::find(known_elements, name) == known_elements.end()) {
      refuse(fmt::format("expected a VRT that only joins rasters, found an element {}", printable(name)));
    }
    const std::string_view domain = CPLGetXMLValue(&node, "domain", "");
    if (name == "Metadata" && !domain.empty() && domain != "IMAGE_STRUCTURE") {
      refuse(fmt::format("expected a VRT that only joins rasters, found metadata of the domain {}",
                         printable(domain)));
    }
    for (const CPLXMLNode* child = node.psChild; child != nullptr; child = child->psNext) {
      check_node(*child, level + 1);
    }
  }

  void check_source(const CPLXMLNode& node) {
    const std::string name = CPLGetXMLValue(&node, nullptr, "");
    const bool is_relative = std::atoi(CPLGetXMLValue(&node, "relativeToVRT", "0")) != 0;
    const fs::path source = is_relative ? path_.parent_path() / name : fs::path(name);
    std::error_code status;
    if (is_address(name) || !fs::is_regular_file(source, status)) {
      refuse(fmt::format("expected sources that are files on this machine, found {}", printable(name)));
    }
    require_beside(path_, source, trust_);
    // A file may be the source of many: by its name in its true folder, where GDAL looks for masks.
    const auto [known, is_new] =
        checked_.try_emplace(fs::canonical(source.parent_path()) / source.filename());
    if (is_new) known->second = check_raster(source, trust_, checked_, depth_ + 1);
    if (!known->second)
      refuse(fmt::format("expected nested VRTs that end, found {} in itself", printable(name)));
    nested_ = std::max(nested_, *known->second);
    require_depth(1 + nested_);
  }

  fs::path path_;
  Trust trust_;
  CheckedRasters& checked_;
  int depth_;       // how many VRTs lead here
  int nested_ = 0;  // how many are in one another below
};

}  // namespace

int check_vrt(const fs::path& path, Trust trust, CheckedRasters& checked, int depth) {
  return VrtCheck(fs::canonical(path), trust, checked, depth).run();
}

}  // namespace offing::height_maps
