#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "host/cli/ocean/query_settings.h"
#include "tests/cli/offing_program.h"

// `offing ocean query`: probes of the water, as people and scripts read them.

namespace offing::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Query : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  static std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// A small sea of two cascades and Gerstner waves.
  static ProgramResult query(std::vector<std::string> arguments) {
    std::vector<std::string> all = {"ocean", "query",  "--size", "64", "--cascades", "2", "--gerstner-count",
                                    "8",     "--quiet"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_offing(all);
  }
  static std::vector<std::vector<double>> rows(const std::string& csv) {
    std::vector<std::vector<double>> table;
    std::istringstream lines(csv.substr(csv.find('\n') + 1));
    for (std::string line; std::getline(lines, line);) {
      std::istringstream fields(line);
      table.emplace_back();
      for (std::string field; std::getline(fields, field, ',');) table.back().push_back(std::stod(field));
    }
    return table;
  }

  TemporaryFolder folder_;
};

constexpr const char* header =
    "time_s,x_m,z_m,height_m,normal_x,normal_y,normal_z,velocity_x_mps,velocity_y_mps,velocity_z_mps,"
    "pressure_pa,residual_m,acceleration_x_mps2,acceleration_y_mps2,acceleration_z_mps2,error_rms_m\n";

// Fails if a column is missing or another's, if times or points are left out or out of order, if the pressure
// at the surface is not that of the air, or if the way out (file, standard output, JSON) changes an answer.
TEST_F(Query, ProbesAreRowsOfTimesAndPoints) {
  const std::string points = write("points.csv", "name,z_m,x_m\r\na,2,1\r\n# no point\r\n\r\nb,1e5,-3.5\r\n");
  const ProgramResult to_file = query({"--points", points, "--times", "0:1:0.1", "-o", path("out.csv")});
  ASSERT_EQ(to_file.exit_code, 0) << to_file.errors;
  EXPECT_EQ(to_file.output, "") << "--quiet";
  const std::string csv = text_of(path("out.csv"));
  EXPECT_TRUE(csv.starts_with(header)) << csv.substr(0, 200);
  const auto table = rows(csv);
  ASSERT_EQ(table.size(), 22u);
  for (std::size_t i = 0; i < table.size(); ++i) {
    ASSERT_EQ(table[i].size(), 16u);
    EXPECT_NEAR(table[i][0], 0.1 * static_cast<double>(i / 2), 1e-9);
    EXPECT_EQ(table[i][1], i % 2 == 0 ? 1.0 : -3.5);
    EXPECT_EQ(table[i][2], i % 2 == 0 ? 2.0 : 1e5);
    EXPECT_NEAR(std::hypot(table[i][4], table[i][5], table[i][6]), 1.0, 1e-5);
    EXPECT_NEAR(table[i][10], 0.0, 0.1) << "Pa";
    EXPECT_LE(table[i][11], 1.1e-4);
    EXPECT_LT(std::hypot(table[i][12], table[i][13], table[i][14]), 9.81);
    EXPECT_GT(table[i][15], 0.0);
  }
  const ProgramResult to_output = query({"--points", points, "--times", "0:1:0.1"});
  EXPECT_EQ(to_output.output, csv);
  const json answers =
      json::parse(query({"--points", points, "--times", "0:1:0.1", "--json"}).output, nullptr, false);
  ASSERT_EQ(answers.size(), 22u);
  EXPECT_NEAR(answers[3]["height_m"].get<double>(), table[3][3], 1e-6);
  EXPECT_EQ(answers[3]["x_m"], -3.5);
}

// Fails if one point at one time is not one object with vectors as arrays, or if its values are not those of
// the column beside it.
TEST_F(Query, OneAnswerIsOneObject) {
  const std::vector<std::string> one = {"--at", "-5,7", "--time", "3", "--velocity-depth-m", "2"};
  std::vector<std::string> as_json = one, as_csv = one;
  as_json.push_back("--json");
  as_csv.insert(as_csv.end(), {"-o", path("one.csv")});
  const ProgramResult result = query(as_json);
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json answer = json::parse(result.output, nullptr, false);
  ASSERT_TRUE(answer.is_object()) << result.output;
  ASSERT_EQ(query(as_csv).exit_code, 0);
  const auto table = rows(text_of(path("one.csv")));
  ASSERT_EQ(table.size(), 1u);
  const std::vector<double>& row = table[0];
  const auto expect_near = [](double found, double expected) {
    EXPECT_NEAR(found, expected, 1e-6 * std::max(1.0, std::abs(expected)));
  };
  expect_near(answer["time_s"], row[0]);
  expect_near(answer["x_m"], row[1]);
  expect_near(answer["z_m"], row[2]);
  expect_near(answer["height_m"], row[3]);
  ASSERT_EQ(answer["normal"].size(), 3u);
  ASSERT_EQ(answer["velocity_mps"].size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    expect_near(answer["normal"][i], row[4 + i]);
    expect_near(answer["velocity_mps"][i], row[7 + i]);
    expect_near(answer["acceleration_mps2"][i], row[12 + i]);
  }
  expect_near(answer["pressure_pa"], row[10]);
  expect_near(answer["residual_m"], row[11]);
  expect_near(answer["error_rms_m"], row[15]);
  const ProgramResult two_times = query({"--at", "-5,7", "--times", "3:4:1", "--json"});
  EXPECT_TRUE(json::parse(two_times.output, nullptr, false).is_array()) << two_times.output;
}

// Fails if --exact is not --accuracy exact, or if the answers of a bake's maps are not marked by their larger
// error.
TEST_F(Query, AccuracyIsAsked) {
  const std::vector<std::string> one = {"--at", "-5,7", "--time", "3", "--json"};
  const auto answer_with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), one.begin(), one.end());
    const ProgramResult result = query(more);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return json::parse(result.output, nullptr, false);
  };
  const json exact = answer_with({"--exact"}), drawn = answer_with({"--accuracy", "frame-maps"});
  EXPECT_EQ(exact, answer_with({"--accuracy", "exact"}));
  EXPECT_EQ(exact, answer_with({}));
  EXPECT_GT(drawn["error_rms_m"].get<double>(), 100.0 * exact["error_rms_m"].get<double>());
  EXPECT_EQ(query({"--at", "0,0", "--exact", "--accuracy", "maps"}).exit_code, 2);
}

// Points that can be read once, as a shell's <(...) gives them. Closes with the object; what programs that
// the test starts inherit stays theirs.
class Pipe {
 public:
  explicit Pipe(const std::string& text) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    const auto written = write(ends[1], text.data(), text.size());
    close(ends[1]);
    reading_end_ = ends[0];
    if (written != static_cast<ssize_t>(text.size())) throw std::runtime_error("the pipe is full");
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() { close(reading_end_); }

  std::string name() const { return "/dev/fd/" + std::to_string(reading_end_); }

 private:
  int reading_end_;
};

// Fails if points from a pipe are not answered as those of a file are, or if what would need them twice is
// tried, or told with another reason.
TEST_F(Query, PointsMayComeThroughAPipeOnce) {
  const std::string text = "x_m,z_m\n1,2\n-3.5,+4\n";
  const ProgramResult from_file = query({"--points", write("points.csv", text), "--time", "2"});
  const Pipe once(text);
  const ProgramResult from_pipe = query({"--points", once.name(), "--time", "2"});
  ASSERT_EQ(from_pipe.exit_code, 0) << from_pipe.errors;
  EXPECT_EQ(rows(from_pipe.output).size(), 2u);
  EXPECT_EQ(from_pipe.output, from_file.output);
  const Pipe twice(text);
  const ProgramResult refused = query({"--points", twice.name(), "--times", "0:1:1"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("can be read only once: /dev/fd/"));
  EXPECT_THAT(refused.errors, HasSubstr("\nhint: "));
  EXPECT_EQ(refused.output, "");
}

// A ship of 24 m runs at 5 m/s through a calm. Fails if her wake is not in the answers, changes water outside
// its window, or depends on which times were asked for before.
TEST_F(Query, WakesAreIncluded) {
  const std::string calm = R"(version = 1
[ocean]
size = 32
hs_m = 0.02
tp_s = 3
[[mesh]]
name = "hull"
shape = "ship"
size_m = 24
[[body]]
mesh = "hull"
draught_m = 1.6
motion = "path"
speed_mps = 5
)";
  const std::string wake = write("wake.toml", calm + R"([[ocean.wake]]
centre = "body"
length_m = 96
cells = 128
behind_m = 20
)");
  const std::string points = write("points.csv", "x_m,z_m\n32,0\n25,4\n500,0\n");
  const auto heights = [&](const std::string& scene, const std::vector<std::string>& times) {
    std::vector<std::string> arguments = {"ocean", "query", scene, "--points", points, "--quiet"};
    arguments.insert(arguments.end(), times.begin(), times.end());
    const ProgramResult result = run_offing(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.errors, testing::Not(HasSubstr("leave out")));
    std::vector<double> found;
    for (const std::vector<double>& row : rows(result.output)) found.push_back(row.at(3));
    return found;
  };
  const std::vector<double> without = heights(write("calm.toml", calm), {"--time", "4"});
  const std::vector<double> with = heights(wake, {"--time", "4"});
  ASSERT_EQ(with.size(), 3u);
  EXPECT_GT(with[0] - without[0], 0.1) << "at her bow";
  EXPECT_GT(std::abs(with[1] - without[1]), 0.05) << "beside it";
  EXPECT_EQ(with[2], without[2]);
  const std::vector<double> both = heights(wake, {"--times", "2:4:2"});
  EXPECT_EQ(std::vector<double>(both.begin() + 3, both.end()), with);
}

// Fails if a filter or a depth does not reach the sea: without waves below 1 km it is flat, and the pressure
// 3 m deep is rho g 3 m; or if the words for people leave an answer out.
TEST_F(Query, FilterAndDepthReachTheSea) {
  const ProgramResult flat = query(
      {"--at", "-5,7", "--time", "3", "--min-wavelength-m", "1000", "--velocity-depth-m", "3", "--json"});
  ASSERT_EQ(flat.exit_code, 0) << flat.errors;
  const json answer = json::parse(flat.output, nullptr, false);
  EXPECT_NEAR(answer["height_m"].get<double>(), 0.0, 1e-3);
  EXPECT_NEAR(answer["pressure_pa"].get<double>(), 3.0 * 1025.0 * 9.81, 15.0);
  const ProgramResult words = query({"--at", "-5,7", "--time", "3", "--velocity-depth-m", "3"});
  for (const char* part : {"at x -5 m, z 7 m, 3 s", "height", "normal", "velocity", "3 m below", "pressure",
                           "acceleration", "residual", "expected error"})
    EXPECT_THAT(words.output, HasSubstr(part));
}

// Fails if a file that is there is lost, or if a failed query leaves half a file behind.
TEST_F(Query, FilesAreReplacedOnlyWhenAsked) {
  const std::string out = write("out.csv", "mine");
  const ProgramResult refused = query({"--at", "0,0", "-o", out});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("out.csv: expected a new file"));
  EXPECT_THAT(refused.errors, HasSubstr("--force"));
  EXPECT_EQ(text_of(out), "mine");
  const std::string broken = write("points.csv", "1,2\n3,4\n5\n");
  EXPECT_EQ(query({"--points", broken, "-o", out, "--force"}).exit_code, 2);
  EXPECT_EQ(text_of(out), "mine");
  const ProgramResult replaced = query({"--at", "0,0", "-o", out, "--force", "--json"});
  EXPECT_EQ(replaced.exit_code, 0) << replaced.errors;
  EXPECT_TRUE(text_of(out).starts_with(header));
  const json summary = json::parse(replaced.output, nullptr, false);
  EXPECT_EQ(summary["samples"], 1);
  EXPECT_EQ(summary["scene_hash"].get<std::string>().size(), 32u);
}

// Fails if more points than a block holds are lost, doubled or mixed up.
TEST_F(Query, ManyPointsAreReadBlockByBlock) {
  std::string text;
  constexpr int count = 70000;
  for (int i = 0; i < count; ++i) text += std::to_string(i) + ",0\n";
  const std::string points = write("many.csv", text);
  const ProgramResult result = query({"--points", points, "--times", "0:0.5:0.5"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto table = rows(result.output);
  ASSERT_EQ(table.size(), 2u * count);
  for (std::size_t i = 0; i < table.size(); ++i) ASSERT_EQ(table[i][1], static_cast<double>(i % count));
}

// Each fails if its fault passes, or is told without its place and its fix.
TEST_F(Query, BadQuestionsGetOneLineAndAHint) {
  struct Fault {
    std::vector<std::string> arguments;
    int exit_code;
    const char* error;
  };
  write("word.csv", "x_m,z_m\n1,2\n3,four\n");
  write("not_a_number.csv", "1,nan\n");
  write("one_column.csv", "1\n");
  write("three_columns.csv", "1,2,3\n");
  write("wrong_header.csv", "x,z\n1,2\n");
  write("short_row.csv", "name,x_m,z_m\na,1\n");
  write("empty.csv", "");
  write("header_alone.csv", "x_m,z_m\n");
  write("long_line.csv", "1,2\n" + std::string(100000, '1'));
  write("far.csv", "1,2\n1,3e7\n");
  write("two_signs.csv", "1,2\n+-5,2\n");
  write("zero_byte.csv", std::string("1,2\n3,4\0,5\n", 11));
  const std::vector<Fault> faults = {
      {{}, 2, "expected --at or --points, found neither"},
      {{"--at", "0,0", "--points", "@word.csv"}, 2, "found both"},
      {{"--at", "0;0"}, 2, "--at: expected X,Z in m"},
      {{"--at", "nan,0"}, 2, "--at: expected X,Z in m"},
      {{"--at", "0,0", "--time", "1e9"}, 2, "--time: expected a number in s"},
      {{"--at", "0,0", "--times", "5:1:1"}, 2, "--times: expected A:B:DT"},
      {{"--at", "0,0", "--times", "0:1:0"}, 2, "--times: expected A:B:DT"},
      {{"--at", "0,0", "--times", "0:1:-1"}, 2, "--times: expected A:B:DT"},
      {{"--at", "0,0", "--times", "0:1e8:1e-9"}, 2, "--times: expected A:B:DT"},
      {{"--at", "0,0", "--time", "1", "--times", "0:1:1"}, 2, "--time"},
      {{"--at", "0,0", "--velocity-depth-m", "20", "--depth-m", "10"}, 2, "--velocity-depth-m: expected"},
      {{"--at", "0,0", "--min-wavelength-m", "-1"}, 2, "--min-wavelength-m: expected"},
      {{"--points", "@missing.csv"}, 2, "missing.csv: cannot be read: No such file"},
      {{"--points", "@"}, 2, "cannot be read: it is a folder"},
      {{"--points", "@word.csv"},
       2,
       "word.csv:3: expected x_m,z_m as two numbers within [-2e+07, 2e+07], found \"3,four\""},
      {{"--points", "@not_a_number.csv"}, 2, "not_a_number.csv:1: expected"},
      {{"--points", "@one_column.csv"}, 2, "one_column.csv:1: expected"},
      {{"--points", "@three_columns.csv"}, 2, "three_columns.csv:1: expected"},
      {{"--points", "@wrong_header.csv"}, 2, "wrong_header.csv:1: expected"},
      {{"--points", "@short_row.csv"}, 2, "short_row.csv:2: expected"},
      {{"--points", "@empty.csv"}, 2, "empty.csv: expected points, found none"},
      {{"--points", "@header_alone.csv"}, 2, "header_alone.csv: expected points, found none"},
      {{"--points", "@long_line.csv"}, 2, "long_line.csv:2: expected a line of at most 4095"},
      {{"--points", "@far.csv"}, 2, "far.csv:2: expected"},
      {{"--points", "@two_signs.csv"}, 2, "two_signs.csv:2: expected"},
      {{"--points", "@zero_byte.csv"}, 2, "zero_byte.csv:2: expected text"},
  };
  for (Fault fault : faults) {
    for (std::string& argument : fault.arguments) {
      if (argument.starts_with('@')) argument = path(argument.substr(1));
    }
    const ProgramResult result = query(fault.arguments);
    EXPECT_EQ(result.exit_code, fault.exit_code) << fault.error << "\n" << result.errors;
    EXPECT_THAT(result.errors, testing::StartsWith("error: ")) << fault.error;
    EXPECT_THAT(result.errors, HasSubstr(fault.error));
    EXPECT_THAT(result.errors, HasSubstr("\nhint: ")) << fault.error;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 2) << result.errors;
    EXPECT_EQ(result.output, "") << fault.error;
  }
}

// Fails if a range ends a step early or late where its step has no exact binary form.
TEST(QuerySettings, TimesReachTheirEnd) {
  const cli::TimeRange tenths = cli::read_time_range("--times", "0:600:0.1");
  EXPECT_EQ(tenths.count, 6001);
  EXPECT_NEAR(tenths.time_s(6000), 600.0, 1e-9);
  EXPECT_EQ(cli::read_time_range("--times", "-1:1.9:1").count, 3);
  EXPECT_EQ(cli::read_time_range("--times", "5:5:1").count, 1);
}

}  // namespace
}  // namespace offing::test
