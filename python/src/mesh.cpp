// Meshes: files, arrays and curvatures.
#include <cstdint>
#include <string>

#include "handles.h"
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>

using namespace nb::literals;

namespace {

using Triangles = nb::ndarray<const std::uint32_t, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

class Mesh {
 public:
  static Mesh open(const std::filesystem::path& file, bool untrusted) {
    const OffingMeshOptions options{sizeof options, untrusted ? 1 : 0};
    OffingMesh* mesh = nullptr;
    run([&] { return offing_open_mesh(file.c_str(), &options, &mesh); });
    return Mesh(mesh);
  }
  static Mesh make(const Rows<3>& vertices_m, const Triangles& triangles) {
    OffingMesh* mesh = nullptr;
    run([&] {
      return offing_make_mesh(vertices_m.data(), vertices_m.shape(0), triangles.data(), triangles.shape(0),
                              &mesh);
    });
    return Mesh(mesh);
  }

  nb::dict info() const {
    const OffingMeshInfo found = read_info();
    nb::dict values;
    values["vertices"] = found.vertex_count;
    values["triangles"] = found.triangle_count;
    values["lowest_m"] = copied(found.lowest_m, {3});
    values["highest_m"] = copied(found.highest_m, {3});
    values["format"] = str_of(found.format);
    return values;
  }
  /// (vertices, triangles)
  nb::tuple read() const {
    const OffingMeshInfo found = read_info();
    auto vertices = new_array<double>({found.vertex_count, 3});
    auto triangles = new_array<std::uint32_t>({found.triangle_count, 3});
    run([&] {
      return offing_read_mesh(mesh_.get(), vertices.data(), found.vertex_count, triangles.data(),
                              found.triangle_count);
    });
    return nb::make_tuple(vertices, triangles);
  }
  /// (k_max, k_min, e_max, e_min, normal, area, confidence)
  nb::tuple curvature(const Device& device, int rounds) const {
    // Which offing.h takes for its default.
    if (rounds == 0) throw nb::value_error("rounds: expected 1 ... 1000, got 0");
    const std::size_t count = read_info().vertex_count;
    auto k_max = new_array<double>({count}), k_min = new_array<double>({count}),
         area = new_array<double>({count}), confidence = new_array<double>({count}),
         e_max = new_array<double>({count, 3}), e_min = new_array<double>({count, 3}),
         normal = new_array<double>({count, 3});
    const OffingCurvatureOptions options{sizeof options, rounds};
    const OffingCurvatures curvatures{sizeof curvatures, k_max.data(),  k_min.data(), e_max.data(),
                                      e_min.data(),      normal.data(), area.data(),  confidence.data()};
    run([&] { return offing_compute_curvatures(device.get(), mesh_.get(), &options, count, &curvatures); });
    return nb::make_tuple(k_max, k_min, e_max, e_min, normal, area, confidence);
  }
  void save(const std::filesystem::path& file, bool replace) const {
    run([&] { return offing_save_mesh(mesh_.get(), file.c_str(), replace ? 1 : 0); });
  }

 private:
  explicit Mesh(OffingMesh* mesh) : mesh_(mesh) {}

  OffingMeshInfo read_info() const {
    OffingMeshInfo found{};
    found.size = sizeof found;
    run([&] { return offing_get_mesh_info(mesh_.get(), &found); });
    return found;
  }

  Owned<OffingMesh, offing_free_mesh> mesh_;
};

}  // namespace

void bind_mesh(nb::module_& module) {
  nb::class_<Mesh>(module, "Mesh")
      .def_static("open", &Mesh::open, "file"_a, "untrusted"_a)
      .def_static("make", &Mesh::make, "vertices_m"_a, "triangles"_a)
      .def("info", &Mesh::info)
      .def("read", &Mesh::read)
      .def("curvature", &Mesh::curvature, "device"_a, "rounds"_a)
      .def("save", &Mesh::save, "file"_a, "replace"_a);
}
