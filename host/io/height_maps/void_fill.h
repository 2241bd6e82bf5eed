#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

/// Filling of voids: of a whole map, and of rows that come in one after the other.
namespace offing::height_maps {

/// Fills voids of a height map from the posts around them, whatever their size, in time proportional to the
/// map.
///
/// heights_m [rows][columns] m, is_void [rows][columns], 1 marks a void; at least one post must be none.
/// Others keep their heights; a void's lies between the lowest and the highest of them, near its rim near the
/// rim's, in the middle of a wide void a mean of wide surroundings. Method: pull-push, a pyramid of means of
/// known posts by 2x2, from which unknown posts take a bilinear mixture of the coarser level. Gortler,
/// Grzeszczuk, Szeliski, Cohen 1996, "The Lumigraph".
void fill_voids(int columns, int rows, std::span<float> heights_m, std::span<const std::uint8_t> is_void);

/// Fills voids of rows that come in one after the other, and passes the rows on. A band of 256 rows is filled
/// at once (fill_voids()), with the row before it as one that is known, so that bands join.
class VoidBands {
 public:
  /// void_height_m is that of all voids, if given; else those before the first height become 0.
  VoidBands(int columns, std::optional<double> void_height_m,
            std::function<void(std::span<const float>, std::span<const std::uint8_t>)> take);

  /// Whole rows; is_void 1 where a height is missing.
  void add(std::span<const float> heights_m, std::span<const std::uint8_t> is_void);
  /// Passes on what is left. Call once, last.
  void finish();

  std::size_t void_posts() const { return void_posts_; }
  std::size_t posts() const { return posts_; }
  /// Of posts that are no voids; 0 without one.
  float lowest_m() const { return lowest_m_; }
  float highest_m() const { return highest_m_; }

 private:
  void note(float height_m);
  void pass_on();

  std::size_t columns_;
  std::optional<double> void_height_m_;
  std::function<void(std::span<const float>, std::span<const std::uint8_t>)> take_;
  std::vector<float> heights_m_;       ///< the row before the band, if there is one, and the band
  std::vector<std::uint8_t> is_void_;  ///< the same; the row before counts as known
  std::size_t first_ = 0;              ///< row of the band's first, 0 or 1
  std::size_t posts_ = 0, void_posts_ = 0, band_voids_ = 0;
  float lowest_m_ = 0.0f, highest_m_ = 0.0f;
};

}  // namespace offing::height_maps
