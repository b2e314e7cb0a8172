// The answer to the homework in examples/homework is drawn and compared with the library.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "zonal/base/error.h"
#include "zonal/gl/context.h"
#include "zonal/gl/program.h"
#include "zonal/gl/target.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"
#include "zonal/view/homework_lights.h"
#include "zonal/view/mesh.h"
#include "zonal/view/view_state.h"

namespace zonal {
namespace {

std::string example(const char* name) {
  std::stringstream text;
  text << std::ifstream(std::filesystem::path(ZONAL_SOURCE_DIR) / "examples" / "homework" / name).rdbuf();
  return text.str();
}

TEST(Homework, TheAnswerInTheExamplesIsTheIrradiance) {
  std::unique_ptr<OffscreenContext> context;
  try {
    context = std::make_unique<OffscreenContext>();
  } catch (const Error&) {
    GTEST_SKIP() << "no OpenGL without a display";
  }
  const GpuProgram program(example("homework.vert"), example("homework.frag"), "the homework");
  constexpr int kSize = 64;
  const DrawTarget target(kSize, kSize);
  const Mesh mesh = sphere_mesh();
  unsigned array = 0, buffers[2] = {};
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)), mesh.vertices.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * 4), mesh.indices.data(),
               GL_STATIC_DRAW);
  for (const unsigned place : {0u, 1u}) {  // three numbers each: OpenGL makes the fourth 1
    glEnableVertexAttribArray(place);
    const std::size_t offset = place == 0 ? offsetof(Vertex, position) : offsetof(Vertex, normal);
    glVertexAttribPointer(place, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(offset));
  }

  const CameraMatrices camera = camera_matrices({.yaw_deg = 140, .pitch_deg = 35}, 1);
  int compared = 0;
  for (const HomeworkLight& light : homework_lights()) {
    target.bind();
    glEnable(GL_DEPTH_TEST);
    glClearColor(-1, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    program.use();
    program.set_matrix("mc", camera.clip_from_world);
    // The axes of the tables: right, up, toward the middle of the map.
    program.set_matrix("mg", std::array<float, 16>{0, 0, 1, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1});
    std::array<float, 27> sh;
    for (std::size_t i = 0; i < 27; ++i) sh[i] = static_cast<float>(light.coefficients[i / 3][i % 3]);
    program.set_vectors("sh", 3, sh);
    glDrawElements(GL_TRIANGLES, static_cast<int>(mesh.indices.size()), GL_UNSIGNED_INT, nullptr);
    const Image<Rgb> drawn = target.read();

    const Sh<RgbD, 3> e = irradiance(homework_radiance(light));
    const double half = std::tan(radians(20)), yaw = radians(140), pitch = radians(35);
    const Vec3 back = {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)};
    const Vec3 right = {-std::sin(yaw), std::cos(yaw), 0}, up = cross(back, right), eye = 3.2 * back;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const Vec3 ray =
            normalize(half * (2 * (x + 0.5) / kSize - 1) * right + half * (1 - 2 * (y + 0.5) / kSize) * up - back);
        const double b = dot(eye, ray), square = b * b - (dot(eye, eye) - 1);
        if (square < 0.1) continue;  // the rim of a ball of flat pieces
        const Vec3 n = eye + (-b - std::sqrt(square)) * ray;
        const RgbD truth = 0.8 / kPi * evaluate(e, n);
        EXPECT_NEAR(drawn(x, y).r, std::max(truth.r, 0.0), 0.01) << light.name << " " << x << " " << y;
        EXPECT_NEAR(drawn(x, y).b, std::max(truth.b, 0.0), 0.01) << light.name << " " << x << " " << y;
        ++compared;
      }
    }
  }
  glDeleteVertexArrays(1, &array);
  glDeleteBuffers(2, buffers);
  EXPECT_GT(compared, 10000);
}

}  // namespace
}  // namespace zonal
