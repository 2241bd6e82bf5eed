#include "host/terrain/generate/row_makers.h"

#include <algorithm>
#include <thread>

namespace offing::terrain {

RowMakers::RowMakers(const FractalParameters& parameters)
    : posts_(parameters.posts),
      makers_(std::max(1u, std::thread::hardware_concurrency()), FractalTerrain(parameters)),
      heights_m_(static_cast<std::size_t>(rows_at_once()) * static_cast<std::size_t>(posts_)) {}

std::span<const float> RowMakers::make(int first) {
  const auto posts = static_cast<std::size_t>(posts_);
  const int rows = std::min(rows_at_once(), posts_ - first);
  {
    std::vector<std::jthread> threads;
    for (int begin = 0; begin < rows; begin += rows_a_maker) {
      threads.emplace_back([this, posts, first, begin, end = std::min(begin + rows_a_maker, rows)] {
        FractalTerrain& maker = makers_[static_cast<std::size_t>(begin / rows_a_maker)];
        for (int row = begin; row < end; ++row) {
          maker.fill_row(first + row,
                         std::span(heights_m_).subspan(static_cast<std::size_t>(row) * posts, posts));
        }
      });
    }
  }
  return std::span(heights_m_).first(static_cast<std::size_t>(rows) * posts);
}

}  // namespace offing::terrain
