// What each reader makes of a file that is right.

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/io/meshes/read_mesh.h"
#include "host/io/meshes/write_mesh.h"
#include "tests/io/meshes/mesh_samples.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

using ::testing::ElementsAre;
using Face = TriangleIndices;

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Fails if a reader numbers vertices otherwise than the file, loses a face or turns one over: all kinds of
// all formats hold the same pyramid.
TEST(MeshFormats, AllKindsHoldTheSamePyramid) {
  const std::vector<glm::dvec3> points = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, {0.5, 0.75, 0.5}};
  const std::vector<Face> faces = {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}};
  int checked = 0;
  for (const MeshSample& sample : mesh_samples()) {
    if (sample.format == "gltf" || sample.name == "rich" || sample.name == "strips") continue;
    const MeshFile file = parse_mesh(sample.format, sample.bytes);
    if (sample.format == "stl") {  // corners are numbered as they come: 4 comes last in this order, too
      EXPECT_EQ(file.report.merged_corners, 18u - 5u) << sample.name;
    } else {
      EXPECT_EQ(file.report.file_faces, 5u) << sample.format << '/' << sample.name;
      EXPECT_EQ(file.report.polygons, 1u) << sample.format << '/' << sample.name;
    }
    EXPECT_EQ(file.mesh.positions_m, points) << sample.format << '/' << sample.name;
    EXPECT_EQ(file.mesh.faces, faces) << sample.format << '/' << sample.name;
    ++checked;
  }
  EXPECT_EQ(checked, 9);
}

// Windows programs begin text with a byte-order mark. Fails if one is taken for a part of the first word.
TEST(MeshFormats, ByteOrderMarksArePassedOver) {
  const std::string mark = "\xef\xbb\xbf", pyramid = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n";
  const TemporaryFolder folder;
  for (const std::string& text : {pyramid, "# made elsewhere\n" + pyramid}) {
    std::ofstream(folder.path() / "a.obj", std::ios::binary) << mark << text;
    const TriangleMesh mesh = read_mesh(folder.path() / "a.obj");
    EXPECT_EQ(mesh.positions_m.size(), 4u);
    EXPECT_EQ(mesh.faces.size(), 1u);
  }
  std::ofstream(folder.path() / "a.stl", std::ios::binary)
      << mark
      << "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      << "endfacet\nendsolid a\n";
  EXPECT_EQ(read_mesh(folder.path() / "a.stl").faces.size(), 1u);
}

// Fails if negative indices, a line that goes on, texture indices, faces before their vertices, or elements
// that are no faces are taken otherwise than the format says.
TEST(MeshFormats, ObjTakesPositionIndicesAlone) {
  const MeshFile file = parse_mesh("obj", mesh_sample("obj", "rich").bytes);
  EXPECT_THAT(file.mesh.faces, ElementsAre(Face{0, 1, 2}, Face{0, 2, 3}, Face{0, 4, 1}, Face{6, 5, 7}));
  EXPECT_EQ(file.mesh.positions_m.size(), 8u);
  EXPECT_EQ(left_out(file, "lines"), 1u);
  EXPECT_EQ(left_out(file, "points"), 1u);
  EXPECT_EQ(left_out(file, "faces of fewer than three corners"), 1u);
  EXPECT_EQ(left_out(file, "normals, since some vertices have none or several"), 2u);
  EXPECT_TRUE(file.mesh.normals.empty());
}

// Fails if values that no TriangleMesh has are dropped unsaid.
TEST(MeshFormats, ColoursAndTextureCoordinatesAreCounted) {
  const MeshFile ply = parse_mesh(
      "ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar diffuse_green\nproperty float s\nproperty float quality\n"
      "element face 1\nproperty list uchar int vertex_indices\nproperty uchar blue\nend_header\n"
      "0 0 0 1 2 0.5 7\n1 0 0 1 2 0.5 7\n0 1 0 1 2 0.5 7\n3 0 1 2 9\n");
  EXPECT_EQ(left_out(ply, "colours of vertices"), 3u);
  EXPECT_EQ(left_out(ply, "texture coordinates of vertices"), 3u);
  EXPECT_EQ(left_out(ply, "other values of vertices"), 3u);
  EXPECT_EQ(left_out(ply, "colours of faces"), 1u);
  const MeshFile obj = parse_mesh("obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nf 1/1 2/2 3/1\n");
  EXPECT_EQ(left_out(obj, "texture coordinates"), 2u);
}

// Fails if normals that vertices share are lost, kept where they differ, or not made unit vectors.
TEST(MeshFormats, ObjKeepsNormalsThatAreOneAVertex) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 2\nvn 0 3 4\n";
  const MeshFile same = parse_mesh("obj", vertices + "f 1//1 2//2 3//1\nf 2//2 4//1 3//1\n");
  ASSERT_EQ(same.mesh.normals.size(), 4u);
  EXPECT_EQ(same.mesh.normals[0], glm::dvec3(0, 0, 1));
  EXPECT_LT(glm::distance(same.mesh.normals[1], glm::dvec3(0, 0.6, 0.8)), 1e-15);
  EXPECT_TRUE(parse_mesh("obj", vertices + "f 1//1 2//2 3//1\nf 2//1 4//1 3//1\n").mesh.normals.empty());
  EXPECT_TRUE(parse_mesh("obj", vertices + "f 1//1 2//1 3//1\nf 2 4 3\n").mesh.normals.empty());
  EXPECT_TRUE(parse_mesh("obj", vertices + "f 1//1 2//1 3//1\n").mesh.normals.empty());  // none of vertex 4
}

// Fails if a degenerate or repeated face is dropped, as half-edge structures do.
TEST(MeshFormats, DegenerateAndRepeatedFacesAreKept) {
  const MeshFile file =
      parse_mesh("off", "OFF\n3 4 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n3 0 1 2\n3 0 0 1\n3 2 1 0\n");
  EXPECT_THAT(file.mesh.faces, ElementsAre(Face{0, 1, 2}, Face{0, 1, 2}, Face{0, 0, 1}, Face{2, 1, 0}));
  EXPECT_TRUE(file.report.left_out.empty());
}

// Fails if strips are cut wrongly or their restarts are taken for vertices.
TEST(MeshFormats, PlyStripsTurnEverySecondTriangle) {
  const MeshFile file = parse_mesh("ply", mesh_sample("ply", "strips").bytes);
  EXPECT_THAT(file.mesh.faces, ElementsAre(Face{0, 1, 2}, Face{2, 1, 3}, Face{0, 4, 1}));
  EXPECT_EQ(left_out(file, "edges"), 1u);
}

// Fails if nodes are not applied, a mirrored node's faces are not turned over, strips and fans are cut
// wrongly or primitives that share vertices do not share them here. Node 1 moves by (1, 2, 3) and mirrors y,
// node 2 turns by 2 acos(0.8) around y.
TEST(MeshFormats, GltfShowsItsScene) {
  for (const char* const name : {"embedded", "binary"}) {
    const MeshFile file = parse_mesh("gltf", mesh_sample("gltf", name).bytes);
    ASSERT_EQ(file.mesh.positions_m.size(), 20u) << name;
    // A node: 6 triangles, a strip of 3, a fan of 3.
    ASSERT_EQ(file.mesh.faces.size(), 24u) << name;
    EXPECT_EQ(file.mesh.positions_m[4], glm::dvec3(1.5, 1.25, 3.5)) << name;
    EXPECT_EQ(file.mesh.faces[0], (Face{0, 2, 1})) << name;
    EXPECT_EQ(file.mesh.faces[6], (Face{5, 7, 6})) << name;  // the strip's first
    EXPECT_EQ(file.mesh.faces[12], (Face{10, 11, 12})) << name;
    EXPECT_EQ(file.mesh.faces[19], (Face{16, 18, 17})) << name;  // the strip's second
    EXPECT_EQ(file.mesh.faces[21], (Face{11, 12, 10})) << name;  // the fan's first
    const double cosine = 0.8 * 0.8 - 0.6 * 0.6, sine = 2.0 * 0.6 * 0.8;
    EXPECT_LT(glm::distance(file.mesh.positions_m[11], glm::dvec3(cosine, 0, -sine)), 1e-15) << name;
  }
}

// Fails if a buffer beside the document is not found, quantized positions are not divided by their largest
// value, or normals are not kept, moved by the node and turned with it: it mirrors x and stretches y twice.
TEST(MeshFormats, GltfWithABufferBesideIt) {
  const TemporaryFolder folder;
  const std::array<std::uint16_t, 12> positions = {0, 0, 0, 0,     65535, 0,
                                                   0, 0, 0, 13107, 0,     0};  // 8 bytes each
  const std::array<float, 9> normals = {1, 1, 0, 0, 0, 1, 0, 0, -1};
  std::ofstream buffer(folder.path() / "the buffer.bin", std::ios::binary);
  buffer.write(reinterpret_cast<const char*>(positions.data()), sizeof(positions));
  buffer.write(reinterpret_cast<const char*>(normals.data()), sizeof(normals));
  buffer.close();
  std::ofstream(folder.path() / "a.gltf") << R"({"asset":{"version":"2.0"},
    "extensionsRequired":["KHR_mesh_quantization"],
    "buffers":[{"byteLength":60,"uri":"the%20buffer.bin"}],
    "bufferViews":[{"buffer":0,"byteLength":24,"byteStride":8},{"buffer":0,"byteOffset":24,"byteLength":36}],
    "accessors":[{"bufferView":0,"componentType":5123,"normalized":true,"count":3,"type":"VEC3"},
                 {"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1}}]}],
    "nodes":[{"mesh":0,"scale":[-1,2,1]}]})";
  const TriangleMesh mesh = read_mesh(folder.path() / "a.gltf");
  ASSERT_EQ(mesh.positions_m.size(), 3u);
  EXPECT_EQ(mesh.positions_m[1], glm::dvec3(-1, 0, 0));
  EXPECT_LT(glm::distance(mesh.positions_m[2], glm::dvec3(0, 0.4, 0)), 1e-15);
  EXPECT_THAT(mesh.faces, ElementsAre(Face{0, 2, 1}));
  ASSERT_EQ(mesh.normals.size(), 3u);
  EXPECT_LT(glm::distance(mesh.normals[0], glm::normalize(glm::dvec3(-1, 0.5, 0))), 1e-15);
  EXPECT_EQ(mesh.normals[1], glm::dvec3(0, 0, 1));
}

// Fails if what is written reads back otherwise: positions to the last bit (in STL as floats and by place),
// the faces, their order.
TEST(MeshFormats, WrittenMeshesReadBack) {
  const TemporaryFolder folder;
  for (unsigned seed = 0; seed < 4; ++seed) {
    const TriangleMesh mesh = random_mesh(seed);
    for (const char* const name : {"a.ply", "a.obj", "a.off"}) {
      write_mesh(folder.path() / name, mesh);
      const TriangleMesh read = read_mesh(folder.path() / name);
      EXPECT_EQ(read.positions_m, mesh.positions_m) << name;
      EXPECT_EQ(read.faces, mesh.faces) << name;
    }
    write_mesh(folder.path() / "a.stl", mesh);
    const TriangleMesh read = read_mesh(folder.path() / "a.stl");
    ASSERT_EQ(read.positions_m.size(), mesh.positions_m.size());
    ASSERT_EQ(read.faces.size(), mesh.faces.size());
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::dvec3& written = mesh.positions_m[mesh.faces[face][corner]];
        const glm::dvec3& found = read.positions_m[read.faces[face][corner]];
        for (int axis = 0; axis < 3; ++axis)
          EXPECT_EQ(found[axis], double{static_cast<float>(written[axis])});
      }
    }
  }
}

// Fails if the same mesh gives other bytes, if floats are written as doubles or doubles are rounded, or if
// normals are lost.
TEST(MeshFormats, PlyIsSmallAndDeterministic) {
  const TemporaryFolder folder;
  TriangleMesh mesh = random_mesh(1);
  write_ply(folder.path() / "doubles.ply", mesh);
  write_ply(folder.path() / "again.ply", mesh);
  EXPECT_EQ(content(folder.path() / "doubles.ply"), content(folder.path() / "again.ply"));
  EXPECT_THAT(content(folder.path() / "doubles.ply"), ::testing::HasSubstr("property double x\n"));
  for (glm::dvec3& position : mesh.positions_m) position = glm::round(position * 1024.0) / 1024.0;
  mesh.normals.assign(mesh.positions_m.size(), glm::dvec3(0, 0.6, 0.8));
  write_ply(folder.path() / "floats.ply", mesh);
  EXPECT_THAT(content(folder.path() / "floats.ply"), ::testing::HasSubstr("property float x\n"));
  const TriangleMesh read = read_mesh(folder.path() / "floats.ply");
  EXPECT_EQ(read.positions_m, mesh.positions_m);
  ASSERT_EQ(read.normals.size(), mesh.normals.size());
  EXPECT_LT(glm::distance(read.normals[3], mesh.normals[3]), 1e-7);  // of floats
}

// Fails if a name or arrays that a format cannot hold are written, or leave a file behind.
TEST(MeshFormats, WritersRefuseWhatNoReaderTakes) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = random_mesh(2);
  const std::vector<double> few(3, 1.0), infinite(mesh.positions_m.size(), 1e300);
  const auto with = [&](std::string name, std::span<const double> values) {
    return VertexAttributes{.properties = {{std::move(name), values}}, .colours = {}, .comments = {}};
  };
  EXPECT_THROW(write_ply(folder.path() / "a.ply", mesh, with("few", few)), Error);
  EXPECT_THROW(write_ply(folder.path() / "a.ply", mesh, with("infinite", infinite)), Error);
  const std::vector<double> values(mesh.positions_m.size(), 1.0);
  EXPECT_THROW(write_ply(folder.path() / "a.ply", mesh, with("two words", values)), Error);
  EXPECT_THROW(
      write_ply(folder.path() / "a.ply", mesh, {.properties = {}, .colours = {}, .comments = {"a\nb"}}),
      Error);
  TriangleMesh broken = mesh;
  broken.faces[2][1] = 1000;
  EXPECT_THROW(write_mesh(folder.path() / "a.obj", broken), Error);
  broken = mesh;
  broken.positions_m[4].y = std::nan("");
  for (const char* const name : {"a.ply", "a.obj", "a.off", "a.stl"}) {
    EXPECT_THROW(write_mesh(folder.path() / name, broken), Error) << name;
  }
  EXPECT_THROW(write_mesh(folder.path() / "a.gltf", mesh), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace offing::test
