// The program offing-view as its users run it, without a display server.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host/io/exr_image.h"
#include "host/io/png_image.h"
#include "host/io/tile_store/tile_store.h"
#include "host/terrain/tiles/tile_builder.h"
#include "tests/cli/offing_program.h"
#include "tests/present/image_difference.h"

namespace offing::test {
namespace {

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// One scene and its picture for all cases: each start of the program takes a second or more where the CPU
// draws.
class ViewProgramTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    folder_ = std::make_unique<TemporaryFolder>();
    std::ofstream(scene())
        << "version = 1\n"
           "[time]\nfps = 10\nend_s = 0.3\n"
           "[wind]\nspeed_mps = 9\n"
           "[ocean]\nfetch_m = 40e3\nsize = 64\ngerstner.count = 12\n"
           "[[ocean.swell]]\namplitude_m = 0.6\nwavelength_m = 70\ndirection_deg = 80\n"
           "[[ocean.raindrop]]\ntime_s = 0.5\nz_m = -20\namplitude_m = 0.4\nwavelength_m = 5\n"
           "[camera]\ny_m = 6\npitch_deg = -4\n"
           "[sun]\nelevation_deg = 20\nazimuth_deg = 20\n";
    first_ = view({"--time", "2", "-o", path("first.png")});
  }
  static void TearDownTestSuite() { folder_.reset(); }

  void SetUp() override {
    if (first_.exit_code == 3 && first_.errors.find("OpenGL") != std::string::npos) {
      GTEST_SKIP() << first_.errors;
    }
    ASSERT_EQ(first_.exit_code, 0) << first_.errors;
  }
  void TearDown() override {
    unsetenv("MESA_GL_VERSION_OVERRIDE");
    unsetenv("MESA_EXTENSION_OVERRIDE");
  }

  static std::string path(const std::string& name) { return (folder_->path() / name).string(); }
  static std::string scene() { return path("sea.toml"); }
  static ProgramResult view(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(),
                     {scene(), "--headless", "--size", "160x90", "--detail", "low", "--force"});
    return run_offing(arguments);
  }

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline ProgramResult first_;
};

// Fails if a picture depends on anything but its scene and time: a clock, memory left over, threads.
TEST_F(ViewProgramTest, RepeatsEveryByte) {
  ASSERT_EQ(view({"--time", "2", "-o", path("a.png")}).exit_code, 0);
  EXPECT_EQ(bytes_of(path("a.png")), bytes_of(path("first.png")));
  ASSERT_EQ(view({"--time", "2", "-o", path("a.exr")}).exit_code, 0);
  ASSERT_EQ(view({"--time", "2", "-o", path("b.exr")}).exit_code, 0);
  EXPECT_EQ(bytes_of(path("a.exr")), bytes_of(path("b.exr")));
}

// Fails if a frame of a recording is not the picture of its time, or one is missing.
TEST_F(ViewProgramTest, RecordsFramesOfTheirTimes) {
  ASSERT_EQ(view({"--record", path("out_%04d.png"), "--frames", "19:21", "--fps", "10"}).exit_code, 0);
  EXPECT_EQ(bytes_of(path("out_0020.png")), bytes_of(path("first.png")));
  EXPECT_NE(bytes_of(path("out_0019.png")), bytes_of(path("out_0021.png")));
  ASSERT_EQ(view({"--record", path("all_%d.png")}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(path("all_0.png")));
  EXPECT_TRUE(std::filesystem::exists(path("all_2.png")));
  EXPECT_FALSE(std::filesystem::exists(path("all_3.png"))) << "frames stop before end_s";
}

// Fails if recorded highlights have no alpha, are those of another frame, or lack a file.
TEST_F(ViewProgramTest, RecordsHighlightsAlone) {
  const std::vector<std::string> ball{OFFING_SCENES "/sphere.toml",
                                      "--headless",
                                      "--size",
                                      "64x36",
                                      "--detail",
                                      "low",
                                      "--highlights",
                                      "only"};
  const auto run = [&](std::vector<std::string> more) {
    more.insert(more.begin(), ball.begin(), ball.end());
    const ProgramResult result = run_offing(more);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
  };
  run({"--record", path("glint_%d.png"), "--frames", "0:1", "--fps", "1", "-o", path("glint.png")});
  const RgbaImage first = read_png_with_alpha(path("glint_0.png")),
                  next = read_png_with_alpha(path("glint_1.png"));
  EXPECT_EQ(bytes_of(path("glint_0.png")), bytes_of(path("glint.png")));
  EXPECT_NE(first.rgba, next.rgba);
  std::size_t clear = 0, opaque = 0;
  for (std::size_t i = 3; i < first.rgba.size(); i += 4) {
    clear += first.rgba[i] == 0;
    opaque += first.rgba[i] == 255;
  }
  EXPECT_GT(clear, 64u * 36u / 2u);
  EXPECT_GT(opaque, 3u);
}

// Fails if the picture differs where OpenGL is older or has fewer extensions: mean difference below 1/255.
TEST_F(ViewProgramTest, LooksTheSameOnOlderOpenGl) {
  const RgbImage expected = read_png(path("first.png"));
  for (const char* version : {"3.3FC", "4.1FC"}) {
    setenv("MESA_GL_VERSION_OVERRIDE", version, 1);
    setenv("MESA_EXTENSION_OVERRIDE", "-GL_ARB_buffer_storage -GL_ARB_clip_control", 1);
    const ProgramResult result = view({"--time", "2", "-o", path("older.png")});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    if (result.errors.find(std::string("OpenGL ") + std::string(version, 3)) == std::string::npos) {
      GTEST_SKIP() << "this driver does not take MESA_GL_VERSION_OVERRIDE: " << result.errors;
    }
    EXPECT_LT(mean_difference(read_png(path("older.png")), expected), 1.0) << version;
  }
}

// Fails if the EXR is not scene-linear light: a clear sky's luminance is some kcd/m2, and no pixel is
// negative.
TEST_F(ViewProgramTest, WritesSceneLinearLight) {
  ASSERT_EQ(view({"--time", "2", "-o", path("light.exr")}).exit_code, 0);
  const ExrContent content = read_exr(path("light.exr"));
  EXPECT_EQ(content.width, 160);
  EXPECT_EQ(content.height, 90);
  const float top = content.channel("G").front();
  EXPECT_GT(top, 0.5f);
  EXPECT_LT(top, 30.0f);
  for (const float value : content.channel("B")) ASSERT_GE(value, 0.0f);
}

// Fails if ground is not in the picture, or one that is made twice differs; if --terrain shows another
// picture than the scene that names the file.
TEST_F(ViewProgramTest, ShowsTerrain) {
  std::ofstream(path("hill.asc")) << "ncols 4\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 50\n"
                                     "0 10 10 0\n0 60 40 0\n0 5 20 0\n";
  std::ofstream(path("hill.toml")) << "version = 1\n[terrain]\nfile = \"hill.asc\"\n";
  const auto shown = [](std::vector<std::string> arguments, const std::string& name) {
    arguments.insert(arguments.end(), {"--headless", "--size", "160x90", "-o", path(name)});
    const ProgramResult result = run_offing(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return bytes_of(path(name));
  };
  const auto hill = shown({path("hill.toml")}, "hill.png");
  EXPECT_EQ(shown({path("hill.toml")}, "again.png"), hill);
  EXPECT_EQ(shown({"--terrain", path("hill.asc")}, "named.png"), hill);
  std::ofstream(path("made.toml")) << "version = 1\n[terrain]\nposts = 65\n";
  EXPECT_NE(shown({path("made.toml")}, "made.png"), hill);
}

// Fails if a tile store is not shown where a map would be, or as another ground: slopes of tiles are kept in
// 512ths, and are the mean ones between posts, so that light differs, by less than 3 of 255 on the mean over
// a map of few posts.
TEST_F(ViewProgramTest, ShowsTileStores) {
  const int side = 300;
  const TileSetShape shape = TileSetShape::of(side, side);
  const TileStoreWriter writer(path("hills.tiles"), Existing::keep);
  terrain::TileBuilder builder(shape, [&](const HeightTile& tile) { writer.write(tile); });
  std::vector<float> all_m, row_m(side);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      row_m[static_cast<std::size_t>(column)] =
          static_cast<float>(40.0 * std::sin(0.05 * column) * std::cos(0.04 * row) + 60.0);
    }
    builder.add_row(row_m);
    all_m.insert(all_m.end(), row_m.begin(), row_m.end());
  }
  TileStoreHeader header;
  header.shape = shape;
  header.spacing_x_m = header.spacing_z_m = 10.0;
  header.lowest_m = *std::min_element(all_m.begin(), all_m.end());
  header.highest_m = *std::max_element(all_m.begin(), all_m.end());
  writer.finish(header);
  std::ofstream(path("hills.r32"), std::ios::binary)
      .write(reinterpret_cast<const char*>(all_m.data()), static_cast<std::streamsize>(4 * all_m.size()));
  std::ofstream(path("hills.toml")) << "version = 1\n[terrain]\nfile = \"hills.r32\"\nraw_columns = 300\n"
                                       "raw_rows = 300\nspacing_x_m = 10\nspacing_z_m = 10\n";
  const auto shown = [](const std::vector<std::string>& what, const std::string& name) {
    std::vector<std::string> arguments = what;
    arguments.insert(arguments.end(), {"--headless", "--size", "160x90", "-o", path(name)});
    const ProgramResult result = run_offing(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return read_png(path(name));
  };
  const RgbImage map = shown({path("hills.toml")}, "map.png"),
                 tiles = shown({"--terrain", path("hills.tiles")}, "tiles.png");
  ASSERT_EQ(tiles.rgb.size(), map.rgb.size());
  double difference = 0.0;
  for (std::size_t i = 0; i < map.rgb.size(); ++i) difference += std::abs(map.rgb[i] - tiles.rgb[i]);
  EXPECT_LT(difference / static_cast<double>(map.rgb.size()), 3.0);
  std::filesystem::remove(path("hills.tiles/0/0000/0001.tile"));
  EXPECT_EQ(run_offing({"--terrain", path("hills.tiles"), "--headless", "-o", path("broken.png"), "--size",
                        "160x90"})
                .exit_code,
            0);
}

// Fails if a fault of the command line or the scene is not told in two lines, with exit code 2.
TEST_F(ViewProgramTest, RefusesBadInput) {
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& named) {
    const ProgramResult result = run_offing(arguments);
    EXPECT_EQ(result.exit_code, 2) << result.errors;
    EXPECT_NE(result.errors.find("error: "), std::string::npos);
    EXPECT_NE(result.errors.find("hint: "), std::string::npos);
    EXPECT_NE(result.errors.find(named), std::string::npos) << result.errors;
  };
  refused({scene(), "--headless"}, "-o");
  refused({scene(), "--headless", "--window", "-o", path("refused.png")}, "--window");
  refused({scene(), "--window", "-o", path("refused.png")}, "--record");
  refused({scene(), "--headless", "-o", path("a.jpg")}, ".png or .exr");
  refused({scene(), "--size", "0x5", "-o", path("refused.png")}, "--size");
  refused({scene(), "--time", "nan", "-o", path("refused.png")}, "--time");
  refused({scene(), "--record", path("refused.png")}, "--record");
  refused({scene(), "--record", path("a_%d.png"), "--frames", "5:2"}, "--frames");
  refused({scene(), "--transfer", "carrier-pigeon", "-o", path("refused.png")}, "mapped-pointer");
  refused({scene(), "--nonsense"}, "--nonsense");
  refused({scene(), "--frames", "0:5", "-o", path("refused.png")}, "--frames: expected --record or --video");
  refused({scene(), "--fps", "5", "-o", path("refused.png")}, "--fps: expected --record or --video");
  refused({scene(), "--time", "5", "--record", path("a_%d.png")}, "--time: expected no --record or --video");
  refused({scene(), "--paused", "-o", path("refused.png")}, "--paused: expected a window");
  refused({scene(), "--keep-fps", "20", "-o", path("refused.png")}, "--keep-fps: expected a window");
  refused({scene(), "--render-scale", "0.5", "-o", path("refused.png")}, "--render-scale: expected a window");
  refused({scene(), "--render-scale", "0"}, "--render-scale: expected a number");
  refused({scene(), "--ui-scale", "2", "-o", path("refused.png")}, "--ui-scale: expected a window");
  refused({scene(), "--ui-scale", "4"}, "--ui-scale: expected a number");
  refused({scene(), "--keep-fps", "many"}, "--keep-fps: expected a number");
  refused({scene(), "--record", path("a_%d.jpg")}, "name it a_%d.png");
  refused({scene(), "--highlights", "only", "-o", path("refused.png")}, "expected a scene with a [[mesh]]");
  const std::string knot = OFFING_SCENES "/knot.toml";
  refused({knot, "--highlights", "hidden"}, "--highlights: expected pictures in files");
  refused({knot, "--highlights", "only", "--video", path("a.webm")}, "which has no alpha");
  refused({scene(), "--record", path("a_%d.png"), "--frames", "0:5", "-o", path("./a_3.png")},
          "--record: expected a different file from that of -o");
  refused({scene(), "--hedless"}, "did you mean --headless?");
  refused({scene(), "--size"}, "offing-view: --size: expected a value, found none");
  refused({scene(), "--terrain", "", "-o", path("refused.png")}, "--terrain: expected a value, got \"\"");
  refused({"", "-o", path("refused.png")}, "got \"\" as argument 1");
  refused({scene(), "--time", "noon", "-o", path("refused.png")}, "--time: expected a number in s");
  refused({path("missing.toml"), "-o", path("refused.png")}, "check the name of the scene file");
  refused({"--terrain", path("missing.tif"), "-o", path("refused.png")}, "--terrain: expected a height map");
  std::ofstream(path("no_map.toml")) << "version = 1\n[terrain]\nfile = \"missing.tif\"\n";
  refused({path("no_map.toml"), "-o", path("refused.png")},
          "no_map.toml:3:8: terrain.file: expected a height map");
  std::ofstream(path("bad.toml")) << "version = 1\n[camera]\nfov_deg = 1000\n";
  refused({path("bad.toml"), "-o", path("refused.png")}, "bad.toml:3:11: camera.fov_deg");
}

// Fails if a picture is drawn before it is found that it cannot be written: told within the time that reading
// the scene takes, without a word of OpenGL.
TEST_F(ViewProgramTest, LooksAtTheOutputFirst) {
  std::filesystem::create_directory(path("folder.png"));
  for (const std::vector<std::string>& output : {std::vector<std::string>{"-o", path("missing/a.png")},
                                                 {"-o", path("folder.png")},
                                                 {"--record", path("missing/a_%d.png")}}) {
    const ProgramResult result = view(output);
    EXPECT_EQ(result.exit_code, 1) << result.errors;
    EXPECT_EQ(result.errors.find("error: "), 0u) << result.errors;
    EXPECT_EQ(result.errors.find("OpenGL"), std::string::npos) << result.errors;
  }
}

// Fails if a recording that is stopped does not say how to go on, or that is not what is missing.
TEST_F(ViewProgramTest, StoppedRecordingsTellHowToGoOn) {
  OffingProgram program({scene(), "--size", "160x90", "--detail", "low", "--record", path("stop_%d.png"),
                         "--frames", "5:4000", "--quiet"});
  while (program.is_running() && !std::filesystem::exists(path("stop_5.png"))) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  program.send_signal(SIGTERM);
  const ProgramResult stopped = program.wait();
  EXPECT_EQ(stopped.exit_code, 130);
  int next = 5;
  while (std::filesystem::exists(path(fmt::format("stop_{}.png", next)))) ++next;
  EXPECT_NE(stopped.errors.find(fmt::format("stopped with {} of 3996 frames written", next - 5)),
            std::string::npos)
      << stopped.errors;
  EXPECT_NE(stopped.errors.find(fmt::format("hint: --frames {}:4000 makes the others", next)),
            std::string::npos)
      << stopped.errors;
}

// Fails if a picture is made to its end, or its file appears, after the user asked to stop. The first file of
// an empty kernel cache tells that the program is at work, with most of it before it.
TEST_F(ViewProgramTest, AStoppedImageIsNotWritten) {
  const char* const cache = std::getenv("OFFING_CACHE_DIR");
  const std::string usual = cache != nullptr ? cache : "";
  const std::string empty = path("empty_cache");
  std::filesystem::create_directory(empty);
  setenv("OFFING_CACHE_DIR", empty.c_str(), 1);
  OffingProgram program({scene(), "--headless", "-o", path("stopped.png")});
  if (usual.empty()) {
    unsetenv("OFFING_CACHE_DIR");
  } else {
    setenv("OFFING_CACHE_DIR", usual.c_str(), 1);
  }
  while (program.is_running() && std::filesystem::is_empty(empty)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  program.send_signal(SIGTERM);
  const ProgramResult stopped = program.wait();
  EXPECT_EQ(stopped.exit_code, 130) << stopped.errors;
  EXPECT_NE(stopped.errors.find("stopped at the user's request"), std::string::npos) << stopped.errors;
  EXPECT_FALSE(std::filesystem::exists(path("stopped.png")));
}

// Fails if a quality level that is forced is not used, or not printed.
TEST_F(ViewProgramTest, PrintsTheTransfer) {
  const ProgramResult result =
      view({"--transfer", "blocking-read", "--time", "2", "-o", path("blocking.png")});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.errors.find("transfer blocking-read"), std::string::npos) << result.errors;
  EXPECT_EQ(bytes_of(path("blocking.png")), bytes_of(path("first.png")));
}

}  // namespace
}  // namespace offing::test
