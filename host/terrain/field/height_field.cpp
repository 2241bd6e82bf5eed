#include "host/terrain/field/height_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocl/program.h"
#include "host/terrain/cast/image_rays.h"

namespace offing::terrain {
namespace {

constexpr float farthest_height_m = 1e6f;
// Rays that come from outside start where a level has about this many nodes: higher ones are hardly ever
// empty.
constexpr int nodes_at_start = 8;

struct Range {
  float lowest_m, highest_m;
};

/// Throws Error(bad_input) that names the first height that is not finite or too far.
[[noreturn]] void throw_bad_height(const PostGrid& grid, std::span<const float> heights_m) {
  const auto bad = std::find_if(heights_m.begin(), heights_m.end(),
                                [](float height_m) { return !(std::abs(height_m) <= farthest_height_m); });
  const auto place = static_cast<std::size_t>(bad - heights_m.begin());
  const auto columns = static_cast<std::size_t>(grid.columns);
  throw Error(ErrorKind::bad_input,
              fmt::format("height field: row {}, column {}: expected a height within {:g} m, found {:g}",
                          place / columns, place % columns, farthest_height_m, *bad),
              "fill the map's holes first");
}

Range range_of(const PostGrid& grid, std::span<const float> heights_m) {
  require_valid(grid);
  const auto columns = static_cast<std::size_t>(grid.columns);
  if (heights_m.size() != columns * static_cast<std::size_t>(grid.rows)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("height field: expected {} x {} heights, found {}", grid.columns, grid.rows,
                            heights_m.size()),
                "give columns and rows of the map");
  }
  // Side by side, as a compiler may not change the order of comparisons by itself.
  constexpr std::size_t lanes = 16;
  std::array<float, lanes> lowest_m, highest_m;
  std::array<std::int32_t, lanes> is_bad{};
  lowest_m.fill(heights_m[0]);
  highest_m.fill(heights_m[0]);
  const auto take = [&](std::size_t place, std::size_t lane) {
    const float height_m = heights_m[place];
    is_bad[lane] |= std::abs(height_m) <= farthest_height_m ? 0 : 1;
    lowest_m[lane] = height_m < lowest_m[lane] ? height_m : lowest_m[lane];
    highest_m[lane] = height_m > highest_m[lane] ? height_m : highest_m[lane];
  };
  const std::size_t whole = heights_m.size() / lanes * lanes;
  for (std::size_t i = 0; i < whole; i += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) take(i + lane, lane);
  }
  for (std::size_t i = whole; i < heights_m.size(); ++i) take(i, 0);
  if (std::any_of(is_bad.begin(), is_bad.end(), [](std::int32_t bad) { return bad != 0; })) {
    throw_bad_height(grid, heights_m);
  }
  return {*std::min_element(lowest_m.begin(), lowest_m.end()),
          *std::max_element(highest_m.begin(), highest_m.end())};
}

int up_rule_of(CastMethod method) {
  switch (method) {
    case CastMethod::parity:
      return TERRAIN_UP_WITH_PARENT;
    case CastMethod::paper:
      return TERRAIN_UP_ALWAYS;
    case CastMethod::pdm:
    case CastMethod::linear:
      break;
  }
  return TERRAIN_UP_NEVER;
}

int start_level(const PyramidLayout& layout) {
  int level = layout.top_level;
  while (level > 1 && std::max(layout.nodes_x(level), layout.nodes_z(level)) < nodes_at_start) --level;
  return level;
}

constexpr std::size_t up_rules = 3;

}  // namespace

struct HeightField::State {
  ocl::Device device;
  PostGrid grid;
  Range range;
  ocl::KernelTuning tuning;
  ocl::Buffer<float> heights_m;
  Pyramid pyramid;
  // Of each up rule, of hits with either kind of normals; built when they are first asked for.
  std::array<std::optional<ocl::Kernel>, up_rules> distance_kernels;
  std::array<std::array<std::optional<ocl::Kernel>, up_rules>, 2> image_kernels, ray_kernels;
  std::array<std::optional<ocl::Kernel>, 2> curved_kernels;  ///< by normals
  std::optional<ocl::Kernel> relief_kernel;
  HostRays host_rays;

  State(const ocl::Device& on, const PostGrid& posts, std::span<const float> heights)
      : device(on),
        grid(posts),
        range(range_of(posts, heights)),
        tuning(ray_tuning(on)),
        heights_m(on, heights, "heights"),
        pyramid(on, posts, heights_m) {}

  TerrainField field(CastMethod method) const {
    const PyramidLayout& layout = pyramid.layout();
    const bool uses_pyramid = method != CastMethod::linear;
    const int first_level = method == CastMethod::parity ? start_level(layout) : layout.top_level;
    return {.columns = grid.columns,
            .cells_x = grid.columns - 1,
            .cells_z = grid.rows - 1,
            .padded_x = layout.padded_x,
            .padded_z = layout.padded_z,
            .top_level = layout.top_level,
            .first_level = uses_pyramid ? first_level : 0,
            .starts_at_origin = method == CastMethod::parity ? 1 : 0,
            .highest_m = range.highest_m,
            .largest_m = std::max(std::abs(range.lowest_m), std::abs(range.highest_m)),
            .cells_per_m_x = static_cast<float>(1.0 / grid.spacing_x_m),
            .cells_per_m_z = static_cast<float>(1.0 / grid.spacing_z_m)};
  }

  ocl::Defines defines(CastMethod method) const {
    return ocl::Defines().set("LANES", tuning.lanes).set("UP_RULE", up_rule_of(method));
  }
  ocl::Defines defines(CastMethod method, HitNormals normals) const {
    ocl::Defines definitions = defines(method);
    return normals == HitNormals::smooth ? definitions.set_flag("SMOOTH_NORMALS") : definitions;
  }

  /// `relief` is what the kernel takes with RELIEF.
  template <class Record, class... Relief>
  void cast_image(std::optional<ocl::Kernel>& kernel, const ocl::Defines& definitions, const Camera& camera,
                  ocl::Buffer<Record>& records, CastMethod method, const Relief&... relief) {
    const TerrainView view = device_view(camera, grid);
    require_room("picture", pixel_count(camera), records.size());
    if (!kernel)
      kernel = ocl::Program::build(device, "terrain/quadtree_cast.cl", definitions).kernel("quadtree_cast");
    kernel->launch(image_shape(camera, tuning), heights_m, pyramid.maxima_m(), field(method), view, records,
                   relief...);
  }

  /// `bends` are what the kernel takes with IS_CURVED.
  template <class... Bends>
  void cast_rays(std::optional<ocl::Kernel>& kernel, const ocl::Defines& definitions,
                 const ocl::Buffer<TerrainRay>& from, std::size_t count, ocl::Buffer<TerrainHit>& to,
                 CastMethod method, Bends... bends) const {
    require_room("rays", count, from.size());
    require_room("hits", count, to.size());
    if (count == 0) return;
    if (!kernel) kernel = ocl::Program::build(device, "terrain/ray_cast.cl", definitions).kernel("ray_cast");
    kernel->launch(ocl::launch_shape(tuning, count), heights_m, pyramid.maxima_m(), field(method), from,
                   static_cast<int>(count), to, bends...);
  }

  std::vector<RayHit> cast_from_host(std::span<const Ray> rays, double bend_perm,
                                     const HostRays::Cast& cast) {
    for (const Ray& ray : rays) require_valid(ray, grid);
    std::vector<RayToBox> moved;
    moved.reserve(rays.size());
    for (const Ray& ray : rays)
      moved.push_back(moved_to_box(ray, grid, static_cast<double>(range.highest_m), bend_perm));
    return host_rays.cast(device, grid, moved, cast);
  }
};

HeightField::HeightField(const ocl::Device& device, const PostGrid& grid, std::span<const float> heights_m)
    : state_(std::make_unique<State>(device, grid, heights_m)) {}
HeightField::HeightField(HeightField&&) noexcept = default;
HeightField& HeightField::operator=(HeightField&&) noexcept = default;
HeightField::~HeightField() = default;

const PostGrid& HeightField::grid() const {
  return state_->grid;
}
const ocl::Buffer<float>& HeightField::heights_m() const {
  return state_->heights_m;
}
const Pyramid& HeightField::pyramid() const {
  return state_->pyramid;
}
float HeightField::lowest_m() const {
  return state_->range.lowest_m;
}
float HeightField::highest_m() const {
  return state_->range.highest_m;
}
TerrainField HeightField::device_field(CastMethod method) const {
  return state_->field(method);
}

void HeightField::cast(const Camera& camera, ocl::Buffer<float>& distances_m, CastMethod method) {
  auto& kernel = state_->distance_kernels[static_cast<std::size_t>(up_rule_of(method))];
  state_->cast_image(kernel, state_->defines(method), camera, distances_m, method);
}

void HeightField::cast(const Camera& camera, ocl::Buffer<TerrainHit>& hits, CastMethod method,
                       HitNormals normals) {
  auto& kernel =
      state_->image_kernels[static_cast<std::size_t>(normals)][static_cast<std::size_t>(up_rule_of(method))];
  state_->cast_image(kernel, state_->defines(method, normals).set_flag("WRITES_HITS"), camera, hits, method);
}

void HeightField::cast(const Camera& camera, const ReliefSurface& relief, ocl::Buffer<TerrainHit>& hits) {
  if (!relief.is_laid()) return cast(camera, hits);
  constexpr CastMethod method = CastMethod::parity;
  state_->cast_image(state_->relief_kernel,
                     state_->defines(method).set_flag("WRITES_HITS").set_flag("RELIEF"), camera, hits, method,
                     relief.params(), relief.heights_m(), relief.maxima_m());
}

void HeightField::cast(const ocl::Buffer<TerrainRay>& rays, std::size_t count, ocl::Buffer<TerrainHit>& hits,
                       CastMethod method, HitNormals normals) {
  auto& kernel =
      state_->ray_kernels[static_cast<std::size_t>(normals)][static_cast<std::size_t>(up_rule_of(method))];
  state_->cast_rays(kernel, state_->defines(method, normals), rays, count, hits, method);
}

std::vector<RayHit> HeightField::cast(std::span<const Ray> rays, CastMethod method, HitNormals normals) {
  return state_->cast_from_host(
      rays, 0.0, [&](const ocl::Buffer<TerrainRay>& some, std::size_t count, ocl::Buffer<TerrainHit>& hits) {
        cast(some, count, hits, method, normals);
      });
}

std::vector<RayHit> HeightField::cast(std::span<const Ray> rays, const EarthCurve& curve,
                                      HitNormals normals) {
  require_valid(curve);
  const auto bend_m = [&](double spacing_m) {
    return static_cast<float>(curve.bend_perm() * spacing_m * spacing_m);
  };
  const ocl::Defines definitions = state_->defines(CastMethod::parity, normals).set_flag("IS_CURVED");
  return state_->cast_from_host(
      rays, curve.bend_perm(),
      [&](const ocl::Buffer<TerrainRay>& some, std::size_t count, ocl::Buffer<TerrainHit>& hits) {
        state_->cast_rays(state_->curved_kernels[static_cast<std::size_t>(normals)], definitions, some, count,
                          hits, CastMethod::parity, bend_m(state_->grid.spacing_x_m),
                          bend_m(state_->grid.spacing_z_m));
      });
}

}  // namespace offing::terrain
