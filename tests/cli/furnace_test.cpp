#include <cmath>

#include "tests/cli/command.h"
#include "zonal/io/file.h"
#include "zonal/io/ktx2.h"
#include "zonal/io/sh_json.h"
#include "zonal/sphere/mapping.h"

namespace zonal {
namespace {

// A white furnace comes out white through every verb, projection and file format.

constexpr double kWhite = 1e-6;

using CliFurnace = Cli;

TEST_F(CliFurnace, ThroughEveryProjection) {
  int converted = 0;
  for (const Layout layout : all_layouts()) {
    const std::string name(name_of(layout));
    good({"sky", "furnace", "--to", name, "--size", "32", "-o", "in.exr", "-q"});
    good({"convert", "in.exr", "--from", name, "--to", "equirect", "--size", "16", "-o", "out.exr", "-q"});
    EXPECT_LE(worst_from(pixels_of(path("out.exr")), 1), kWhite) << name;
    good({"convert", "in.exr", "--from", name, "--to", "cube", "--rotate", "20,30,40", "-o", "out.exr", "-q"});
    EXPECT_LE(worst_from(pixels_of(path("out.exr")), 1), kWhite) << name;
    converted += 2;
  }
  EXPECT_EQ(converted, 28);
}

TEST_F(CliFurnace, OutOfEveryProjectionOnlyItsOwnTexelsAreWhite) {
  good({"sky", "furnace", "--size", "32", "-o", "in.exr", "-q"});
  int white = 0;
  for (const Layout layout : all_layouts()) {
    const std::string name(name_of(layout));
    good({"convert", "in.exr", "--to", name, "--size", "16", "-o", "out.exr", "-q"});
    const Image<Rgb> pixels = pixels_of(path("out.exr"));
    const Mapping mapping({layout}, {pixels.width(), pixels.height()});
    for (int y = 0; y < pixels.height(); ++y) {
      for (int x = 0; x < pixels.width(); ++x) {
        const double expected = mapping.texel_direction(x, y) ? 1 : 0;
        ASSERT_NEAR(pixels(x, y).g, expected, kWhite) << name << " " << x << " " << y;
        white += expected == 1;
      }
    }
  }
  EXPECT_GT(white, 14 * 180);
}

TEST_F(CliFurnace, ThroughEveryFormat) {
  good({"sky", "furnace", "--size", "16", "-o", "in.exr", "-q"});
  const std::vector<std::vector<std::string>> outputs = {{"o.exr"}, {"o.exr", "--half"}, {"o.hdr"},
                                                         {"o.pfm"}, {"o.png"},           {"o.png", "--png16"}};
  int formats = 0;
  for (const auto& output : outputs) {
    std::vector<std::string> words = {"convert", "in.exr", "-o"};
    words.insert(words.end(), output.begin(), output.end());
    good(words);
    good({"convert", output[0], "-o", "back.pfm", "-q"});
    EXPECT_LE(worst_from(pixels_of(path("back.pfm")), 1), kWhite) << output[0];
    ++formats;
  }
  EXPECT_EQ(formats, 6);
  for (const std::string precision : {"", "--float32"}) {
    std::vector<std::string> words = {"convert", "in.exr", "--to", "cube", "--size", "8", "-o", "o.ktx2"};
    if (!precision.empty()) words.push_back(precision);
    good(words);
    EXPECT_EQ(worst_from(decode_ktx2(read_file(path("o.ktx2"))).chain.levels.at(0), 1), 0);
  }
}

TEST_F(CliFurnace, ThroughIrradianceAndPrefilter) {
  int maps = 0;
  for (const Layout layout : all_layouts()) {
    const std::string name(name_of(layout));
    good({"sky", "furnace", "--to", name, "--size", "32", "-o", "in.exr", "-q"});
    good({"irradiance", "in.exr", "--from", name, "-o", "e.exr", "--size", "16", "--quantity", "irradiance/pi", "-q"});
    EXPECT_LE(worst_from(pixels_of(path("e.exr")), 1), kWhite) << name;
    good({"prefilter", "in.exr", "--from", name, "-o", "p.exr", "--size", "16", "--roughness", "0.3", "-q"});
    EXPECT_LE(worst_from(pixels_of(path("p.exr")), 1), kWhite) << name;
    maps += 2;
  }
  EXPECT_EQ(maps, 28);
}

TEST_F(CliFurnace, ThroughSphericalHarmonics) {
  int projected = 0;
  for (const Layout layout : all_layouts()) {
    const std::string name(name_of(layout));
    good({"sky", "furnace", "--to", name, "--size", "32", "-o", "in.exr", "-q"});
    const ShFile sh = parse_sh_json(good({"sh", "in.exr", "--from", name, "--bands", "1"}).out);
    EXPECT_NEAR(sh.coefficients(0, 0).r / std::sqrt(4 * kPi), 1, kWhite) << name;
    ++projected;
  }
  EXPECT_EQ(projected, 14);
}

TEST_F(CliFurnace, ThroughTheWholeBake) {
  good({"sky", "furnace", "--size", "64", "-o", "in.exr", "-q"});
  good({"bake", "in.exr", "-o", "half", "--size", "32", "--dfg-size", "8"});
  good({"bake", "in.exr", "-o", "full", "--size", "32", "--dfg-size", "8", "--float32"});
  int levels = 0;
  for (const std::string folder : {"half", "full"}) {
    // 1 is a half, and rounding to a half removes a float's last bits; pi is not, and is off by half a step of 11 bits
    // at most.
    const double one = folder == "half" ? 0 : kWhite, pi = folder == "half" ? 1.0 / 1024 : kPi * kWhite;
    for (const Image<Rgb>& level : decode_ktx2(read_file(path(folder + "/specular.ktx2"))).chain.levels) {
      EXPECT_LE(worst_from(level, 1), one);
      ++levels;
    }
    EXPECT_LE(worst_from(decode_ktx2(read_file(path(folder + "/environment.ktx2"))).chain.levels.at(0), 1), one);
    EXPECT_LE(worst_from(decode_ktx2(read_file(path(folder + "/irradiance.ktx2"))).chain.levels.at(0), kPi), pi);
  }
  EXPECT_EQ(levels, 4);
  const ShFile sh = parse_sh_json(bytes_of(path("half/sh.json")));
  EXPECT_NEAR(sh.coefficients(0, 0).r / std::sqrt(4 * kPi), 1, kWhite);
}

}  // namespace
}  // namespace zonal
