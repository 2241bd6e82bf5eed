#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "host/io/png_image.h"

namespace offing::cli {

struct Point {
  double x = 0, y = 0;  ///< pixels from the upper left corner
};

/// Where a text's anchor lies in its box.
enum class Align { left, center, right };

/// A white picture to draw lines and text on. Colours are display values 0 ... 1.
class PlotCanvas {
 public:
  /// Throws Error(out_of_memory) if the picture cannot be made.
  PlotCanvas(int width, int height);
  ~PlotCanvas();

  void line(const std::vector<Point>& points, glm::vec3 colour, double width_px);
  void polygon(const std::vector<Point>& points, glm::vec3 colour);
  void circle(Point center, double radius_px, glm::vec3 colour, double width_px);
  void pixel(int column, int row, glm::vec3 colour);
  /// Text with its vertical middle at `anchor`.
  void text(Point anchor, const std::string& words, double size_px, Align align,
            glm::vec3 colour = {0.15f, 0.15f, 0.15f});
  /// The same, reading upward.
  void upward_text(Point anchor, const std::string& words, double size_px);

  RgbImage image() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Round numbers (1, 2 or 5 times a power of ten apart) from 0 to `end`, about `count` of them; `end` > 0.
std::vector<double> round_ticks(double end, int count);

}  // namespace offing::cli
