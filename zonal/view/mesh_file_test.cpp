#include "zonal/view/mesh_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "zonal/base/error.h"
#include "zonal/view/mesh_file_samples_test.h"

namespace zonal {
namespace {

constexpr float kFloatEps = std::numeric_limits<float>::epsilon();

TEST(MeshFile, FitsTheUnitBallAndTurnsYUp) {
  // A box of 2 x 6 x 4 somewhere else: half its diagonal is sqrt(14).
  const LoadedMesh box = load_mesh(MeshSample("box.obj", box_obj({10, 20, 30}, {2, 6, 4})));
  EXPECT_EQ(box.format, "OBJ");
  EXPECT_EQ(box.mesh.indices.size(), 36u);
  const double scale = 1 / std::sqrt(14.0);
  int compared = 0;
  for (const Vertex& vertex : box.mesh.vertices) {
    const auto& [x, y, z] = vertex.position;  // of the file: z, x, y
    EXPECT_NEAR(std::abs(x), 2 * scale, kFloatEps);
    EXPECT_NEAR(std::abs(y), 1 * scale, kFloatEps);
    EXPECT_NEAR(std::abs(z), 3 * scale, kFloatEps);
    ++compared;
  }
  EXPECT_GE(compared, 8);
  // As Z-up nothing turns.
  const LoadedMesh upright = load_mesh(MeshSample("box.obj", box_obj({10, 20, 30}, {2, 6, 4})), {.up = MeshUp::kZ});
  EXPECT_NEAR(std::abs(upright.mesh.vertices[0].position[1]), 3 * scale, kFloatEps);
}

TEST(MeshFile, TheFrontOfAYUpModelLooksAtTheEye) {
  // One long arrow along each axis of the file, and where it must be: +Z to -X, +X to -Y, +Y to +Z.
  const LoadedMesh loaded = load_mesh(MeshSample("axes.obj",
                                                 "v 0 0 4\nv 1 0 0\nv 0 2 0\nv 0 0 -4\nv -1 0 0\nv 0 -2 0\n"
                                                 "f 1 2 3\nf 4 5 6\n"));
  ASSERT_EQ(loaded.mesh.vertices.size(), 6u);
  const auto& p = loaded.mesh.vertices;
  EXPECT_NEAR(p[0].position[0], -1, kFloatEps);
  EXPECT_NEAR(p[1].position[1], -0.25, kFloatEps);
  EXPECT_NEAR(p[2].position[2], 0.5, kFloatEps);
}

TEST(MeshFile, MadeNormalsWeightFacesByTheirAngles) {
  // At the corner of a box meet three faces of a right angle each, however many triangles they are cut into.
  const LoadedMesh box = load_mesh(MeshSample("box.obj", box_obj({0, 0, 0}, {2, 2, 2})));
  int compared = 0;
  for (const Vertex& v : box.mesh.vertices) {
    for (int k = 0; k < 3; ++k, ++compared) {
      // Unit, outward, the same share of each face. Angles and their sum: some roundings of doubles, then one float.
      EXPECT_NEAR(v.normal[k], std::copysign(1 / std::sqrt(3.0), v.position[k]), kFloatEps);
    }
  }
  EXPECT_GE(compared, 24);
}

TEST(MeshFile, MadeTextureCoordinatesPassOneAcrossTheSeam) {
  const LoadedMesh box = load_mesh(MeshSample("box.obj", box_obj({0, 0, 0}, {2, 2, 2})));
  int across = 0;
  for (std::size_t i = 0; i < box.mesh.indices.size(); i += 3) {
    float least = 2, greatest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const float u = box.mesh.vertices[box.mesh.indices[i + k]].uv[0];
      least = std::min(least, u), greatest = std::max(greatest, u);
    }
    EXPECT_LE(greatest - least, 0.51f);
    across += greatest > 1;
  }
  EXPECT_GE(across, 2) << "the side that the seam runs through has two triangles at least";
}

TEST(MeshFile, KeepsNormalsAndTextureCoordinatesOfTheFile) {
  const LoadedMesh loaded = load_mesh(
      MeshSample(
          "given.obj",
          "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 5\nvt 0.25 0.75\nvt 1 1\nf 1/1/1 2/2/1 3//1\nf 1/1/1 2/2/1 3/1/1\n"),
      {.up = MeshUp::kZ});
  ASSERT_EQ(loaded.mesh.indices.size(), 6u);
  const Vertex& first = loaded.mesh.vertices[loaded.mesh.indices[3]];
  EXPECT_EQ(first.normal[2], 1);  // unit
  EXPECT_EQ(first.uv[0], 0.25f);
  EXPECT_EQ(first.uv[1], 0.25f);  // from the top
  EXPECT_EQ(loaded.notes.size(), 1u) << "one face lacks a texture coordinate";
}

TEST(MeshFile, LeavesOutFacesWithoutAreaAndSaysSo) {
  const LoadedMesh loaded =
      load_mesh(MeshSample("thin.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 2\n"));
  EXPECT_EQ(loaded.mesh.indices.size(), 3u);
  ASSERT_GE(loaded.notes.size(), 2u);
  EXPECT_NE(loaded.notes[1].find("2 of 3 faces have no area"), std::string::npos) << loaded.notes[1];
}

TEST(MeshFile, EveryFormatGivesTheSameBox) {
  const MeshLoadOptions as_is{.up = MeshUp::kZ};
  const LoadedMesh obj = load_mesh(MeshSample("box.obj", box_obj({0, 0, 0}, {2, 6, 4})), as_is);
  const std::vector<std::pair<std::string, std::string>> others = {
      {"text.ply", box_ply_text()},   {"little.ply", box_ply_binary(false)}, {"big.ply", box_ply_binary(true)},
      {"box.glb", box_glb(kBoxGltf)}, {"box.gltf", box_gltf_with_data()},
  };
  int compared = 0;
  for (const auto& [name, content] : others) {
    const LoadedMesh other = load_mesh(MeshSample(name, content), as_is);
    ASSERT_EQ(other.mesh.indices.size(), obj.mesh.indices.size()) << name;
    for (std::size_t i = 0; i < obj.mesh.indices.size(); ++i, ++compared) {
      const Vertex &a = obj.mesh.vertices[obj.mesh.indices[i]], &b = other.mesh.vertices[other.mesh.indices[i]];
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(a.position[k], b.position[k], kFloatEps) << name;
        EXPECT_NEAR(a.normal[k], b.normal[k], kFloatEps) << name;
      }
    }
  }
  EXPECT_EQ(compared, 5 * 36);
}

TEST(MeshFile, TheMeshesOfOthers) {
  const std::filesystem::path folder = std::filesystem::path(ZONAL_SOURCE_DIR) / "../shared/data/meshes";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "real meshes are not here";
  const std::vector<std::pair<const char*, std::size_t>> files = {
      {"bunny_games202.obj", 2000}, {"bunny_lowres.ply", 948},      {"bunny_mitsuba.ply", 69451},
      {"sphere.ply", 840},          {"bunny_probulator.obj", 4968}, {"teapot.ply", 2256}};
  for (const auto& [name, faces] : files) {
    const LoadedMesh loaded = load_mesh(folder / name);
    const std::size_t triangles = loaded.mesh.indices.size() / 3;
    EXPECT_LE(triangles, faces) << name;
    EXPECT_GT(triangles, faces * 9 / 10) << name;
    float farthest = 0;
    for (const Vertex& v : loaded.mesh.vertices) {
      const auto square = [](const float(&x)[3]) { return x[0] * x[0] + x[1] * x[1] + x[2] * x[2]; };
      farthest = std::max(farthest, square(v.position));
      ASSERT_NEAR(square(v.normal), 1, 4 * kFloatEps) << name;
    }
    EXPECT_NEAR(farthest, 1, 4 * kFloatEps) << name;
  }
}

}  // namespace
}  // namespace zonal
