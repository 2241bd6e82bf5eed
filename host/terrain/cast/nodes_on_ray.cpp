#include "host/terrain/cast/nodes_on_ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace offing::terrain {
namespace {

/// A part of a ray, in metres along it; empty where begin is not below end.
struct Interval {
  double begin_m = 0.0, end_m = std::numeric_limits<double>::infinity();
  bool is_empty() const { return !(begin_m < end_m); }
};

/// The part in which a coordinate that starts at `from` and changes by `rate` a metre is within [low, high].
Interval within(Interval part, double from, double rate, double low, double high) {
  if (rate == 0.0) return from >= low && from <= high ? part : Interval{0.0, 0.0};
  const double first = (low - from) / rate, second = (high - from) / rate;
  return {std::max(part.begin_m, std::min(first, second)), std::min(part.end_m, std::max(first, second))};
}

class Descent {
 public:
  Descent(const HeightField& field, const Ray& ray, double distance_m)
      : grid_(field.grid()),
        layout_(field.pyramid().layout()),
        maxima_m_(field.pyramid().maxima_m().read()),
        heights_m_(field.heights_m().read()),
        ray_(ray),
        distance_m_(distance_m) {}

  std::vector<RayNode> run() {
    const int top = layout_.top_level;
    struct Root {
      int x, z;
      double begin_m;
    };
    std::vector<Root> roots;
    for (int z = 0; z < layout_.nodes_z(top); ++z) {
      for (int x = 0; x < layout_.nodes_x(top); ++x) {
        const Interval part = part_over(x << top, z << top, 1 << top);
        if (!part.is_empty()) roots.push_back({x, z, part.begin_m});
      }
    }
    std::sort(roots.begin(), roots.end(), [](const Root& a, const Root& b) { return a.begin_m < b.begin_m; });
    for (const Root& root : roots) visit(top, root.x, root.z);
    return std::move(nodes_);
  }

 private:
  /// Of the ray up to its end, above a square of cells.
  Interval part_over(int first_x, int first_z, int side_cells) const {
    const double left_m = grid_.origin_x_m + first_x * grid_.spacing_x_m,
                 top_m = grid_.origin_z_m + first_z * grid_.spacing_z_m;
    Interval part{0.0, distance_m_};
    part = within(part, ray_.origin_m.x, ray_.direction.x, left_m, left_m + side_cells * grid_.spacing_x_m);
    return within(part, ray_.origin_m.z, ray_.direction.z, top_m, top_m + side_cells * grid_.spacing_z_m);
  }

  float post_m(int column, int row) const {
    return heights_m_[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) +
                      static_cast<std::size_t>(column)];
  }

  float maximum_m(int level, int x, int z) const {
    if (level == 0) return std::max({post_m(x, z), post_m(x + 1, z), post_m(x, z + 1), post_m(x + 1, z + 1)});
    return maxima_m_[layout_.begin(level) +
                     static_cast<std::size_t>(z) * static_cast<std::size_t>(layout_.nodes_x(level)) +
                     static_cast<std::size_t>(x)];
  }

  void visit(int level, int x, int z) {
    const int first_x = x << level, first_z = z << level;
    if (first_x >= grid_.columns - 1 || first_z >= grid_.rows - 1) return;  // padding
    const Interval part = part_over(first_x, first_z, 1 << level);
    if (part.is_empty()) return;
    const auto height_m = [&](double t_m) { return ray_.origin_m.y + t_m * ray_.direction.y; };
    const float maximum = maximum_m(level, x, z);
    const bool is_passed_over = std::min(height_m(part.begin_m), height_m(part.end_m)) > maximum;
    nodes_.push_back({level, first_x, first_z, 1 << level, maximum, is_passed_over});
    if (is_passed_over || level == 0) return;
    // Front to back.
    std::array<std::array<int, 2>, 4> children{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};
    const int side = 1 << (level - 1);
    std::sort(children.begin(), children.end(), [&](const auto& a, const auto& b) {
      return part_over(first_x + a[0] * side, first_z + a[1] * side, side).begin_m <
             part_over(first_x + b[0] * side, first_z + b[1] * side, side).begin_m;
    });
    for (const auto& [right, down] : children) visit(level - 1, 2 * x + right, 2 * z + down);
  }

  PostGrid grid_;
  PyramidLayout layout_;
  std::vector<float> maxima_m_, heights_m_;
  Ray ray_;
  double distance_m_;
  std::vector<RayNode> nodes_;
};

}  // namespace

std::vector<RayNode> nodes_on_ray(const HeightField& field, const Ray& ray, double distance_m) {
  return Descent(field, ray, distance_m).run();
}

}  // namespace offing::terrain
