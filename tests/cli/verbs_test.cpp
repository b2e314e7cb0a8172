#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"
#include "zonal/io/file.h"
#include "zonal/io/ktx2.h"
#include "zonal/io/sh_json.h"
#include "zonal/sphere/projection.h"

namespace zonal {
namespace {

using CliVerbs = Cli;
using SlowCliVerbs = Cli;

nlohmann::json json_of(const Result& result) { return nlohmann::json::parse(result.out); }

TEST_F(CliVerbs, InfoFindsTheSunWhereItWasPut) {
  good({"sky", "sun", "--elevation", "30", "--azimuth", "60", "--diameter", "1", "--contrast", "1e5", "-o", "sun.exr"});
  const auto info = json_of(good({"info", "sun.exr", "--json"}));
  EXPECT_EQ(info.at("width"), 1024);
  EXPECT_EQ(info.at("projection"), "equirect");
  ASSERT_TRUE(info.at("sun").is_object());
  EXPECT_NEAR(info["sun"]["elevation_deg"].get<double>(), 30, 0.2);  // half a texel
  EXPECT_NEAR(info["sun"]["azimuth_deg"].get<double>(), 60, 0.2);
  const double radius = kPi / 360, expected = (1e5 - 1) * kPi * std::pow(std::sin(radius), 2);
  EXPECT_NEAR(info["sun"]["irradiance"][0].get<double>() / expected, 1, 0.01);
  EXPECT_NE(good({"info", "sun.exr"}).out.find("elevation 30.0"), std::string::npos);
}

TEST_F(CliVerbs, ConvertThereAndBackThroughEveryLayoutOfACubeIsExact) {
  good({"testcard", "--to", "cube", "--size", "16", "-o", "card.exr"});
  const std::string card = bytes_of(path("card.exr"));
  int layouts = 0;
  for (const std::string layout : {"cube-row", "cube-cross", "cube-cross-vertical", "cube-cross-vertical-unrotated"}) {
    good({"convert", "card.exr", "--to", layout, "-o", "there.exr"});
    good({"convert", "there.exr", "--from", layout, "--to", "cube-stack", "-o", "back.exr"});
    EXPECT_EQ(bytes_of(path("back.exr")), card) << layout;
    ++layouts;
  }
  EXPECT_EQ(layouts, 4);
}

TEST_F(CliVerbs, ConvertSixFilesThereAndBack) {
  good({"testcard", "--to", "cube", "--size", "16", "-o", "card.exr"});
  good({"convert", "card.exr", "-o", "faces/"});
  EXPECT_EQ(files("faces").size(), 6u);
  good({"convert", "faces", "-o", "back.exr"});
  EXPECT_EQ(bytes_of(path("back.exr")), bytes_of(path("card.exr")));
  good({"convert", "card.exr", "-o", "a_%s.pfm"});
  good({"convert", "a_px.pfm", "a_nx.pfm", "a_py.pfm", "a_ny.pfm", "a_pz.pfm", "a_nz.pfm", "-o", "again.exr"});
  EXPECT_EQ(bytes_of(path("again.exr")), bytes_of(path("card.exr")));
}

TEST_F(CliVerbs, ConvertRotatesAndBack) {
  good({"testcard", "--size", "32", "-o", "card.exr"});
  good({"convert", "card.exr", "--rotate", "90", "-o", "turned.exr"});
  EXPECT_NE(bytes_of(path("turned.exr")), bytes_of(path("card.exr")));
  good({"convert", "turned.exr", "--rotate", "-90", "-o", "back.exr"});
  EXPECT_EQ(bytes_of(path("back.exr")), bytes_of(path("card.exr")));
  // What was in the centre (+X) is on the left, a quarter of the width away (+Y).
  EXPECT_EQ(pixels_of(path("turned.exr"))(16, 14), pixels_of(path("card.exr"))(32, 14));
}

TEST_F(CliVerbs, ConvertKeepsSizeUnlessTold) {
  good({"testcard", "--size", "32", "-o", "card.exr"});
  good({"convert", "card.exr", "-o", "same.hdr"});
  EXPECT_EQ(pixels_of(path("same.hdr")).width(), 64);
  good({"convert", "card.exr", "--size", "8", "-o", "small.exr"});
  EXPECT_EQ(pixels_of(path("small.exr")).height(), 8);
  good({"convert", "card.exr", "--to", "cube-row", "-o", "row.exr"});
  EXPECT_EQ(pixels_of(path("row.exr")).height(), 16);
  good({"convert", "card.exr", "--supersample", "4", "--to", "angular", "-o", "angular.exr"});
  EXPECT_EQ(pixels_of(path("angular.exr")).width(), 32);
}

TEST_F(CliVerbs, IrradianceQuantitiesDifferByPi) {
  good({"sky", "gradient", "--size", "32", "-o", "sky.exr"});
  good({"irradiance", "sky.exr", "--size", "8", "-o", "e.exr"});
  good({"irradiance", "sky.exr", "--size", "8", "-o", "e_pi.exr", "--quantity", "irradiance/pi"});
  good({"irradiance", "sky.exr", "--size", "8", "-o", "phong.exr", "--shininess", "1"});
  const Image<Rgb> e = pixels_of(path("e.exr")), e_pi = pixels_of(path("e_pi.exr")),
                   phong = pixels_of(path("phong.exr"));
  ASSERT_EQ(e.size(), 128u);
  for (std::size_t i = 0; i < e.size(); ++i) {
    EXPECT_NEAR(e.values()[i].g, kPi * e_pi.values()[i].g, 1e-6 * e.values()[i].g);
    // The Phong lobe of exponent 1 is the cosine.
    EXPECT_NEAR(phong.values()[i].g, e_pi.values()[i].g, 1e-3);  // the bound that is aimed for
  }
  // 1 + x + y/2 under the cosine lobe: bands 0 and 1 times 1 and 2/3. Texel (4, 4) of 16x8: elevation -11.25,
  // azimuth 78.75.
  const double elevation = radians(-11.25), azimuth = radians(78.75);
  const double x = std::cos(elevation) * std::cos(azimuth), y = std::cos(elevation) * std::sin(azimuth);
  // The sky's texels are point samples 5.6 degrees apart: the first bands are off by the square of that, over 24.
  EXPECT_NEAR(e_pi(4, 4).r, 1 + 2.0 / 3 * (x + y / 2), 1e-3);
}

TEST_F(CliVerbs, GroundFillsWhatAFisheyeDoesNotShow) {
  good({"sky", "furnace", "--to", "fisheye", "--size", "64", "-o", "up.exr"});
  const auto facing_down = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"irradiance", "up.exr", "--from", "fisheye",    "-o",
                                      "e.exr",      "--size", "32",     "--quantity", "irradiance/pi"};
    words.insert(words.end(), more.begin(), more.end());
    good(words);
    return pixels_of(path("e.exr"))(0, 31).r;
  };
  // The last row faces 2.8 degrees from straight down: it sees (1 - cos 2.8)/2 = 0.0006 of the sky.
  EXPECT_NEAR(facing_down({"--ground", "0.25"}), 0.25, 2e-3);
  EXPECT_NEAR(facing_down({}), 1, 1e-5);
  EXPECT_EQ(facing_down({"--uncovered", "leave-out"}), 0);
}

TEST_F(SlowCliVerbs, PrefilterKnowsEveryLobe) {
  good({"sky", "furnace", "--size", "16", "-o", "white.exr"});
  const std::vector<std::vector<std::string>> lobes = {{"cosine"},
                                                       {"ggx", "--alpha", "0.3"},
                                                       {"charlie", "--roughness", "0.5"},
                                                       {"phong", "--exponent", "20"},
                                                       {"blinn-phong", "--roughness", "0.3"},
                                                       {"cone", "--angle", "20"},
                                                       {"gaussian", "--angle", "10"}};
  int white = 0;
  for (const auto& lobe : lobes) {
    std::vector<std::string> words = {"prefilter", "white.exr", "-o", "p.exr", "--size", "8", "--lobe"};
    words.insert(words.end(), lobe.begin(), lobe.end());
    good(words);
    EXPECT_LE(worst_from(pixels_of(path("p.exr")), 1), 1e-6) << lobe[0];
    ++white;
  }
  EXPECT_EQ(white, 7);
}

TEST_F(CliVerbs, ShReadsBackAndSpeaksShader) {
  good({"sky", "gradient", "--size", "64", "-o", "sky.exr"});
  const ShFile printed = parse_sh_json(good({"sh", "sky.exr"}).out);
  good({"sh", "sky.exr", "-o", "sh.json"});
  EXPECT_EQ(printed, parse_sh_json(bytes_of(path("sh.json"))));
  EXPECT_EQ(printed.coefficients.bands(), 3);
  EXPECT_NEAR(printed.coefficients(0, 0).r, std::sqrt(4 * kPi), 1e-6);
  EXPECT_NEAR(printed.coefficients(1, 1).r, std::sqrt(4 * kPi / 3), 1e-3);       // x
  EXPECT_NEAR(printed.coefficients(1, -1).r, std::sqrt(4 * kPi / 3) / 2, 1e-3);  // y/2
  const ShFile e = parse_sh_json(good({"sh", "sky.exr", "--quantity", "irradiance"}).out);
  EXPECT_EQ(e.quantity, ShQuantity::kIrradiance);
  EXPECT_NEAR(e.coefficients(0, 0).r, kPi * std::sqrt(4 * kPi), 1e-5);
  EXPECT_NE(
      good({"sh", "sky.exr", "--glsl", "--quantity", "irradiance"}).out.find("vec3 zonal_irradiance(highp vec3 n)"),
      std::string::npos);
  EXPECT_NE(good({"sh", "sky.exr", "--shader", "hlsl"}).out.find("float3 zonal_radiance"), std::string::npos);
  EXPECT_EQ(parse_sh_json(good({"sh", "sky.exr", "--bands", "20"}).out).coefficients.bands(), 20);
}

TEST_F(CliVerbs, ShOfAFurnaceForFilamentIsOne) {
  good({"sky", "furnace", "--size", "64", "-o", "white.exr"});
  const std::string text = good({"sh", "white.exr", "--to", "filament"}).out;
  EXPECT_NEAR(std::stod(text), 1, 1e-6);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 9);
}

TEST_F(CliVerbs, DfgTables) {
  good({"dfg", "--size", "16", "-o", "s.exr"});
  good({"dfg", "--size", "16", "-o", "m.exr", "--variant", "multiscatter"});
  good({"dfg", "--size", "16", "-o", "s.ktx2", "--float32"});
  const Image<Rgb> s = pixels_of(path("s.exr")), m = pixels_of(path("m.exr"));
  ASSERT_EQ(s.size(), 256u);
  for (std::size_t i = 0; i < s.size(); ++i) {
    EXPECT_EQ(m.values()[i].r, s.values()[i].g);
    EXPECT_NEAR(m.values()[i].g, s.values()[i].r + s.values()[i].g, 1e-6);
  }
  // A smooth surface seen from above reflects all of f0.
  EXPECT_NEAR(s(15, 0).r, 1, 1e-3);
  const Ktx2Texture texture = decode_ktx2(read_file(path("s.ktx2")));
  EXPECT_EQ(texture.chain.levels.at(0), s);
}

TEST_F(SlowCliVerbs, EverySkyInEveryProjection) {
  int painted = 0;
  for (const Layout layout : all_layouts()) {
    for (const std::string kind : {"daylight", "furnace", "gradient", "sun", "checker"}) {
      good({"sky", kind, "--to", std::string(name_of(layout)), "--size", "16", "-o", "sky.exr"});
      const Image<Rgb> pixels = pixels_of(path("sky.exr"));
      const ImageSize size = image_size(layout, 16);
      EXPECT_EQ(pixels.width(), size.width);
      EXPECT_EQ(pixels.height(), size.height);
      ++painted;
    }
    good({"testcard", "--to", std::string(name_of(layout)), "--size", "16", "-o", "card.png"});
    EXPECT_EQ(pixels_of(path("card.png")).width(), image_size(layout, 16).width);
  }
  EXPECT_EQ(painted, 14 * 5);
}

TEST_F(CliVerbs, CompareMeasuresAndJudges) {
  write_pfm("a.pfm", 4, 2, {1, 1, 1, 1, 1, 1, 1, 1});
  write_pfm("b.pfm", 4, 2, {1, 1, 1, 1, 1, 3, 1, 1});  // rows from the bottom: pixel (1, 0)
  const auto same = json_of(good({"compare", "a.pfm", "a.pfm", "--json", "--max-error", "0"}));
  EXPECT_EQ(same.at("rmse"), 0);
  EXPECT_TRUE(same.at("psnr_db").is_null());
  EXPECT_EQ(same.at("within_max_error"), true);

  const Result differ = run({"compare", "b.pfm", "a.pfm", "--flat", "--max-error", "0.5", "--json"});
  EXPECT_EQ(differ.code, 1);
  const auto json = json_of(differ);
  EXPECT_NEAR(json.at("rmse").get<double>(), std::sqrt(4.0 / 8), 1e-12);
  EXPECT_EQ(json.at("max_error"), 2);
  EXPECT_EQ(json.at("worst").at("x"), 1);
  EXPECT_EQ(json.at("worst").at("y"), 0);
  good({"compare", "b.pfm", "a.pfm", "--flat", "--max-error", "0.8"});

  good({"compare", "b.pfm", "a.pfm", "-o", "d.pfm"});
  EXPECT_EQ(pixels_of(path("d.pfm"))(1, 0).r, 2);
  good({"compare", "b.pfm", "a.pfm", "-o", "d.png"});
  EXPECT_EQ(pixels_of(path("d.png"))(1, 0), (Rgb{1, 1, 1}));  // the worst is white
  EXPECT_EQ(pixels_of(path("d.png"))(0, 0), (Rgb{0, 0, 0}));
  good({"compare", "b.pfm", "a.pfm", "-o", "d.html"});
  EXPECT_EQ(bytes_of(path("d.html")).substr(0, 15), "<!DOCTYPE html>");

  write_pfm("c.pfm", 2, 1, {1, 1});
  bad(3, {"compare", "c.pfm", "a.pfm"}, "2x1");
  bad(2, {"compare", "b.pfm", "a.pfm", "-o", "d.txt"}, "names no format");
}

}  // namespace
}  // namespace zonal
