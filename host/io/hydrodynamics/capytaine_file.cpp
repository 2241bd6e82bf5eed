#include "host/io/hydrodynamics/capytaine_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/spectra/text_cursor.h"

namespace offing::hydrodynamics {
namespace {

using spectra::NetcdfArray;

constexpr const char* export_hint =
    "write it with capytaine.export_dataset(\"hull.nc\", dataset), of a dataset with radiation and "
    "diffraction "
    "of the six motions of one body";

constexpr std::array<const char*, hull_motions> dofs{"Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"};

/// The variables of a dataset, by name.
class Dataset {
 public:
  Dataset(std::span<const std::byte> bytes, std::string_view file_name,
          decltype(&spectra::read_netcdf_arrays) read_arrays)
      : name_(file_name), arrays_(read_arrays(bytes, file_name, names_)) {}

  const NetcdfArray* find(std::string_view name) const {
    const auto at = static_cast<std::size_t>(std::ranges::find(names_, name) - names_.begin());
    return arrays_[at] ? &*arrays_[at] : nullptr;
  }
  const NetcdfArray& need(std::string_view name) const {
    const NetcdfArray* array = find(name);
    if (array == nullptr) fail(fmt::format("expected the variable {} of Capytaine, found none", name));
    return *array;
  }
  /// Throws where there is more than one value, or text.
  double number(std::string_view name) const {
    const NetcdfArray& array = need(name);
    if (array.values.size() != 1) {
      fail(fmt::format("expected one number in {}, got {}", name, array.values.size()));
    }
    return array.values.front();
  }
  std::vector<double> column(std::string_view name) const {
    const NetcdfArray& array = need(name);
    if (array.dimensions.size() > 1 || array.values.empty()) {
      fail(fmt::format("expected numbers along one dimension in {}, got {} dimensions", name,
                       array.dimensions.size()));
    }
    return array.values;
  }

  /// Where the six motions stand along a dimension that this variable names.
  std::array<std::size_t, hull_motions> places_of_motions(std::string_view name) const {
    const NetcdfArray& array = need(name);
    std::array<std::size_t, hull_motions> places{};
    for (std::size_t i = 0; i < hull_motions; ++i) {
      const auto found = std::ranges::find(array.texts, dofs[i]);
      if (found == array.texts.end())
        fail(fmt::format("expected the motion {} in {}, found none", dofs[i], name));
      places[i] = static_cast<std::size_t>(found - array.texts.begin());
    }
    if (array.texts.size() > hull_motions) {
      fail(fmt::format("expected the six motions of one rigid body in {}, got {}", name, array.texts.size()));
    }
    return places;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ErrorKind::bad_input, fmt::format("{}: {}", spectra::printable_name(name_), what),
                export_hint);
  }

 private:
  inline static const std::vector<std::string> names_{"omega",
                                                      "wave_direction",
                                                      "influenced_dof",
                                                      "radiating_dof",
                                                      "complex",
                                                      "added_mass",
                                                      "radiation_damping",
                                                      "excitation_force",
                                                      "rho",
                                                      "g",
                                                      "water_depth",
                                                      "rotation_center",
                                                      "forward_speed",
                                                      "hydrostatic_stiffness"};
  std::string name_;
  std::vector<std::optional<NetcdfArray>> arrays_;
};

/// Values by their place along named axes, which a variable has in any order; others may have a length of 1.
class Axes {
 public:
  struct Axis {
    std::string_view name;
    std::size_t length;
  };

  Axes(const Dataset& data, std::string_view variable, const std::vector<Axis>& axes)
      : array_(data.need(variable)) {
    for (const Axis& axis : axes) {
      const auto found = std::ranges::find(array_.dimensions, axis.name);
      const auto at = static_cast<std::size_t>(found - array_.dimensions.begin());
      if (found == array_.dimensions.end() || array_.lengths[at] != axis.length) {
        data.fail(fmt::format(
            "expected {} along {} of length {} in {}, got {}", axis.length, axis.name, axis.length, variable,
            found == array_.dimensions.end() ? "none" : fmt::format("{}", array_.lengths[at])));
      }
      std::size_t stride = 1;
      for (std::size_t i = at + 1; i < array_.lengths.size(); ++i) stride *= array_.lengths[i];
      strides_.push_back(stride);
    }
    std::size_t product = 1;
    for (const Axis& axis : axes) product *= axis.length;
    if (array_.values.size() != product) {
      data.fail(fmt::format("expected {} values in {}, got {}", product, variable, array_.values.size()));
    }
  }

  template <class... Place>
  double at(Place... place) const {
    const std::array<std::size_t, sizeof...(Place)> places{place...};
    std::size_t index = 0;
    for (std::size_t i = 0; i < places.size(); ++i) index += places[i] * strides_[i];
    return array_.values[index];
  }

 private:
  const NetcdfArray& array_;
  std::vector<std::size_t> strides_;
};

}  // namespace

HydrodynamicFile parse_capytaine(std::span<const std::byte> bytes, std::string_view file_name,
                                 decltype(&spectra::read_netcdf_arrays) read_arrays) {
  const Dataset data(bytes, file_name, read_arrays);
  HydrodynamicTable table;
  table.name = file_name;
  table.frequencies_radps = data.column("omega");
  table.directions_rad = data.column("wave_direction");
  table.density_kgpm3 = data.number("rho");
  table.gravity_mps2 = data.number("g");
  table.depth_m = data.number("water_depth");
  if (data.find("forward_speed") != nullptr && data.number("forward_speed") != 0.0) {
    data.fail(fmt::format("expected a forward_speed of 0, got {:g} m/s", data.number("forward_speed")));
  }
  const std::vector<double> about = data.column("rotation_center");
  if (about.size() != 3)
    data.fail(fmt::format("expected x, y and z in rotation_center, got {} numbers", about.size()));
  table.about_m = {about[0], about[1], about[2]};

  const auto forces = data.places_of_motions("influenced_dof"),
             motions = data.places_of_motions("radiating_dof");
  const NetcdfArray& omega = data.need("omega");
  // Along period or wavenumber if the problems were posed so.
  const std::string_view by_frequency =
      omega.dimensions.empty() ? "omega" : std::string_view(omega.dimensions.front());
  const Axes::Axis frequency{by_frequency, table.frequencies_radps.size()};
  const Axes::Axis direction{"wave_direction", table.directions_rad.size()};
  const Axes::Axis force{"influenced_dof", hull_motions}, motion{"radiating_dof", hull_motions};

  const Axes mass(data, "added_mass", {frequency, force, motion});
  const Axes damping(data, "radiation_damping", {frequency, force, motion});
  const Axes excitation(data, "excitation_force", {frequency, direction, force, {"complex", 2}});
  const std::vector<std::string>& parts = data.need("complex").texts;
  if (parts != std::vector<std::string>{"re", "im"}) data.fail("expected re and im along complex");
  for (std::size_t k = 0; k < frequency.length; ++k) {
    HullMatrix a{}, b{};
    for (std::size_t i = 0; i < hull_motions; ++i) {
      for (std::size_t j = 0; j < hull_motions; ++j) {
        a[hull_motions * i + j] = mass.at(k, forces[i], motions[j]);
        b[hull_motions * i + j] = damping.at(k, forces[i], motions[j]);
      }
    }
    table.added_mass.push_back(a);
    table.damping.push_back(b);
    for (std::size_t d = 0; d < direction.length; ++d) {
      HullWrench x{};
      for (std::size_t i = 0; i < hull_motions; ++i)
        x[i] = {excitation.at(k, d, forces[i], std::size_t{0}),
                excitation.at(k, d, forces[i], std::size_t{1})};
      table.excitation.push_back(x);
    }
  }
  if (data.find("hydrostatic_stiffness") != nullptr) {
    const Axes stiffness(data, "hydrostatic_stiffness", {force, motion});
    HullMatrix c{};
    for (std::size_t i = 0; i < hull_motions; ++i) {
      for (std::size_t j = 0; j < hull_motions; ++j)
        c[hull_motions * i + j] = stiffness.at(forces[i], motions[j]);
    }
    table.restoring = c;
  }
  return in_hull_axes(table);
}

}  // namespace offing::hydrodynamics
