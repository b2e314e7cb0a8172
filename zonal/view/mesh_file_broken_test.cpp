// Every byte of a mesh file is its author's, who may mean harm.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <stop_token>

#include "zonal/base/error.h"
#include "zonal/view/mesh_file.h"
#include "zonal/view/mesh_file_samples_test.h"

namespace zonal {
namespace {

/// The message; fails the test where there is none, or no kind of input.
std::string refusal(const std::string& name, const std::string& content, const MeshLoadOptions& options = {}) {
  const MeshSample file(name, content);
  try {
    load_mesh(file, options);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::kInput);
    EXPECT_FALSE(e.hint().empty()) << e.what() << " has no hint";
    return e.what();
  }
  ADD_FAILURE() << name << " was taken";
  return {};
}

void expect_refusal(const std::string& name, const std::string& content, const std::string& part) {
  const std::string message = refusal(name, content);
  EXPECT_NE(message.find(part), std::string::npos) << message;
  EXPECT_NE(message.find(name), std::string::npos) << message << " does not name its file";
}

TEST(BrokenMeshFile, SaysWhatIsWrongWithAnObj) {
  expect_refusal("a.obj", "", "no mesh file");
  expect_refusal("a.obj", std::string("\0\1\2", 3), "no mesh file");
  expect_refusal("a.obj", "hello world\n", "no face");
  expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no face");
  expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "vertex 3 of 3");
  expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999\n", "of 3");
  expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "line 4");
  expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "'0'");
  expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/5 2 3\n", "texture coordinate 4 of 0");
  expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2 3\n", "normal 0 of 0");
  expect_refusal("a.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n", "vertex 1 is not finite");
  expect_refusal("a.obj", "v 0 0 0\nv 1 1e999 0\nv 0 1 0\nf 1 2 3\n", "1e999");
  expect_refusal("a.obj", "v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n", "line 2");
  expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "area");
  expect_refusal("a.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "one place");
  expect_refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 inf 0\nf 1//1 2//1 3//1\n", "normal 0 is not finite");
}

TEST(BrokenMeshFile, TakesTheGreatestNumbersThereAre) {
  const MeshSample file("great.obj", "v -1.7e308 -1.7e308 0\nv 1.7e308 0 0\nv 0 1.7e308 1e308\nf 1 2 3\n");
  const LoadedMesh loaded = load_mesh(file);
  ASSERT_EQ(loaded.mesh.vertices.size(), 3u);
  for (const Vertex& v : loaded.mesh.vertices) {
    for (int k = 0; k < 3; ++k) EXPECT_LE(std::abs(v.position[k]), 1);
  }
  const MeshSample tiny("tiny.obj", "v 0 0 0\nv 1e-310 0 0\nv 0 1e-310 0\nf 1 2 3\n");
  EXPECT_EQ(load_mesh(tiny).mesh.vertices.size(), 3u);
}

TEST(BrokenMeshFile, SaysWhatIsWrongWithAPly) {
  expect_refusal("a.ply", "ply\n", "no end");
  expect_refusal("a.ply", "ply\nformat ascii 1.0\nend_header\n", "no faces");
  expect_refusal("a.ply", "ply\nelement vertex 1\nproperty float x\nend_header\n0\n", "no format");
  expect_refusal("a.ply", replaced(box_ply_text(), "ascii", "morse"), "morse");
  expect_refusal("a.ply", replaced(box_ply_text(), "float x", "quad x"), "quad");
  expect_refusal("a.ply", replaced(box_ply_text(), "float x", "float w"), "x, y and z");
  expect_refusal("a.ply", replaced(box_ply_text(), "vertex 8", "vertex 18446744073709551615"), "ends early");
  expect_refusal("a.ply", replaced(box_ply_text(), "vertex 8", "vertex 800"), "ends early");
  expect_refusal("a.ply", replaced(box_ply_text(), "face 6", "face 7"), "ends early");
  expect_refusal("a.ply", replaced(box_ply_text(), "face 6", "nothing 6"), "no faces");
  expect_refusal("a.ply", replaced(box_ply_text(), "edge 1\nproperty int a", "edge 1000000000000"), "ends early");
  expect_refusal("a.ply", replaced(box_ply_text(), "4 1 3 7 5", "4 1 3 7 8"), "vertex 8 of 8");
  expect_refusal("a.ply", replaced(box_ply_text(), "4 1 3 7 5", "4 1 3 7 -1"), "of 8");
  expect_refusal("a.ply", replaced(box_ply_text(), "4 1 3 7 5", "4 1 3 7 nan"), "of 8");
  expect_refusal("a.ply", replaced(box_ply_text(), "4 1 3 7 5", "9e99 1 3 7 5"), "ends early");
  expect_refusal("a.ply", replaced(box_ply_text(), "1.000000", "nan"), "not finite");
  expect_refusal("a.ply", replaced(box_ply_text(), "-3.000000", "three"), "three");
}

TEST(BrokenMeshFile, SaysWhatIsWrongWithAGltf) {
  const auto glb = [](const std::string& what, const std::string& by) { return box_glb(replaced(kBoxGltf, what, by)); };
  expect_refusal("a.gltf", "{", "no JSON");
  expect_refusal("a.gltf", "{}", "no glTF");
  expect_refusal("a.gltf", std::string(2'000'000, '[').insert(0, "{\"a\":"), "no JSON");
  expect_refusal("a.glb", "glTF", "ends early");
  expect_refusal("a.glb", glb("\"2.0\"", "\"1.0\""), "version");
  expect_refusal("a.glb", glb("\"children\":[1]", "\"children\":[0]"), "two parents");
  expect_refusal("a.glb", glb("\"children\":[1]", "\"children\":[1,1]"), "two parents");
  expect_refusal("a.glb", glb("\"children\":[1]", "\"children\":[7]"), "'nodes'");
  expect_refusal("a.glb", glb("\"children\":[1]", "\"children\":[-1]"), "no number");
  expect_refusal("a.glb", glb("[1,2,3]", "[1,2]"), "node");
  expect_refusal("a.glb", glb("[1,2,3]", "[1e300,1e300,1e300]"), "one place");
  expect_refusal("a.glb", glb("\"mesh\":0", "\"mesh\":1"), "'meshes'");
  expect_refusal("a.glb", glb("\"count\":8", "\"count\":9"), "reaches out");
  expect_refusal("a.glb", glb("\"count\":8", "\"count\":18446744073709551615"), "reaches out");
  expect_refusal("a.glb", glb("\"count\":8", "\"count\":4"), "of 4");
  expect_refusal("a.glb", glb("\"count\":8", "\"count\":0"), "of 0");
  expect_refusal("a.glb", glb("\"byteOffset\":96", "\"byteOffset\":18446744073709551615"), "reaches out");
  expect_refusal("a.glb", glb("\"byteLength\":96", "\"byteLength\":96,\"byteStride\":4"), "reaches out");
  expect_refusal("a.glb", glb("5126", "5125"), "integers");
  expect_refusal("a.glb", glb("5126", "1"), "type 1");
  expect_refusal("a.glb", glb("\"VEC3\"", "\"VEC2\""), "components");
  expect_refusal("a.glb", glb("\"VEC3\"", "\"VEC3\",\"sparse\":{}"), "sparse");
  expect_refusal("a.glb", glb("\"byteLength\":168", "\"byteLength\":169"), "ends early");
  expect_refusal("a.glb", glb("\"scene\":0", "\"scene\":0,\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]"),
                 "KHR_draco_mesh_compression");
  expect_refusal("a.gltf", replaced(kBoxGltf, "BUFFER", "\"uri\":\"data:;base64,!!!\","), "base64");
  expect_refusal("a.gltf", replaced(kBoxGltf, "BUFFER", ""), "nowhere");
}

TEST(BrokenMeshFile, AGltfOpensNoFileOutsideItsFolder) {
  const auto with = [](const std::string& address) {
    return replaced(kBoxGltf, "BUFFER", fmt::format(R"("uri":"{}",)", address));
  };
  for (const char* address : {"/etc/passwd", "../other/box.bin", "%2e%2e/box.bin", "sub/../../box.bin",
                              "file:///etc/passwd", "https://example.org/box.bin", "", ".", "%00", "..\\\\box.bin"}) {
    expect_refusal("a.gltf", with(address), "folder");
  }
  {  // a link that leads out
    const MeshSample elsewhere("box.bin", box_buffer());
    const MeshSample file("a.gltf", with("box.bin"));
    std::filesystem::create_symlink(elsewhere,
                                    static_cast<const std::filesystem::path&>(file).parent_path() / "box.bin");
    EXPECT_THROW(load_mesh(file), Error);
  }
  const MeshSample file("a.gltf", with("the%20box.bin"));
  EXPECT_THROW(load_mesh(file), Error) << "it is missing";
  file.add("the box.bin", box_buffer());
  EXPECT_EQ(load_mesh(file).mesh.indices.size(), 36u);
}

TEST(BrokenMeshFile, LimitsHoldBeforeMemoryIsTaken) {
  EXPECT_NE(refusal("a.ply", box_ply_binary(false), {.max_triangles = 11}).find("more than 11"), std::string::npos);
  EXPECT_NE(refusal("a.ply", box_ply_binary(false), {.max_triangles = 2}).find("8 vertices"), std::string::npos);
  EXPECT_NE(refusal("a.obj", box_obj({}, {1, 1, 1}), {.max_bytes = 100}).find("a.obj"), std::string::npos);
  // A cascade of nodes, each with a dozen of triangles.
  std::string nodes, all;
  for (int i = 0; i < 1000; ++i) {
    nodes += i == 0 ? "" : ",";
    nodes += "{\"mesh\":0}";
    all += fmt::format("{}{}", i == 0 ? "" : ",", i);
  }
  std::string many = replaced(
      kBoxGltf, R"({"children":[1],"translation":[1,2,3]},{"mesh":0,"scale":[2,2,2],"rotation":[0,0,0,1]})", nodes);
  many = replaced(many, "\"nodes\":[0]", fmt::format(R"("nodes":[{}])", all));
  EXPECT_NE(refusal("a.glb", box_glb(many), {.max_triangles = 11'999}).find("more than 11999"), std::string::npos);
  EXPECT_EQ(load_mesh(MeshSample("a.glb", box_glb(many)), {.max_triangles = 12'000}).mesh.indices.size(), 36'000u);
}

TEST(BrokenMeshFile, IsCancelled) {
  std::stop_source stop;
  stop.request_stop();
  const MeshSample file("a.ply", box_ply_binary(false));
  try {
    load_mesh(file, {}, {.stop = stop.get_token()});
    FAIL() << "it went on";
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::kCancelled);
  }
}

/// Whatever happens to the bytes: a mesh whose every index is in range and every number finite, or an Error.
int check_harmless(const std::string& name, const std::string& content) {
  const MeshSample file(name, content);
  try {
    const LoadedMesh loaded = load_mesh(file);
    for (const std::uint32_t index : loaded.mesh.indices) EXPECT_LT(index, loaded.mesh.vertices.size());
    for (const Vertex& v : loaded.mesh.vertices) {
      for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::isfinite(v.position[k]) && std::isfinite(v.normal[k]));
    }
    return 1;
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::kInput) << e.what();
    return 0;
  }
}

TEST(BrokenMeshFile, CutOffOrChangedItIsAMeshOrAMessage) {
  const std::vector<std::pair<std::string, std::string>> files = {{"a.obj", box_obj({1, 2, 3}, {2, 6, 4})},
                                                                  {"a.ply", box_ply_text()},
                                                                  {"b.ply", box_ply_binary(true)},
                                                                  {"a.glb", box_glb(kBoxGltf)},
                                                                  {"a.gltf", box_gltf_with_data()}};
  std::mt19937 random(5);
  int tried = 0, taken = 0;
  for (const auto& [name, content] : files) {
    for (std::size_t length = 0; length < content.size(); length += 7, ++tried) {
      taken += check_harmless(name, content.substr(0, length));
    }
    for (int i = 0; i < 150; ++i, ++tried) {
      std::string changed = content;
      changed[random() % changed.size()] = static_cast<char>(random() % 256);
      taken += check_harmless(name, changed);
    }
  }
  EXPECT_GT(tried, 1000);
  EXPECT_GT(taken, 20) << "changes that nobody would notice are among them";
  EXPECT_LT(taken, tried - 500);
}

}  // namespace
}  // namespace zonal
