#include "host/terrain/analysis/many_viewsheds.h"

#include <array>
#include <vector>

#include "host/base/error.h"
#include "host/ocl/buffer.h"

namespace offing::terrain {
namespace {

/// What an observer sees, on its way from the device.
class SeenOnTheWay {
 public:
  explicit SeenOnTheWay(std::size_t posts) : seen_(posts) {}
  SeenOnTheWay(const SeenOnTheWay&) = delete;
  SeenOnTheWay& operator=(const SeenOnTheWay&) = delete;
  // The device writes until then.
  ~SeenOnTheWay() {
    if (!is_pending_) return;
    try {
      done_.wait();
    } catch (const Error&) {
      // What went wrong is on its way already.
    }
  }

  void begin(const ocl::Buffer<std::uint8_t>& from) {
    done_ = from.begin_read(seen_.data());
    is_pending_ = true;
  }
  std::span<std::uint8_t> end() {
    is_pending_ = false;
    done_.wait();
    return seen_;
  }

 private:
  std::vector<std::uint8_t> seen_;
  ocl::Event done_;
  bool is_pending_ = false;
};

}  // namespace

void look_from_each(const ocl::Device& device, const HeightField& field, std::span<const float> heights_m,
                    std::span<const Observer> observers, std::uint8_t outside,
                    const std::function<void(std::size_t, std::span<std::uint8_t>)>& take) {
  if (observers.empty()) return;
  std::vector<TerrainSight> sights;
  sights.reserve(observers.size());
  for (const Observer& observer : observers) {
    require_valid(observer.limits);
    sights.push_back(Viewshed::sight_from(field.grid(), heights_m, observer.parameters));
  }
  const Viewshed viewshed(device);
  ocl::Buffer<std::uint8_t> buffer(device, heights_m.size(), "viewshed");
  std::array<SeenOnTheWay, 2> turns{SeenOnTheWay(heights_m.size()), SeenOnTheWay(heights_m.size())};
  const auto begin = [&](std::size_t observer) {
    viewshed.at(field, sights[observer], buffer);
    turns[observer % 2].begin(buffer);
    device.flush();
  };
  begin(0);
  for (std::size_t i = 0; i < observers.size(); ++i) {
    if (i + 1 < observers.size()) begin(i + 1);
    const std::span<std::uint8_t> seen = turns[i % 2].end();
    mark_outside(field.grid(), heights_m, observers[i].parameters, observers[i].limits, outside, seen);
    take(i, seen);
  }
}

}  // namespace offing::terrain
