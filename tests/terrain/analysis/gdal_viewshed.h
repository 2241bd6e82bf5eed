#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "host/base/height_map.h"
#include "host/terrain/analysis/viewshed.h"

namespace offing::test {

/// GDAL's viewshed, an approximate sweep over the posts, of one map: its heights as they are, voids filled.
class GdalViewshed {
 public:
  explicit GdalViewshed(const offing::HeightMap& map);

  /// [rows][columns], 255 seen and 0 not; the observer is at a post.
  std::vector<std::uint8_t> at(const terrain::ViewshedParameters& parameters) const;

 private:
  struct CloseDataset {
    void operator()(void* dataset) const;
  };
  std::unique_ptr<void, CloseDataset> heights_;
  int columns_, rows_;
};

}  // namespace offing::test
