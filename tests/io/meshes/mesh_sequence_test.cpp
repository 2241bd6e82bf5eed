// Numbered mesh files as one mesh that deforms.
#include "host/io/meshes/mesh_sequence.h"

#include <fstream>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

using ::testing::HasSubstr;

class MeshSequenceTest : public testing::Test {
 protected:
  /// A triangle whose third corner is this high.
  void write(int number, double height_m, const std::string& faces = "f 1 2 3\n") const {
    std::ofstream(folder_.path() / fmt::format("wave_{:04d}.obj", number))
        << "v 0 0 0\nv 1 0 0\nv 0 " << height_m << " 0\n"
        << faces;
  }
  std::filesystem::path name() const { return folder_.path() / "wave_%04d.obj"; }

  std::string refusal(double time_s = 0.0) const {
    try {
      read_mesh_sequence(name(), 10.0).deformation.form_at(time_s);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_FALSE(error.hint().empty());
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

// Ten meshes a second, numbered from 7. Fails if one is shown at another time, if vertices do not go straight
// between two, or if files of other names count.
TEST_F(MeshSequenceTest, GoesFromMeshToMesh) {
  write(7, 1.0);
  write(8, 3.0);
  write(9, 2.0);
  write(10, 0.5, "");
  std::filesystem::rename(folder_.path() / "wave_0010.obj", folder_.path() / "wave_10.obj");
  EXPECT_TRUE(is_mesh_sequence(name()));
  EXPECT_FALSE(is_mesh_sequence(folder_.path() / "wave_0007.obj"));
  ASSERT_EQ(files_of_mesh_sequence(name()).size(), 3u);
  EXPECT_EQ(files_of_mesh_sequence(name())[1].filename(), "wave_0008.obj");
  const MeshFile file = read_mesh_sequence(name(), 10.0);
  EXPECT_EQ(file.mesh.positions_m[2].y, 1.0);
  EXPECT_DOUBLE_EQ(file.deformation.end_s, 0.2);
  const auto height_m = [&](double time_s) { return file.deformation.form_at(time_s).positions_m.at(2).y; };
  EXPECT_EQ(height_m(-1.0), 1.0);
  EXPECT_NEAR(height_m(0.05), 2.0, 1e-12);
  EXPECT_NEAR(height_m(0.1), 3.0, 1e-12);
  EXPECT_NEAR(height_m(0.175), 2.25, 1e-12);
  EXPECT_EQ(height_m(5.0), 2.0);
  EXPECT_NEAR(height_m(0.05), 2.0, 1e-12) << "going back";
}

// Fails if a sequence without files, with a gap, or with a mesh that has other faces is taken, or if the line
// does not name the file.
TEST_F(MeshSequenceTest, RefusesWhatIsNoSequence) {
  EXPECT_THAT(refusal(), HasSubstr("wave_%04d.obj: expected a mesh for each number, got no file"));
  write(1, 1.0);
  EXPECT_EQ(refusal(), "");
  write(3, 1.0);
  EXPECT_THAT(refusal(), HasSubstr("got none for 2"));
  write(2, 1.0, "f 1 3 2\n");
  EXPECT_EQ(refusal(), "") << "is read before it is needed";
  EXPECT_THAT(refusal(0.1),
              HasSubstr("wave_0002.obj: expected the 3 vertices and the faces of wave_0001.obj"));
  write(2, 1.0, "v 0 0 0\nf 1 2 3\n");
  EXPECT_THAT(refusal(0.05), HasSubstr("got 4 vertices"));
  write(2, 1.0, "f 1 2 9\n");
  EXPECT_THAT(refusal(0.05), HasSubstr("wave_0002.obj:4: expected"));
}

// Fails if a link leads an untrusted sequence out of its folder.
TEST_F(MeshSequenceTest, UntrustedFilesStayBelow) {
  const TemporaryFolder elsewhere;
  write(1, 1.0);
  std::filesystem::rename(folder_.path() / "wave_0001.obj", elsewhere.path() / "secret.obj");
  std::filesystem::create_symlink(elsewhere.path() / "secret.obj", folder_.path() / "wave_0001.obj");
  EXPECT_NO_THROW(read_mesh_sequence(name(), 10.0));
  EXPECT_THROW(read_mesh_sequence(name(), 10.0, Trust::untrusted), Error);
}

}  // namespace
}  // namespace offing
