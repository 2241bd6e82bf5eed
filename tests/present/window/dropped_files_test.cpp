// What files that are dropped on a window are taken for, and what becomes of the scene.
#include "present/window/dropped_files.h"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"
#include "present/window/file_queue.h"
#include "tests/io/temporary_folder.h"

namespace offing::present {
namespace {

using ::testing::HasSubstr;

class DroppedFilesTest : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name, const std::string& text = "") const {
    const std::filesystem::path path = folder_.path() / name;
    std::ofstream(path) << text;
    return path;
  }
  std::filesystem::path ply(const std::string& name, const std::string& property) const {
    return file(name, "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float " +
                          property + "\nend_header\n");
  }

  TemporaryFolder folder_;
};

// Fails if a name of any language or case is taken for something else.
TEST_F(DroppedFilesTest, AreKnownByTheirNames) {
  EXPECT_EQ(kind_of_dropped(file("Küste.toml")), DroppedKind::scene);
  EXPECT_EQ(kind_of_dropped(file("배.obj")), DroppedKind::mesh);
  EXPECT_EQ(kind_of_dropped(file("SHIP.GLB")), DroppedKind::mesh);
  EXPECT_EQ(kind_of_dropped(file("año.tif")), DroppedKind::height_map);
  EXPECT_EQ(kind_of_dropped(file("41010.data_spec")), DroppedKind::spectrum);
  EXPECT_EQ(kind_of_dropped(file("a.vdb")), DroppedKind::cloud);
  EXPECT_EQ(kind_of_dropped(ply("a.ply", "y")), DroppedKind::mesh);
  EXPECT_EQ(kind_of_dropped(ply("b.ply", "optical_mass")), DroppedKind::cloud);
}

// Fails if what is nothing that a scene can have is not told in one line, or what is not there.
TEST_F(DroppedFilesTest, OthersAreRefusedInOneLine) {
  for (const auto& [path, why] : {std::pair(file("song.mp3"), "song.mp3: expected a scene, a mesh"),
                                  std::pair(file("no.ply", "no"), "no.ply"),
                                  std::pair(folder_.path() / "gone.obj", "gone.obj: cannot be found")}) {
    try {
      kind_of_dropped(path);
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(why));
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      EXPECT_FALSE(error.hint().empty());
    }
  }
}

// Fails if a scene that has been given files does not come back from its own file with all of them, names of
// any language included, or loses its sea or the meshes before.
TEST_F(DroppedFilesTest, AreInTheSceneThatIsSaved) {
  scene::Scene scene = scene::parse_scene("version = 1\n[[light]]\n", "a.toml", "");
  ASSERT_TRUE(scene.has_sea());
  const std::filesystem::path mesh = file("배.obj"), terrain = file("Küste.tif"), cloud = file("nube.vdb"),
                              sea = file("mar.spec");
  for (int i = 0; i < 2; ++i) add_dropped(scene, mesh, DroppedKind::mesh, {1.0, 2.0, 3.0});
  add_dropped(scene, terrain, DroppedKind::height_map, {});
  add_dropped(scene, cloud, DroppedKind::cloud, {});
  add_dropped(scene, sea, DroppedKind::spectrum, {});
  const std::filesystem::path saved = folder_.path() / "saved.toml";
  scene::save_scene(scene, saved, Existing::keep);
  const scene::Scene again = scene::load_scene(saved);
  ASSERT_EQ(again.meshes.size(), 2u);
  EXPECT_EQ(again.meshes[0].file, mesh);
  EXPECT_EQ(again.meshes[0].position_m, glm::dvec3(1.0, 2.0, 3.0));
  EXPECT_EQ(again.meshes[0].name, "배");
  EXPECT_EQ(again.meshes[1].name, "배 2") << "bodies name meshes";
  EXPECT_EQ(again.terrain.file, terrain);
  ASSERT_EQ(again.clouds.size(), 1u);
  EXPECT_EQ(again.clouds[0].shape.file, cloud);
  EXPECT_EQ(again.ocean.spectrum_file, sea);
  EXPECT_TRUE(again.has_sea());
}

// Fails if other heights are read as those before were, which lay elsewhere and were packed otherwise.
TEST_F(DroppedFilesTest, HeightsBeginAnew) {
  scene::Scene scene = scene::parse_scene(
      "version = 1\n[terrain]\nfile = \"a.r16\"\nraw_columns = 4\nraw_rows = 4\nspacing_x_m = 3\norigin_x_m "
      "= "
      "7\ncolour = \"a.png\"\nwater_line_m = 5\n",
      "a.toml", "");
  add_dropped(scene, file("b.tif"), DroppedKind::height_map, {});
  EXPECT_EQ(scene.terrain.reading.raw_columns, 0);
  EXPECT_FALSE(scene.terrain.reading.spacing_x_m);
  EXPECT_FALSE(scene.terrain.origin_x_m);
  EXPECT_EQ(scene.terrain.colour, "");
  EXPECT_EQ(scene.terrain.water_line_m, 5.0) << "which is not the file's";
  EXPECT_FALSE(scene.has_sea()) << "there was none";
}

// Fails if a file is given before its name has been shown for a frame, or the faults of files that came
// together hide each other.
TEST(FileQueueTest, SaysWhatItReads) {
  FileQueue queue;
  Message message;
  EXPECT_FALSE(queue.next(message));
  queue.add({{.file = "a/one.obj"}, {.file = "two.obj"}});
  EXPECT_FALSE(queue.next(message));
  EXPECT_EQ(message.text, "reading one.obj ...");
  EXPECT_EQ(queue.next(message)->file, "a/one.obj");
  message = {.text = "one is no mesh", .is_fault = true};
  queue.note(message);
  EXPECT_FALSE(queue.next(message));
  EXPECT_EQ(message.text, "one is no mesh\nreading two.obj ...");
  EXPECT_EQ(queue.next(message)->file, "two.obj");
  message = {.text = "added two"};
  queue.note(message);
  EXPECT_EQ(message.text, "one is no mesh\nadded two");
  EXPECT_TRUE(message.is_fault);
  EXPECT_FALSE(queue.next(message));
  queue.add({{.file = "three.obj"}});
  queue.next(message);
  EXPECT_EQ(message.text, "reading three.obj ...");
}

}  // namespace
}  // namespace offing::present
