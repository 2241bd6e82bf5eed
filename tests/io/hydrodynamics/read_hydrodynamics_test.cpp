// Data bases of a box by Capytaine 3.0 (make_box.py), as NetCDF and as WAMIT's files: against each other,
// against our own panel method, and damaged.
#include "host/io/hydrodynamics/read_hydrodynamics.h"

#include <cmath>
#include <complex>
#include <fstream>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/bodies/panel_method.h"
#include "host/io/hydrodynamics/capytaine_file.h"
#include "host/io/whole_file.h"
#include "tests/bodies/example_bodies.h"
#include "tests/io/spectra/netcdf_writer.h"
#include "tests/io/temporary_folder.h"

namespace offing::hydrodynamics {
namespace {

using std::numbers::pi;
const std::string box = OFFING_BOX;

std::string text_of(const std::string& path) {
  return read_whole_file(path, {.kind = "a file", .most_bytes = 1u << 20});
}

void expect_same(const HullMatrix& a, const HullMatrix& b, double tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double own = std::sqrt(std::abs(a[7 * (i / 6)] * a[7 * (i % 6)]));
    EXPECT_NEAR(a[i], b[i], tolerance * own) << i / 6 << "," << i % 6;
  }
}

double largest(const HydrodynamicData& data, std::size_t motion) {
  double most = 0.0;
  for (const HullWrench& wrench : data.excitation) most = std::max(most, std::abs(wrench[motion]));
  return most;
}

/// The box of make_box.py in the axes of hulls, its water line at y = 0.
TriangleMesh mesh_of_box() {
  TriangleMesh mesh = test::box({4.0, 2.0, 2.0});
  for (glm::dvec3& place : mesh.positions_m) place += glm::dvec3(0.5, -0.2, -0.2);
  return mesh;
}

// WAMIT's files have e^(+i omega t), other units, other order, seven digits, and moments about the origin,
// Capytaine's about its centre of rotation; Capytaine writes its own numbers into the former. So forces along
// the axes agree, and moments do once they are moved. Fails if a sign, a scale, a row or a direction is
// wrong.
TEST(ReadHydrodynamicsTest, WamitAndCapytaineAgree) {
  const HydrodynamicFile a = read_hydrodynamics(box + ".nc"), b = read_hydrodynamics(box + ".1");
  EXPECT_EQ(a.data.about_m, glm::dvec3(0.3, -0.4, 0.0));
  ASSERT_EQ(a.data.frequencies_radps.size(), 3u);
  ASSERT_EQ(a.data.directions_rad.size(), 3u);
  EXPECT_TRUE(a.has_infinite_frequency && b.has_infinite_frequency);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(b.data.frequencies_radps[k], a.data.frequencies_radps[k], 1e-5);
    EXPECT_NEAR(b.data.directions_rad[k], a.data.directions_rad[k], 1e-6);
    expect_same(a.data.added_mass[k], b.data.added_mass[k], 1e-5);
    expect_same(a.data.damping[k], b.data.damping[k], 1e-5);
  }
  EXPECT_NEAR(a.data.directions_rad.front(), -40.0 * pi / 180.0, 1e-9);
  expect_same(a.data.added_mass_at_infinity, b.data.added_mass_at_infinity, 1e-5);
  ASSERT_EQ(a.data.excitation.size(), b.data.excitation.size());
  for (std::size_t i = 0; i < a.data.excitation.size(); ++i) {
    for (std::size_t m = 0; m < hull_motions; ++m)
      EXPECT_LT(std::abs(a.data.excitation[i][m] - b.data.excitation[i][m]), 1e-5 * largest(a.data, m));
  }
  // rho g times the water plane.
  EXPECT_NEAR((*a.restoring)[7] / (1025.0 * 9.81 * 8.0), 1.0, 1e-6);
}

// Another program's numbers for the same hull, all six motions and three directions. Fails if an axis or the
// sign of time is wrong: those turn elements round, by up to twice their size. Off by up to MEASURED % of the
// largest for 250 panels each; limit 10 %.
TEST(ReadHydrodynamicsTest, AgreesWithOurPanelMethod) {
  const HydrodynamicData data = read_hydrodynamics(box + ".nc").data;
  const HydrodynamicData own = bodies::panel_method(mesh_of_box(), 0.0, data.about_m, 1025.0, 9.81);
  double worst = 0.0;
  const auto compare = [&](const HullMatrix& a, const HullMatrix& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double scale = std::sqrt(std::abs(a[7 * (i / 6)] * a[7 * (i % 6)]));
      worst = std::max(worst, std::abs(a[i] - b[i]) / scale);
      EXPECT_NEAR(a[i], b[i], 0.18 * scale) << i / 6 << "," << i % 6;
    }
  };
  compare(data.added_mass_at_infinity, own.added_mass_at_infinity);
  for (std::size_t k = 0; k < data.frequencies_radps.size(); ++k) {
    const double frequency = data.frequencies_radps[k];
    compare(data.added_mass[k], bodies::added_mass_at(own, frequency));
    compare(data.damping[k], bodies::damping_at(own, frequency));
    for (std::size_t d = 0; d < data.directions_rad.size(); ++d) {
      const HullWrench x = bodies::excitation_at(own, frequency, data.directions_rad[d]);
      for (std::size_t m = 0; m < hull_motions; ++m) {
        const double off = std::abs(data.excitation[3 * k + d][m] - x[m]) / largest(data, m);
        worst = std::max(worst, off);
        EXPECT_LT(off, 0.18) << frequency << " " << d << " " << m;
      }
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

/// A data base of a symmetric hull over waves from 0 to 180 degrees, small and exact, as Capytaine names it.
test::TestNetcdf small_file() {
  const std::size_t frequencies = 2, directions = 3;
  test::TestNetcdf file;
  file.dimensions = {
      {"omega", frequencies}, {"wave_direction", directions}, {"influenced_dof", 6}, {"radiating_dof", 6},
      {"complex", 2},         {"space_coordinate", 3},        {"length", 5},         {"short", 2}};
  const auto numbers = [&](const char* name, std::vector<std::string> dimensions,
                           std::vector<double> values) {
    file.variables.push_back(
        {.name = name, .dimensions = std::move(dimensions), .values = std::move(values)});
  };
  numbers("omega", {"omega"}, {2.0, 1.0});
  numbers("wave_direction", {"wave_direction"}, {0.0, 0.5 * pi, pi});
  numbers("rho", {}, {1000.0});
  numbers("g", {}, {9.8});
  numbers("water_depth", {}, {std::numeric_limits<double>::infinity()});
  numbers("rotation_center", {"space_coordinate"}, {1.0, 2.0, -3.0});
  std::vector<double> matrices, excitation(2 * frequencies * directions * 6, 0.0);
  for (std::size_t k = 0; k < frequencies; ++k) {
    for (std::size_t i = 0; i < 36; ++i)
      matrices.push_back(i % 7 == 0 ? 10.0 * static_cast<double>(i + 1 + k) : 0.0);
  }
  for (std::size_t i = 0; i < excitation.size(); ++i) excitation[i] = static_cast<double>(i);
  numbers("added_mass", {"omega", "influenced_dof", "radiating_dof"}, matrices);
  numbers("radiation_damping", {"omega", "influenced_dof", "radiating_dof"}, matrices);
  numbers("excitation_force", {"complex", "omega", "wave_direction", "influenced_dof"}, excitation);
  for (const char* name : {"influenced_dof", "radiating_dof"}) {
    file.variables.push_back({.name = name,
                              .dimensions = {name, "length"},
                              .text = std::string("SurgeSway HeaveRoll PitchYaw  ", 30)});
  }
  file.variables.push_back({.name = "complex", .dimensions = {"complex", "short"}, .text = "reim"});
  return file;
}

HydrodynamicFile parsed(const test::TestNetcdf& file) {
  const std::string bytes = test::netcdf_bytes(file);
  return parse_capytaine(std::as_bytes(std::span(bytes)), "hull.nc", spectra::read_netcdf_arrays);
}

// Classic NetCDF, whose texts are characters, frequencies that fall, and waves of one side. Fails if rows are
// not sorted, or images have the wrong signs.
TEST(ReadHydrodynamicsTest, SortsAndMirrors) {
  const HydrodynamicData data = parsed(small_file()).data;
  EXPECT_EQ(data.frequencies_radps, (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(data.about_m, glm::dvec3(1.0, -3.0, -2.0));
  EXPECT_EQ(data.added_mass[0][0], 20.0);   // surge of the second row
  EXPECT_EQ(data.added_mass[0][7], 160.0);  // heave: place 14 of the file
  ASSERT_EQ(data.directions_rad.size(), 4u);
  EXPECT_NEAR(data.directions_rad[0], -pi, 1e-12);
  EXPECT_NEAR(data.directions_rad[1], -0.5 * pi, 1e-12);
  EXPECT_NEAR(data.directions_rad[3], 0.5 * pi, 1e-12);
  // The second frequency's second direction: places 24 to 29 of the file, and 36 more for the imaginary part.
  // To port in the file is -z, direction -90 degrees here.
  const HullWrench &port = data.excitation[1], &starboard = data.excitation[3];
  EXPECT_EQ(port[0], std::complex<double>(24.0, 60.0));
  EXPECT_EQ(port[1], std::complex<double>(26.0, 62.0));
  EXPECT_EQ(port[2], -std::complex<double>(25.0, 61.0));
  EXPECT_EQ(port[4], std::complex<double>(29.0, 65.0));
  EXPECT_EQ(port[5], -std::complex<double>(28.0, 64.0));
  for (const std::size_t m : {0u, 1u, 5u}) EXPECT_EQ(starboard[m], port[m]);
  for (const std::size_t m : {2u, 3u, 4u}) EXPECT_EQ(starboard[m], -port[m]);
}

void expect_error(const std::function<void()>& read, const std::string& part) {
  try {
    read();
    ADD_FAILURE() << "no error; expected " << part;
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find(part), std::string::npos) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos);
    EXPECT_FALSE(error.hint().empty());
  }
}

// Fails if a damaged data base is taken, or its error does not name the place.
TEST(ReadHydrodynamicsTest, DamagedDatasetsAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto expect = [](const std::function<void(test::TestNetcdf&)>& damage, const std::string& part) {
    test::TestNetcdf file = small_file();
    damage(file);
    expect_error([&] { parsed(file); }, part);
  };
  using File = test::TestNetcdf;
  expect([&](File& f) { f.variable("added_mass").values[36 + 14] = nan; },
         "hull.nc: expected a finite added mass of heave by heave at 1 rad/s");
  expect([&](File& f) { f.variable("radiation_damping").values[1] = nan; }, "damping of surge by sway");
  expect([&](File& f) { f.variable("excitation_force").values[3] = nan; }, "excitation of roll at 2 rad/s");
  expect([](File& f) { f.variable("radiation_damping").values[36] = -1e3; }, "damping of surge above 0");
  expect([](File& f) { f.variable("omega").values = {1.0, 1.0}; }, "each frequency once, got 1 rad/s");
  expect([](File& f) { f.variable("omega").values = {1.0, -2.0}; }, "a frequency in rad/s");
  expect([](File& f) { f.variable("omega").values = {1.0, 0.0}; }, "two frequencies or more, got 1");
  expect([](File& f) { f.variable("wave_direction").values[1] = 0.0; }, "each direction once, got 0 degrees");
  expect([](File& f) { f.variable("wave_direction").values[2] = 7.0; }, "within one turn");
  expect([](File& f) { f.variable("influenced_dof").text[0] = 'X'; },
         "expected the motion Surge in influenced_dof");
  expect(
      [](File& f) {
        f.variable("added_mass").dimensions = {"omega", "radiating_dof", "complex"};
        f.variable("added_mass").values.resize(24);
      },
      "along influenced_dof of length 6 in added_mass, got none");
  expect([](File& f) { f.variable("added_mass").name = "mass"; }, "the variable added_mass of Capytaine");
  expect([](File& f) { f.variable("rotation_center").name = "centre"; }, "the variable rotation_center");
  expect([](File& f) { f.variable("rho").values = {-1.0}; }, "a density in kg/m3");
  expect([](File& f) { f.variables.push_back({.name = "forward_speed", .dimensions = {}, .values = {3.0}}); },
         "a forward_speed of 0");
  expect(
      [](File& f) {
        f.dimensions.push_back({"huge", (std::size_t{1} << 22) + 1});
        f.variables.push_back({.name = "hydrostatic_stiffness", .dimensions = {"huge"}});
      },
      "expected up to 4194304 numbers in hydrostatic_stiffness");
  const std::string bytes = test::netcdf_bytes(small_file());
  for (std::size_t length = 0; length < bytes.size(); length += 7) {
    const std::string cut = bytes.substr(0, length);
    expect_error(
        [&] { parse_capytaine(std::as_bytes(std::span(cut)), "hull.nc", spectra::read_netcdf_arrays); },
        "hull.nc: ");
  }
}

// The same for WAMIT's files.
TEST(ReadHydrodynamicsTest, DamagedWamitFilesAreRefused) {
  const std::string radiation = "title\n5 1 1 2.0 0.5\n5 3 3 1 1\n4 3 3 1 1\n0 3 3 1\n-1 3 3 1\n";
  const std::string excitation = "5 0 3 1 90 0 1\n5 90 3 1 0 1 0\n4 0 3 1 0 1 0\n4 90 3 1 0 1 0\n";
  const auto read = [&](const std::string& one, const std::string& three,
                        const std::string& hst = "3 3 2\n") {
    return parse_wamit({one, "a.1"}, {three, "a.3"}, WamitText{hst, "a.hst"},
                       {.density_kgpm3 = 1000.0, .gravity_mps2 = 10.0, .length_m = 2.0});
  };
  const HydrodynamicFile file = read(radiation, excitation);
  EXPECT_DOUBLE_EQ(file.data.added_mass[0][0], 2.0 * 1000.0 * 8.0);
  EXPECT_DOUBLE_EQ(file.data.damping[0][0], 0.5 * 1000.0 * 8.0 * 2.0 * pi / 5.0);
  EXPECT_DOUBLE_EQ((*file.restoring)[7], 2.0 * 1000.0 * 10.0 * 4.0);
  // Toward +x, imaginary 1 with e^(+i omega t).
  const std::size_t ahead = 1;
  EXPECT_EQ(file.data.excitation[ahead][1], std::complex<double>(0.0, -1000.0 * 10.0 * 4.0));
  const auto expect = [&](const std::string& one, const std::string& three, const std::string& part) {
    expect_error([&] { read(one, three); }, part);
  };
  expect("", excitation, "a.1");
  expect("title\n", excitation, "a.1");
  expect(radiation, "", "a.3");
  expect("5 1 1 2.0\n", excitation, "a.1:1: expected PER I J A B, got 4 numbers");
  expect("5 1 7 2 2\n", excitation, "a.1:1: expected a motion from 1 to 6, got 7");
  expect("5 1 1.5 2 2\n", excitation, "a.1:1");
  expect("5 1 1 nan 2\n5 1 1 nan 2\n", excitation, "a.1:2");
  expect("5 1 1 1e300 2\n4 1 1 1 2\n", excitation, "a finite added mass of surge");
  expect(radiation + "6 1 1 2 2\n", excitation, "a.3: expected waves of the period 6 s");
  expect(radiation, excitation + "4 45 3 1 0 1 0\n",
         "a.3: expected 3 directions at the period 5 s as at the first, got 2");
  expect(radiation, "5 0 3 1 90 0\n", "a.3:1");
  expect_error([&] { read(radiation, excitation, "1 1\n"); }, "a.hst:1");
}

// Fails if a file of another kind, or one that is missing, is not named.
TEST(ReadHydrodynamicsTest, OtherFilesAreNamed) {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, const std::string& text) {
    std::ofstream(folder.path() / name) << text;
    return folder.path() / name;
  };
  expect_error([&] { read_hydrodynamics(write("empty.nc", "")); },
               "empty.nc: expected a file of hydrodynamic data, got an empty file");
  expect_error([&] { read_hydrodynamics(write("a.txt", "hello")); }, "a file of unknown format");
  expect_error([&] { read_hydrodynamics(write("alone.1", "5 1 1 2 2\n")); }, "alone.3");
  expect_error([&] { read_hydrodynamics(folder.path() / "none.nc"); }, "none.nc");
  expect_error([&] { read_hydrodynamics(box + ".nc", {}, Trust::untrusted); }, "HDF5");
  const std::string whole = text_of(box + ".nc");
  expect_error([&] { read_hydrodynamics(write("cut.nc", whole.substr(0, whole.size() / 2))); }, "cut.nc: ");
}

}  // namespace
}  // namespace offing::hydrodynamics
