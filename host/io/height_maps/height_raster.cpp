#include "host/io/height_maps/height_raster.h"

#include "host/io/atomic_file.h"
#include "host/io/height_maps/new_raster.h"

namespace offing {
namespace {

// Made ground has a scale, but no place.
constexpr const char* local_metres = R"(LOCAL_CS["made ground",UNIT["metre",1]])";

}  // namespace

struct HeightRasterWriter::State {
  std::filesystem::path path;
  AtomicFile file;
  height_maps::GdalSession session;
  int columns, next_row = 0;
  height_maps::Dataset dataset;

  State(const std::filesystem::path& of, int columns_of, int rows, double spacing_m, Existing existing)
      : path(of),
        file(of, existing),
        columns(columns_of),
        dataset(height_maps::create_raster(
            {.name = of,
             .temporary = file.temporary(),
             .columns = columns_of,
             .rows = rows,
             .type = GDT_Float32,
             .georeference = {local_metres, 0.0, spacing_m * (rows - 1), spacing_m, -spacing_m},
             .options = {"BIGTIFF=IF_SAFER"}},
            session)) {}
};

HeightRasterWriter::HeightRasterWriter(const std::filesystem::path& path, int columns, int rows,
                                       double spacing_m, Existing existing)
    : state_(std::make_unique<State>(path, columns, rows, spacing_m, existing)) {}
HeightRasterWriter::~HeightRasterWriter() = default;

void HeightRasterWriter::add_rows(std::span<const float> heights_m) {
  const int rows = static_cast<int>(heights_m.size() / static_cast<std::size_t>(state_->columns));
  // GDAL takes what it only reads without const.
  auto* const values = const_cast<float*>(heights_m.data());
  if (GDALRasterIO(GDALGetRasterBand(state_->dataset.get(), 1), GF_Write, 0, state_->next_row,
                   state_->columns, rows, values, state_->columns, rows, GDT_Float32, 0, 0) != CE_None) {
    height_maps::fail_to_write(state_->path, state_->session);
  }
  state_->next_row += rows;
}

void HeightRasterWriter::commit() {
  GDALFlushCache(state_->dataset.get());
  state_->dataset.reset();
  if (state_->session.has_failed()) height_maps::fail_to_write(state_->path, state_->session);
  state_->file.commit();
}

}  // namespace offing
