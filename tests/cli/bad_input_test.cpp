#include <limits>

#include "tests/cli/command.h"

namespace zonal {
namespace {

using CliBadInput = Cli;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

/// Every verb that reads an environment refuses this input in the same way.
const std::vector<std::vector<std::string>> kReaders = {{"bake", "-o", "out", "--size", "16"},
                                                        {"convert", "-o", "c.exr"},
                                                        {"irradiance", "-o", "i.exr"},
                                                        {"prefilter", "-o", "p.exr", "--roughness", "0.5"},
                                                        {"sh", "-o", "sh.json"},
                                                        {"lights", "-o", "lights.json"},
                                                        {"ambient-cube", "-o", "cube.json"},
                                                        {"shader", "-o", "sh.glsl"}};

std::vector<std::string> with_input(const std::vector<std::string>& call, const std::string& input) {
  std::vector<std::string> words = {call[0], input};
  words.insert(words.end(), call.begin() + 1, call.end());
  return words;
}

TEST_F(CliBadInput, EveryReaderRefusesTheSameFiles) {
  write("text.exr", "this is not a picture, whatever it is called\n");
  write("empty.png", "");
  write_pfm("odd.pfm", 5, 4, std::vector<float>(60, 1));
  write_pfm("nan.pfm", 4, 2, {1, 1, 1, kNan, 1, 1, 1, 1});
  write_pfm("inf.pfm", 4, 2, {1, 1, 1, 1, kInf, 1, 1, -kInf});
  write_pfm("one.pfm", 1, 1, {1, 1, 1});
  // A picture of two billion pixels in a few bytes.
  write("huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32768 +X 65536\n\2\2\1");
  const std::vector<std::pair<std::string, std::string>> inputs = {{"missing.exr", "missing.exr"},
                                                                   {"text.exr", "not a picture"},
                                                                   {"empty.png", "empty"},
                                                                   {"odd.pfm", "5x4"},
                                                                   {"nan.pfm", "1 NaN, 0 infinite"},
                                                                   {"inf.pfm", "0 NaN, 2 infinite"},
                                                                   {"one.pfm", "1x1"},
                                                                   {"huge.hdr", "raise --max-pixels"}};
  int refused = 0;
  for (const auto& call : kReaders) {
    for (const auto& [input, says] : inputs) {
      bad(3, with_input(call, input), says);
      ++refused;
    }
  }
  EXPECT_EQ(refused, 64);
}

TEST_F(CliBadInput, Truncated) {
  good({"sky", "daylight", "-o", "sky.exr", "--size", "64"});
  good({"convert", "sky.exr", "-o", "sky.hdr"});
  good({"convert", "sky.exr", "-o", "sky.png"});
  good({"convert", "sky.exr", "-o", "sky.pfm"});
  int cut = 0;
  for (const std::string extension : {"exr", "hdr", "png", "pfm"}) {
    const std::string whole = bytes_of(path("sky." + extension));
    for (const double share : {0.02, 0.5, 0.99}) {
      write("cut." + extension,
            std::string_view(whole).substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
      bad(3, {"info", "cut." + extension}, "cut." + extension);
      ++cut;
    }
  }
  EXPECT_EQ(cut, 12);
}

TEST_F(CliBadInput, WrongAspectForTheProjection) {
  write_pfm("square.pfm", 4, 4, std::vector<float>(48, 1));
  bad(3, {"info", "square.pfm", "--from", "equirect"}, "square.pfm");
  bad(3, {"info", "square.pfm", "--from", "cube-cross"}, "square.pfm");
  bad(3, {"info", "square.pfm"}, "--from");
  good({"info", "square.pfm", "--from", "octahedral"});
  bad(2, {"info", "square.pfm", "--from", "fisheye", "--fov", "400"}, "field of view");
}

TEST_F(CliBadInput, FacesThatAreMissingOrDiffer) {
  good({"sky", "furnace", "--to", "cube", "--size", "8", "-o", "faces/"});
  good({"info", "faces"});
  std::filesystem::remove(path("faces/nz.exr"));
  bad(3, {"info", "faces"}, "faces");
  good({"sky", "furnace", "--size", "8", "-o", "faces/nz.exr"});
  bad(3, {"info", "faces"}, "nz.exr");
}

TEST_F(CliBadInput, MaxPixels) {
  write_pfm("small.pfm", 4, 2, std::vector<float>(24, 1));
  bad(3, {"info", "small.pfm", "--max-pixels", "7"}, "4x2");
  good({"info", "small.pfm", "--max-pixels", "8"});
}

TEST_F(CliBadInput, FixRepairsAndSaysHowMany) {
  write_pfm("nan.pfm", 4, 2, {1, 1, 1, kNan, 1, kInf, -2, 1});
  const Result fixed = good({"convert", "nan.pfm", "-o", "fixed.pfm", "--fix"});
  EXPECT_NE(fixed.err.find("replaced 2 texels that were not finite and raised 1 negative"), std::string::npos)
      << fixed.err;
  const Image<Rgb> pixels = pixels_of(path("fixed.pfm"));
  ASSERT_EQ(pixels.size(), 8u);
  for (const Rgb& p : pixels.values()) EXPECT_TRUE(p.r >= 0 && p.r <= 1);
  // info tells, and does not mind.
  EXPECT_NE(good({"info", "nan.pfm"}).out.find("1 NaN, 1 infinite, 1 negative"), std::string::npos);
}

TEST_F(CliBadInput, DoubtfulDataIsSaidAndKept) {
  write_pfm("black.pfm", 8, 4, std::vector<float>(96, 0));
  const Result black = good({"bake", "black.pfm", "-o", "black", "--size", "16", "--dfg-size", "4", "--verify"});
  EXPECT_NE(black.err.find("warning: The map is black."), std::string::npos) << black.err;

  std::vector<float> light(96, 1);
  light[5] = -3;
  write_pfm("negative.pfm", 8, 4, light);
  EXPECT_NE(good({"convert", "negative.pfm", "-o", "kept.pfm"}).err.find("1 texel holds negative radiance"),
            std::string::npos);
  EXPECT_EQ(bytes_of(path("kept.pfm")), bytes_of(path("negative.pfm")));
}

TEST_F(CliBadInput, UnusualButSound) {
  write_pfm("one.pfm", 1, 1, {2, 2, 2});
  EXPECT_LE(worst_from((good({"irradiance", "one.pfm", "--from", "octahedral", "-o", "one.exr", "--size", "4",
                              "--quantity", "irradiance/pi"}),
                        pixels_of(path("one.exr"))),
                       2),
            1e-5);
  write_pfm("grey.pfm", 4, 2, std::vector<float>(8, 0.5f));
  good({"convert", "grey.pfm", "-o", "grey.exr"});
  EXPECT_EQ(worst_from(pixels_of(path("grey.exr")), 0.5), 0);

  // TGA, uncompressed, 2x1, 32 bits with alpha 0 and 255: blue, green, red, alpha.
  std::string tga(18, '\0');
  tga[2] = 2, tga[12] = 2, tga[14] = 1, tga[16] = 32, tga[17] = 0x28;
  write("alpha.tga", tga + std::string("\xff\xff\xff\0\xff\xff\xff\xff", 8));
  const Result alpha = good({"convert", "alpha.tga", "-o", "alpha.exr"});
  EXPECT_NE(alpha.err.find("alpha is left out"), std::string::npos) << alpha.err;
  EXPECT_NE(alpha.err.find("sRGB"), std::string::npos) << alpha.err;
  EXPECT_EQ(worst_from(pixels_of(path("alpha.exr")), 1), 0);
}

TEST_F(CliBadInput, OutputsThatCannotBe) {
  good({"sky", "furnace", "-o", "x.exr", "--size", "8"});
  write("file", "in the way");
  bad(4, {"bake", "x.exr", "-o", "file"}, "file");
  bad(4, {"bake", "x.exr", "-o", "file/below"}, "file/below");
  bad(4, {"convert", "x.exr", "-o", "file/y.exr"}, "file/y.exr");
  bad(4, {"convert", "x.exr", "-o", "nowhere/y.exr"}, "nowhere/y.exr");
  bad(4, {"convert", "x.exr", "--to", "cube", "-o", "file/y_%s.exr"}, "file");
  bad(4, {"irradiance", "x.exr", "-o", "file/y.ktx2", "--size", "8"}, "file/y.ktx2");
  bad(4, {"sh", "x.exr", "-o", "file/sh.json"}, "file/sh.json");
  bad(4, {"light", "ambient", "-o", "file/sh.json"}, "file/sh.json");
  bad(4, {"shader", "x.exr", "-o", "file/sh.glsl"}, "file/sh.glsl");
  bad(4, {"shader", "x.exr", "--program", "-o", "file/matte"}, "file");
  bad(4, {"dfg", "-o", "file/dfg.exr", "--size", "4"}, "file/dfg.exr");
  bad(4, {"compare", "x.exr", "x.exr", "-o", "file/d.png"}, "file/d.png");
}

TEST_F(CliBadInput, AFullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  good({"sky", "furnace", "-o", "x.exr", "--size", "8"});
  const auto before = files();
  for (const std::string verb : {"info", "sh"}) {
    const Result result = run({verb, "x.exr"}, "/dev/full");
    EXPECT_EQ(result.code, 4) << result.err;
    EXPECT_NE(result.err.find("standard output"), std::string::npos) << result.err;
  }
  EXPECT_EQ(files(), before);
}

TEST_F(CliBadInput, AFailureLeavesOldResultsAlone) {
  good({"sky", "furnace", "-o", "x.exr", "--size", "8"});
  good({"bake", "x.exr", "-o", "out", "--size", "16", "--dfg-size", "4"});
  write_pfm("nan.pfm", 4, 2, {1, 1, 1, kNan, 1, 1, 1, 1});
  bad(3, {"bake", "nan.pfm", "-o", "out", "--size", "16"}, "NaN");
  // A folder in the place of a result is noticed before any other result has taken its name.
  std::filesystem::remove(path("out/recipe.json"));
  std::filesystem::create_directory(path("out/recipe.json"));
  bad(4, {"bake", "x.exr", "-o", "out", "--size", "32", "--dfg-size", "8"}, "recipe.json");
}

using SlowCliInterrupt = Cli;

TEST_F(SlowCliInterrupt, StopsWithItsCodeAndLeavesNothing) {
  good({"sky", "daylight", "-o", "sky.exr", "--size", "1024"});
  const auto before = files();
  // Verification alone takes seconds on one thread.
  const Result result = run_interrupted({"bake", "sky.exr", "-o", "out", "--verify", "--threads", "1"}, 700);
  EXPECT_EQ(result.code, 5) << result.err;
  EXPECT_NE(result.err.find("zonal: cancelled"), std::string::npos) << result.err;
  EXPECT_EQ(files(), before);
}

}  // namespace
}  // namespace zonal
