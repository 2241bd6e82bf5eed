// highlight_dump FILE: highlight points of small surfaces by both searches, on the device that the
// environment names. FILE: of each point, in their order, face, light, orientation, weights, normal,
// curvatures and where e_max points, its sign apart.
#include <cmath>
#include <fstream>

#include "host/highlights/search/highlight_points.h"
#include "tests/highlights/example_surfaces.h"
#include "tests/ocl/dump_program.h"

namespace {

using namespace offing;
using namespace offing::highlights;

void write_dump(const char* path) {
  const ocl::Device device = ocl::Device::open();
  HighlightFinder search(device);
  test::RandomVectors random(21);
  Lighting far{{Source::Kind::direction, random.direction()}, {}};
  Lighting near{{Source::Kind::place, 3.0 * random.direction()}, {}};
  for (int i = 0; i < 5; ++i) {
    far.lights.push_back({Source::Kind::direction, random.direction()});
    near.lights.push_back({Source::Kind::place, 4.0 * random.direction()});
  }
  std::ofstream file(path, std::ios::binary);
  const auto add = [&](double value) {
    const auto rounded = static_cast<float>(value);
    file.write(reinterpret_cast<const char*>(&rounded), sizeof(rounded));
  };
  for (const test::ExampleSurface& example : {test::bumpy_sphere(4), test::torus(31, 17, 1.0, 0.4)}) {
    const HighlightSurface surface(device, example.mesh, example.curvatures);
    for (const Lighting& lighting : {far, near}) {
      for (const SearchMethod method : {SearchMethod::zeros, SearchMethod::least_squares}) {
        for (const HighlightPoint& point : search.find(surface, lighting, method)) {
          add(point.face);
          add(point.light);
          add(point.orientation);
          for (int axis = 0; axis < 3; ++axis) {
            add(point.weights[axis]);
            add(point.normal[axis]);
            add(point.e_max[axis] * point.e_max.x);
          }
          add(point.k_max_per_m);
          add(point.k_min_per_m);
        }
      }
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  return offing::test::run_dump_program(argc, argv, write_dump);
}
