#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace offing::terrain {

/// Gullies of one width that water has cut downhill: phasor noise (Tricard et al. 2019, Procedural phasor
/// noise), waves in seeded spots whose sum has its phase taken, so that all cuts are as deep, with crests
/// along the slope of the ground that is there before.
class Gullies {
 public:
  /// What the cut adds to the ground.
  struct Cut {
    double height_m = 0.0;                ///< 0 or below
    double slope_x = 0.0, slope_z = 0.0;  ///< metres a metre, across the gully
  };

  /// `index` tells gullies of one ground apart. depth: of a cut in steep ground, over the width.
  Gullies(double width_m, double depth, double side_m, std::uint64_t seed, int index);

  /// Takes the seeded spots of the rows around z_m; before at(). Rows in order are quickest.
  void move_to(double z_m);
  /// At (x_m, z_m) with the z of move_to(), in ground of these slopes. Level ground has no gullies.
  Cut at(double x_m, double z_m, double slope_x, double slope_z) const;

 private:
  struct Spot {
    double x, z;  ///< in widths of a spot's cell
  };
  /// Cells a gully's width: a spot spans several gullies.
  static constexpr double cells_a_width = 0.5;

  std::vector<Spot> row_of_spots(int row) const;

  double width_m_, depth_;
  int columns_;
  std::uint64_t seed_;
  int index_;
  int top_;                                ///< row of rows_[0]
  std::array<std::vector<Spot>, 3> rows_;  ///< of cells -1 ... columns
};

}  // namespace offing::terrain
