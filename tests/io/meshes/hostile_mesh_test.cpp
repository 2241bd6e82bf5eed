// What readers make of files that are wrong: an error of one line with a hint, or a mesh that keeps its
// promises.

#include <cmath>
#include <fstream>
#include <optional>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/io/meshes/read_mesh.h"
#include "tests/io/meshes/mesh_samples.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;

/// The error that a reader throws; nothing if it makes a mesh, which then must be sound.
std::optional<Error> error_of(std::string_view format, const std::string& bytes) {
  try {
    const MeshFile file = parse_mesh(format, bytes);
    EXPECT_FALSE(file.mesh.faces.empty());
    for (const glm::dvec3& p : file.mesh.positions_m) {
      EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    }
    for (const TriangleIndices& face : file.mesh.faces) {
      for (const std::uint32_t corner : face) EXPECT_LT(corner, file.mesh.positions_m.size());
    }
    if (file.deformation) {
      const MeshForm form = file.deformation.form_at(0.4 * file.deformation.end_s);
      EXPECT_EQ(form.positions_m.size(), file.mesh.positions_m.size());
      EXPECT_EQ(form.normals.size(), file.mesh.normals.size());
    }
    return std::nullopt;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    EXPECT_FALSE(error.hint().empty()) << error.what();
    return error;
  }
}

void expect_error(std::string_view format, const std::string& bytes, std::string_view words) {
  const std::optional<Error> error = error_of(format, bytes);
  ASSERT_TRUE(error) << format << " was taken where this was wrong: " << words;
  EXPECT_THAT(error->what(), HasSubstr(std::string(words)));
}

// Fails if a file that ends early crashes a reader, is taken for a whole one where it cannot be, or says
// nothing useful. Text can end early unseen (an OBJ has no end), binary files cannot.
TEST(HostileMesh, CutAtEveryByte) {
  for (const MeshSample& sample : mesh_samples()) {
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      const std::optional<Error> error = error_of(sample.format, sample.bytes.substr(0, size));
      const bool is_binary = sample.name == "binary" || sample.name == "little" || sample.name == "big";
      if (is_binary || size == 0) {
        EXPECT_TRUE(error) << sample.format << '/' << sample.name << " cut at " << size;
      }
    }
  }
}

// Fails if any wrong byte crashes a reader or yields a mesh that breaks its promises.
TEST(HostileMesh, AnyByteWrong) {
  std::mt19937 random(7);
  for (const MeshSample& sample : mesh_samples()) {
    for (std::size_t at = 0; at < sample.bytes.size(); ++at) {
      for (const int value : {0x00, 0xff, 0x7f, int{'-'}, static_cast<int>(random() % 256u)}) {
        std::string bytes = sample.bytes;
        bytes[at] = static_cast<char>(value);
        error_of(sample.format, bytes);
      }
    }
  }
}

// Fails if garbage is taken for a mesh or crashes a reader; 0 of 2,000 may pass.
TEST(HostileMesh, Garbage) {
  std::mt19937 random(11);
  for (int i = 0; i < 400; ++i) {
    std::string bytes(random() % 300, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    for (const char* const format : {"gltf", "obj", "off", "ply", "stl"})
      EXPECT_TRUE(error_of(format, bytes)) << format;
  }
}

// Fails if a header that lies makes a reader allocate (4 billion vertices are 96 GB), loop, or be believed.
TEST(HostileMesh, LyingHeaders) {
  expect_error("off", "OFF\n4294967295 1 0\n0 0 0\n", "the end of the file after 1");
  expect_error("off", "OFF\n99999999999 1 0\n", "2^32");
  expect_error("off", "OFF\n3 -1 0\n0 0 0\n1 0 0\n0 1 0\n", "count of faces");
  const std::string ply = "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n";
  expect_error("ply", ply + "property float x\nproperty float y\nproperty float z\nend_header\n123",
               "room for 0");
  expect_error("ply", ply + "end_header\n", "properties of the element vertex");
  expect_error(
      "ply",
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n2147483647 0 0 0\n",
      "a length of vertex_indices that the file holds");
  std::string stl(84, '\0');
  stl[80] = stl[81] = stl[82] = stl[83] = '\xff';
  expect_error("stl", stl, "4294967295 facets");
  expect_error(
      "gltf",
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4000000000,"uri":"data:;base64,AAAA"}]})",
      "4000000000 bytes in buffer 0");
}

// Fails if an index beyond the vertices is taken, wraps around, or makes a reader allocate.
TEST(HostileMesh, HugeIndices) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char* const index :
       {"4", "4294967296", "4294967295", "99999999999999999999", "0", "-4", "1x", "1/", "1//9"}) {
    expect_error("obj", vertices + "f 1 2 " + index + "\n", "test:4: expected");
  }
  expect_error("off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
               "test:6: expected vertex numbers within 0 ... 2");
  expect_error("off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "test:6");
}

// Fails if a NaN, an infinity, a number that is none or one too large gets into a mesh.
TEST(HostileMesh, NumbersThatAreNone) {
  for (const char* const number : {"nan", "inf", "-inf", "1e999", "1e31", "one", "1,5", "0x10", "--1"}) {
    const std::string point = std::string(number) + " 0 0\n";
    EXPECT_TRUE(error_of("obj", "v " + point + "v 1 0 0\nv 0 1 0\nf 1 2 3\n")) << number;
    EXPECT_TRUE(error_of("off", "OFF\n3 1 0\n" + point + "1 0 0\n0 1 0\n3 0 1 2\n")) << number;
  }
  MeshSample sample = mesh_sample("stl", "binary");
  sample.bytes.replace(84 + 12, 4, "\xff\xff\xff\x7f");
  expect_error("stl", sample.bytes, "facet 0");
  sample = mesh_sample("ply", "little");
  sample.bytes.replace(sample.bytes.find("end_header\n") + 11, 4, std::string("\0\0\x80\x7f", 4));
  expect_error("ply", sample.bytes, "vertex 0 at (inf");
}

// Fails if a file without faces is taken for a mesh.
TEST(HostileMesh, NoFaces) {
  expect_error("obj", "v 0 0 0\n", "1 vertices and no face");
  expect_error("obj", "", "0 vertices and no face");
  expect_error("obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "no face of three corners");
  expect_error("off", "OFF\n0 0 0\n", "no face");
  expect_error("stl", "solid empty\nendsolid empty\n", "no face");
  expect_error("gltf", R"({"asset":{"version":"2.0"}})", "no face");
}

// Fails if a tree of nodes that bites its tail never ends, or references lead out of the document.
TEST(HostileMesh, GltfReferences) {
  const std::string begin = R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],)";
  expect_error("gltf", begin + R"("nodes":[{"children":[1]},{"children":[0]}]})", "a tree of nodes");
  expect_error("gltf", begin + R"("nodes":[{"children":[7]}]})", "nodes[7]");
  expect_error("gltf", begin + R"("nodes":[{"mesh":3}]})", "meshes[3]");
  expect_error("gltf", begin + R"("nodes":[{"mesh":-1}]})", "a whole number mesh");
  expect_error("gltf", begin + R"("buffers":[{"byteLength":1,"uri":"/etc/passwd"}]})", "beside the glTF");
  expect_error("gltf", begin + R"("buffers":[{"byteLength":1,"uri":"http://a/b"}]})", "beside the glTF");
  expect_error("gltf", begin + R"("extensionsRequired":["KHR_draco_mesh_compression"]})",
               "KHR_draco_mesh_compression");
  expect_error("gltf", begin + R"("nodes":)" + std::string(100000, '['), "JSON");
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  expect_error("gltf", begin + R"("nodes":[{"mesh":)" + deep + "}]}", "a whole number mesh, got array");
}

// Fails if the file's name is not in the error, what is no file is read, or a name without a known ending is
// not known by its content.
TEST(HostileMesh, FilesByName) {
  const TemporaryFolder folder;
  const auto error_of_file = [](const std::filesystem::path& path) -> std::string {
    try {
      read_mesh(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(error_of_file(folder.path() / "none.obj"),
              HasSubstr("none.obj: expected a mesh file, got no such file"));
  EXPECT_THAT(error_of_file(folder.path()), HasSubstr("a folder"));
  std::ofstream(folder.path() / "empty.bin");
  EXPECT_THAT(error_of_file(folder.path() / "empty.bin"),
              HasSubstr("empty.bin: expected a mesh, got an empty file"));
  std::ofstream(folder.path() / "odd.bin") << "what is this";
  EXPECT_THAT(error_of_file(folder.path() / "odd.bin"), HasSubstr("unknown format"));
  for (const auto& [format, name] :
       {std::pair{"ply", "big"}, {"off", "plain"}, {"stl", "text"}, {"gltf", "binary"}}) {
    std::ofstream(folder.path() / "unnamed", std::ios::binary) << mesh_sample(format, name).bytes;
    EXPECT_EQ(error_of_file(folder.path() / "unnamed"), "") << format;
  }
}

}  // namespace
}  // namespace offing::test
