#include "zonal/io/engine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>

#include "zonal/base/error.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"
#include "zonal/sh/zonal.h"

namespace zonal {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr Vec3 kAxes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// Radiance 1/2 everywhere, and a red blob at +X, a green one at +Y, a blue one at +Z.
ShFile colored_blobs(int bands) {
  std::vector<double> blob;
  for (int l = 0; l < bands; ++l) blob.push_back(1.0 / (1 + l));
  ShFile file{ShQuantity::kRadiance, Sh<RgbD>(bands)};
  const RgbD colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int axis = 0; axis < 3; ++axis) file.coefficients += colors[axis] * zonal_toward(blob, kAxes[axis]);
  file.coefficients[0] += RgbD{1, 1, 1};
  return file;
}

RgbD sum_of(std::initializer_list<std::pair<double, RgbD>> terms) {
  RgbD sum;
  for (const auto& [factor, number] : terms) sum += factor * number;
  return sum;
}

/// What a program computes from its nine numbers: E, the formulas as published for each, with their typed constants.
RgbD irradiance_as_evaluated_by(std::string_view engine, const std::vector<RgbD>& c, Vec3 n) {
  const auto [x, y, z] = n;
  if (engine == "filament" || engine == "unity") {  // E/pi
    return kPi * sum_of({{1, c[0]},
                         {y, c[1]},
                         {z, c[2]},
                         {x, c[3]},
                         {x * y, c[4]},
                         {y * z, c[5]},
                         {3 * z * z - 1, c[6]},
                         {x * z, c[7]},
                         {x * x - y * y, c[8]}});
  }
  if (engine == "playcanvas") {
    return kPi * sum_of({{1, c[0]},
                         {x, c[1]},
                         {y, c[2]},
                         {z, c[3]},
                         {x * z, c[4]},
                         {z * y, c[5]},
                         {y * x, c[6]},
                         {3 * z * z - 1, c[7]},
                         {x * x - y * y, c[8]}});
  }
  if (engine.starts_with("babylon")) {  // E/pi in the basis with the Condon-Shortley sign
    return kPi * sum_of({{.282095, c[0]},
                         {-.488603 * y, c[1]},
                         {.488603 * z, c[2]},
                         {-.488603 * x, c[3]},
                         {1.092548 * x * y, c[4]},
                         {-1.092548 * y * z, c[5]},
                         {.315392 * (3 * z * z - 1), c[6]},
                         {-1.092548 * x * z, c[7]},
                         {.546274 * (x * x - y * y), c[8]}});
  }
  if (engine == "gltf") {  // E
    return sum_of({{.282095, c[0]},
                   {.488603 * y, c[1]},
                   {.488603 * z, c[2]},
                   {.488603 * x, c[3]},
                   {1.092548 * x * y, c[4]},
                   {1.092548 * y * z, c[5]},
                   {.315392 * (3 * z * z - 1), c[6]},
                   {1.092548 * x * z, c[7]},
                   {.546274 * (x * x - y * y), c[8]}});
  }
  const double s = engine == "unreal" || engine == "directx" ? -1 : 1;
  return sum_of({{.886227, c[0]},
                 {s * 1.023327 * y, c[1]},
                 {1.023327 * z, c[2]},
                 {s * 1.023327 * x, c[3]},  // radiance
                 {.858086 * x * y, c[4]},
                 {s * .858086 * y * z, c[5]},
                 {.247708 * (3 * z * z - 1), c[6]},
                 {s * .858086 * x * z, c[7]},
                 {.429043 * (x * x - y * y), c[8]}});
}

TEST(Engine, ColoredBlobsSurviveTheTripThroughEachConvention) {
  const ShFile light = colored_blobs(3);
  const Sh<RgbD> expected = irradiance(light.coefficients);
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  int compared = 0;
  for (const EngineConvention& engine : all_engines()) {
    const std::vector<RgbD> numbers = engine_coefficients(light, engine);
    ASSERT_EQ(numbers.size(), 9u);
    std::vector<Vec3> normals(std::begin(kAxes), std::end(kAxes));
    for (int i = 0; i < 30; ++i) normals.push_back(normalize({normal(random), normal(random), normal(random)}));
    for (const Vec3 n : normals) {
      const Vec3 lookup = engine.sh_from_engine * (engine.engine_from_world * n);
      const RgbD seen = irradiance_as_evaluated_by(engine.name, numbers, lookup), truth = evaluate(expected, n);
      constexpr double kTyped = 1e-5;  // nine terms of order one with constants of six digits
      EXPECT_NEAR(seen.r, truth.r, kTyped) << engine.name;
      EXPECT_NEAR(seen.g, truth.g, kTyped) << engine.name;
      EXPECT_NEAR(seen.b, truth.b, kTyped) << engine.name;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 12 * 33);
  const RgbD on_x = evaluate(expected, {1, 0, 0}), on_z = evaluate(expected, {0, 0, 1});
  EXPECT_GT(on_x.r, 1.2 * on_x.g);  // the blobs tell the axes apart
  EXPECT_GT(on_z.b, 1.2 * on_z.r);
}

TEST(Engine, AFurnaceHasThePublishedNumbers) {
  ShFile furnace{ShQuantity::kRadiance, Sh<RgbD>(3)};
  furnace.coefficients[0] = {3.544908, 3.544908, 3.544908};  // sqrt(4 pi) in the digits that are published everywhere
  int engines = 0;
  for (const EngineConvention& engine : all_engines()) {
    const std::vector<RgbD> numbers = engine_coefficients(furnace, engine);
    double expected = 3.544908;                                          // radiance, or E/pi, in an orthonormal basis
    if (engine.sh.times_constants) expected = 1;                         // Filament, Unity, PlayCanvas: c0 = 1
    if (engine.sh.quantity == ShQuantity::kIrradiance) expected *= kPi;  // glTF
    EXPECT_NEAR(numbers[0].g, expected, 1e-6 * expected) << engine.name;
    for (std::size_t i = 1; i < 9; ++i) EXPECT_NEAR(numbers[i].g, 0, 1e-14) << engine.name;
    EXPECT_NEAR(irradiance_as_evaluated_by(engine.name, numbers, {0.6, 0, 0.8}).b, kPi, 1e-5) << engine.name;
    ++engines;
  }
  EXPECT_EQ(engines, 12);
}

TEST(Engine, NumbersReadBackAsTheLightTheyWere) {
  const ShFile light = colored_blobs(3);
  int compared = 0;
  for (const EngineConvention& engine : all_engines()) {
    const ShFile back = from_engine_coefficients(engine_coefficients(light, engine), engine);
    EXPECT_EQ(back.quantity, engine.sh.quantity);
    const ShFile radiance = to_quantity(back, ShQuantity::kRadiance);
    for (std::size_t i = 0; i < 9; ++i, ++compared) {
      const double allowed = 64 * kEps;  // two sums over 36 directions, of terms of order one
      EXPECT_NEAR(radiance.coefficients[i].r, light.coefficients[i].r, allowed) << engine.name;
      EXPECT_NEAR(radiance.coefficients[i].g, light.coefficients[i].g, allowed) << engine.name;
      EXPECT_NEAR(radiance.coefficients[i].b, light.coefficients[i].b, allowed) << engine.name;
    }
  }
  EXPECT_EQ(compared, 12 * 9);
  EXPECT_EQ(engine_coefficients(light, *engine_named("blender"))[5],
            light.coefficients[5]);  // identity: no bit changes
}

TEST(Engine, MirrorsFlipThePublishedSigns) {
  const ShFile light = colored_blobs(5);
  const Rotation x_flip{{Vec3{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, y_flip{{Vec3{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}},
      z_flip{{Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}};
  const Sh<RgbD> x = transformed(light.coefficients, x_flip), y = transformed(light.coefficients, y_flip),
                 z = transformed(light.coefficients, z_flip);
  int compared = 0;
  for (int l = 0; l < 5; ++l) {
    for (int m = -l; m <= l; ++m, ++compared) {
      const double old = light.coefficients(l, m).g + 2 * light.coefficients(l, m).r;
      const auto of = [&](const Sh<RgbD>& sh) { return sh(l, m).g + 2 * sh(l, m).r; };
      const bool odd = m % 2 != 0;
      EXPECT_NEAR(of(x), ((m > 0 && odd) || (m < 0 && !odd) ? -1 : 1) * old, 1e-14);
      EXPECT_NEAR(of(y), (m < 0 ? -1 : 1) * old, 1e-14);
      EXPECT_NEAR(of(z), ((l + m) % 2 != 0 ? -1 : 1) * old, 1e-14);
    }
  }
  EXPECT_EQ(compared, 25);
}

TEST(Engine, AnyTurnMovesTheFunction) {
  const ShFile light = colored_blobs(6);
  const Rotation turn =
      Rotation::about(normalize({1, 2, -0.5}), 0.7) * Rotation{{Vec3{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}};
  const Sh<RgbD> turned = transformed(light.coefficients, turn);
  int compared = 0;
  for (int i = 0; i < 50; ++i, ++compared) {
    const Vec3 d = normalize({std::cos(i * 1.1), std::sin(i * 2.3), std::cos(i * 0.7) + 0.1});
    EXPECT_NEAR(evaluate(turned, turn * d).r, evaluate(light.coefficients, d).r, 1e-13);
  }
  EXPECT_EQ(compared, 50);
}

// Measured: where each program's own loader puts a panorama's centre, right and top.
TEST(Engine, PanoramasLieWhereTheProgramsPutThem) {
  const struct {
    std::string_view name;
    Vec3 centre, right, top;
    double handedness;
  } measured[] = {
      {"three", {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1},
      {"babylon", {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, -1},
      {"playcanvas", {0, 0, 1}, {-1, 0, 0}, {0, 1, 0}, 1},
      {"babylon-right-handed", {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 1},
      {"unity", {1, 0, 0}, {0, 0, -1}, {0, 1, 0}, -1},
      {"unreal", {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, -1},
      {"blender", {1, 0, 0}, {0, -1, 0}, {0, 0, 1}, 1},
      {"filament", {0, 0, 1}, {-1, 0, 0}, {0, 1, 0}, 1},
      {"godot", {0, 0, 1}, {-1, 0, 0}, {0, 1, 0}, 1},
      {"gltf", {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1},
      {"opengl", {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 1},
      {"directx", {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, -1},
  };
  std::set<std::string_view> names;
  for (const auto& [name, centre, right, top, handedness] : measured) {
    const EngineConvention* engine = engine_named(name);
    ASSERT_NE(engine, nullptr) << name;
    EXPECT_EQ(engine->engine_from_world * Vec3({1, 0, 0}), centre) << name;
    EXPECT_EQ(engine->engine_from_world * Vec3({0, -1, 0}), right) << name;
    EXPECT_EQ(engine->engine_from_world * Vec3({0, 0, 1}), top) << name;
    EXPECT_EQ(determinant(engine->engine_from_world), handedness) << name;
    names.insert(name);
  }
  EXPECT_EQ(names.size(), all_engines().size());
  EXPECT_EQ(engine_named("lumberyard"), nullptr);
}

TEST(Engine, ThePublishedLookupsOfCubes) {
  // Both modes of Babylon read the same file: the flip makes up for the other hand.
  EXPECT_EQ(engine_named("babylon")->cube_from_world(), engine_named("babylon-right-handed")->cube_from_world());
  EXPECT_EQ(engine_named("three")->cube_from_world() * Vec3({1, 0, 0}), (Vec3{-1, 0, 0}));
  EXPECT_EQ(engine_named("filament")->cube_from_world() * Vec3({1, 0, 0}), (Vec3{0, 0, 1}));
  int orthogonal = 0;
  for (const EngineConvention& engine : all_engines()) {
    const Rotation m = engine.cube_from_world();
    orthogonal += transpose(m) * m == Rotation() && std::abs(determinant(m)) == 1;
  }
  EXPECT_EQ(orthogonal, 12);
}

TEST(Engine, RefusesWhatAProgramCannotTake) {
  EXPECT_THROW((void)engine_coefficients(colored_blobs(4), *engine_named("filament")), Error);
  EXPECT_NO_THROW((void)engine_coefficients(colored_blobs(4), *engine_named("directx")));
  EXPECT_NO_THROW((void)engine_coefficients(colored_blobs(2), *engine_named("playcanvas")));
  EXPECT_THROW((void)from_engine_coefficients(std::vector<RgbD>(8), *engine_named("unity")), Error);
  EXPECT_THROW((void)from_engine_coefficients({}, *engine_named("opengl")), Error);
  EXPECT_THROW((void)from_engine_coefficients(std::vector<RgbD>(4), *engine_named("playcanvas")), Error);
  EXPECT_THROW((void)transformed(Sh<RgbD>(2), Rotation{{Vec3{2, 0, 0}, {0, 1, 0}, {0, 0, 1}}}), std::logic_error);
  const Rotation turn = Rotation::about_x(1);
  EXPECT_THROW((void)transformed(Sh<RgbD>(33), turn), Error);
}

}  // namespace
}  // namespace zonal
