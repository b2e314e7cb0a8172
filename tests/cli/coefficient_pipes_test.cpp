// Coefficients that go on to other verbs: multiply, ambient-cube, shader, and standard input.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"
#include "zonal/io/ambient_cube_json.h"
#include "zonal/io/json_text.h"
#include "zonal/io/sh_json.h"
#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"

namespace zonal {
namespace {

class CliPipes : public Cli {
 protected:
  ShFile sh_of(const std::vector<std::string>& words) const { return parse_sh_json(good(words).out); }
  ShFile file(const std::string& name) const { return parse_sh_json(bytes_of(path(name))); }
  /// What a shell makes of commands joined by pipes, "zonal" being the command.
  Result shell(std::string line) const {
    for (std::size_t at = line.find("zonal "); at != std::string::npos; at = line.find("zonal ", at + 1)) {
      line.replace(at, 5, "\"" ZONAL_COMMAND "\"");
      at += std::string(ZONAL_COMMAND).size();
    }
    const std::string folder = path("").string();
    const int status = std::system(("cd \"" + folder + "\" && (" + line + ") > piped.out 2> piped.err").c_str());
    return {status == -1 ? -1 : status / 256, bytes_of(path("piped.out")), bytes_of(path("piped.err"))};
  }
};

double worst(const Sh<RgbD>& a, const Sh<RgbD>& b) {
  EXPECT_EQ(a.bands(), b.bands());
  double largest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const RgbD d = a[i] - b[i];
    largest = std::max({largest, std::abs(d.r), std::abs(d.g), std::abs(d.b)});
  }
  return largest;
}

TEST_F(CliPipes, CoefficientsFlowThroughAPipe) {
  const Result piped = shell(
      "zonal light cone --half-angle 25 --toward 1,2,3 --bands 4 | zonal sh - --rotate 10,20,30 | zonal multiply - "
      "c.json");
  EXPECT_NE(piped.code, 0);  // no c.json yet
  good({"light", "cone", "--half-angle", "60", "--bands", "4", "-o", "c.json"});
  const Result whole = shell(
      "zonal light cone --half-angle 25 --toward 1,2,3 --bands 4 | zonal sh - --rotate 10,20,30 | zonal multiply - "
      "c.json");
  ASSERT_EQ(whole.code, 0) << whole.err;
  good({"light", "cone", "--half-angle", "25", "--toward", "1,2,3", "--bands", "4", "-o", "a.json"});
  good({"sh", "a.json", "--rotate", "10,20,30", "-o", "b.json"});
  good({"multiply", "b.json", "c.json", "-o", "d.json"});
  EXPECT_EQ(whole.out, bytes_of(path("d.json")));
  EXPECT_EQ(good({"sh", "d.json", "-o", "-"}).out, whole.out);  // shortest decimals: the same doubles, the same bytes

  const Result shader =
      shell("zonal light sky | zonal sh - --bands 2 | zonal shader - --lang hlsl --returns irradiance/pi");
  ASSERT_EQ(shader.code, 0) << shader.err;
  EXPECT_NE(shader.out.find("float3 zonal_irradiance_over_pi(float3 n)"), std::string::npos) << shader.out;
  EXPECT_NE(shell("zonal light ambient --json | zonal sh -").err.find("without --json"), std::string::npos);
  EXPECT_EQ(shell("printf '' | zonal sh -").code, 3);
  EXPECT_EQ(shell("zonal light ambient | zonal multiply - -").code, 2);
}

TEST_F(CliPipes, AProductIsTheProduct) {
  good({"light", "cone", "--half-angle", "50", "--toward", "1,1,0", "--radiance", "3,2,1", "--bands", "4", "-o",
        "a.json"});
  good({"light", "hemisphere", "--toward", "0,1,1", "--bands", "3", "-o", "b.json"});
  // A constant of one half halves.
  good({"light", "ambient", "--radiance", "0.5", "--bands", "2", "-o", "half.json"});
  const ShFile a = file("a.json"), b = file("b.json");
  EXPECT_LE(worst(sh_of({"multiply", "a.json", "half.json"}).coefficients, 0.5 * a.coefficients), 1e-15);

  // 4 and 3 bands make 6, which multiply as the functions do at every direction; fewer are the first of those.
  const ShFile full = sh_of({"multiply", "a.json", "b.json", "--bands", "6"});
  int compared = 0;
  for (const Vec3 d : spiral_directions(60)) {
    const RgbD expected = evaluate(a.coefficients, d) * evaluate(b.coefficients, d),
               found = evaluate(full.coefficients, d);
    EXPECT_NEAR(found.r, expected.r, 1e-13);
    EXPECT_NEAR(found.b, expected.b, 1e-13);
    ++compared;
  }
  EXPECT_EQ(compared, 60);
  const Result kept = good({"multiply", "a.json", "b.json"});
  EXPECT_NE(kept.err.find("the product has 6 bands, of which 4 are kept"), std::string::npos) << kept.err;
  EXPECT_LE(worst(parse_sh_json(kept.out).coefficients, with_bands(full.coefficients, 4)), 1e-14);
  EXPECT_EQ(sh_of({"multiply", "a.json", "b.json", "--bands", "9"}).coefficients(7, 2), RgbD());
}

TEST_F(CliPipes, ProductsWithFunctionsOfInfinitelyManyBands) {
  good({"light", "ambient", "--radiance", "2,1,0", "--bands", "5", "-o", "white.json"});
  good({"light", "hemisphere", "--toward", "3,0,4", "--radiance", "2,1,0", "--bands", "5", "-o", "half.json"});
  // The constant in a half space is the hemisphere.
  EXPECT_LE(
      worst(sh_of({"multiply", "white.json", "--half-space", "3,0,4"}).coefficients, file("half.json").coefficients),
      1e-14);
  // ... and is so twice: the truncated coefficients of a half space would not do that.
  good({"multiply", "white.json", "--half-space", "3,0,4", "--bands", "40", "-o", "h40.json"});
  const ShFile twice = sh_of({"multiply", "h40.json", "--half-space", "3,0,4", "--bands", "5"});
  EXPECT_LE(worst(twice.coefficients, file("half.json").coefficients), 0.03);  // of 40 bands
  // The mean of radiance times cosine is E/4pi: 1/4 of a white sky.
  const ShFile cosine = sh_of({"multiply", "white.json", "--cosine", "0,0,1"});
  EXPECT_NEAR(cosine.coefficients[0].r / std::sqrt(4 * kPi), 0.5, 1e-14);
  EXPECT_EQ(cosine.coefficients.bands(), 5);
  bad(2, {"multiply", "white.json", "--cosine", "0,0,0"}, "--cosine has no direction");
  bad(2, {"multiply", "white.json", "half.json", "--cosine", "0,0,1"}, "one factor");
  bad(2, {"multiply", "white.json"}, "one factor");
}

TEST_F(CliPipes, LightTimesLightIsDoubtful) {
  good({"light", "ambient", "--radiance", "5", "-o", "five.json"});
  good({"light", "cone", "--half-angle", "30", "-o", "mask.json"});
  EXPECT_NE(good({"multiply", "five.json", "five.json"}).err.find("radiance times radiance"), std::string::npos);
  EXPECT_EQ(good({"multiply", "five.json", "mask.json"}).err.find("warning"), std::string::npos);
  EXPECT_EQ(good({"multiply", "mask.json", "five.json"}).err.find("warning"), std::string::npos);
  good({"sh", "five.json", "--quantity", "irradiance", "-o", "e.json"});
  bad(3, {"multiply", "e.json", "mask.json"}, "e.json holds irradiance");
  bad(3, {"multiply", "five.json", "e.json"}, "e.json holds irradiance");
}

TEST_F(CliPipes, AnAmbientCubeThereAndBack) {
  good({"light", "directional", "--toward", "1,2,2", "--irradiance", "3,2,1", "-o", "d.json"});
  good({"ambient-cube", "d.json", "--convolved", "-o", "cube.json"});
  const AmbientCubeFile cube = parse_ambient_cube_json(bytes_of(path("cube.json")));
  EXPECT_EQ(cube.quantity, ShQuantity::kIrradianceOverPi);
  const auto json = nlohmann::json::parse(good({"ambient-cube", "d.json", "--convolved", "--json"}).out);
  EXPECT_EQ(json.at("quantity"), "irradiance/pi");
  EXPECT_EQ(json.at("sides").at("-Y").at(1).get<double>(), cube.cube.sides[3].g);
  // The table has the six of them, +X first.
  const std::string table = good({"ambient-cube", "d.json", "--convolved"}).out;
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 6);
  EXPECT_NEAR(std::stod(table.substr(3)), cube.cube.sides[0].r, 1e-5);

  // Sloan 2008: back again, 3 bands keep l = 0 and the squares, and 15/16 of the linear part; xy, yz and zx are gone.
  const ShFile before = sh_of({"sh", "d.json", "--quantity", "irradiance/pi"}),
               after = sh_of({"ambient-cube", "--from-cube", "cube.json"});
  EXPECT_EQ(after.quantity, ShQuantity::kIrradianceOverPi);
  ASSERT_EQ(after.coefficients.bands(), 3);
  const double gains[] = {1, 15.0 / 16, 15.0 / 16, 15.0 / 16, 0, 0, 1, 0, 1};
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(after.coefficients[i].r, gains[i] * before.coefficients[i].r, 1e-14) << i;
  }
  // A furnace is a white cube, from a picture too, and E is pi of it.
  good({"sky", "furnace", "--size", "16", "-o", "white.exr"});
  for (const std::vector<std::string>& words : {std::vector<std::string>{"ambient-cube", "white.exr", "--json"},
                                                {"ambient-cube", "white.exr", "--convolved", "--json"}}) {
    const auto white = nlohmann::json::parse(good(words).out);
    ASSERT_EQ(white.at("sides").size(), 6u);
    for (const auto& side : white["sides"]) EXPECT_NEAR(side.at(2).get<double>(), 1, 1e-6);
  }
  bad(2, {"ambient-cube"}, "needs an input");
  bad(2, {"ambient-cube", "d.json", "--from-cube", "cube.json"}, "takes no other input");
  bad(3, {"ambient-cube", "--from-cube", "d.json"}, "\"format\" is \"zonal-sh\", must be \"zonal-ambient-cube\"");
  bad(3, {"ambient-cube", "cube.json"}, "\"format\" is \"zonal-ambient-cube\"");
}

TEST_F(CliPipes, ShadersFromFilesAndPictures) {
  good({"light", "sky", "--bands", "6", "-o", "sky.json"});
  int written = 0;
  for (const auto& [language, says] :
       {std::pair<std::string, std::string>{"glsl", "highp vec3 zonal_irradiance(highp vec3 n)"},
        {"hlsl", "float3 zonal_irradiance(float3 n)"},
        {"msl", "inline float3 zonal_irradiance(float3 n)"},
        {"wgsl", "fn zonal_irradiance(n: vec3<f32>)"},
        {"cpp", "Vec3 zonal_irradiance(const Vec3& n)"}}) {
    const Result result = good({"shader", "sky.json", "--lang", language});
    EXPECT_NE(result.out.find(says), std::string::npos) << result.out;
    ++written;
  }
  EXPECT_EQ(written, 5);
  // The same function by either verb, and its constant is the light's mean.
  EXPECT_EQ(good({"shader", "sky.json", "--returns", "radiance"}).out, good({"sh", "sky.json", "--glsl"}).out);
  good({"light", "ambient", "--radiance", "0.25", "--bands", "1", "-o", "grey.json"});
  EXPECT_NE(good({"shader", "grey.json", "--returns", "irradiance/pi"}).out.find("return vec3(0.25, 0.25, 0.25);"),
            std::string::npos);
  EXPECT_NE(good({"shader", "sky.json", "--to", "unity"}).out.find("the world axes of unity"), std::string::npos);
  good({"sky", "gradient", "--size", "64", "-o", "sky.exr"});
  EXPECT_EQ(good({"shader", "sky.exr"}).out, good({"sh", "sky.exr", "--quantity", "irradiance", "--glsl"}).out);
  bad(2, {"shader", "sky.exr", "--bands", "7"}, "1 to 6 bands");
  bad(2, {"shader", "sky.json", "--lang", "rust"}, "'rust' is not one of");
}

TEST_F(CliPipes, AProgramIsFourFiles) {
  good({"light", "sky", "--bands", "4", "-o", "sky.json"});
  const Sh<RgbD> sky = file("sky.json").coefficients;
  int written = 0;
  for (const auto& [language, extension] : {std::pair<std::string, std::string>{"glsl", "glsl"},
                                            {"hlsl", "hlsl"},
                                            {"msl", "metal"},
                                            {"wgsl", "wgsl"},
                                            {"cpp", "h"}}) {
    good({"shader", "sky.json", "--program", "--lang", language, "-o", "out/" + language});
    for (const std::string& part :
         {".vert." + extension, ".frag." + extension, std::string(".sh.h"), std::string(".sh.json")}) {
      EXPECT_GT(bytes_of(path("out/" + language + part)).size(), 100u) << language << part;
      ++written;
    }
  }
  EXPECT_EQ(written, 20);
  EXPECT_EQ(files("out").size(), 20u);
  EXPECT_EQ(bytes_of(path("out/glsl.vert.glsl")).substr(0, 12), "#version 410");
  // The light is the first nine coefficients, as floats; the machine's answer has the same texts.
  EXPECT_NE(bytes_of(path("out/glsl.sh.h")).find(shortest(static_cast<float>(sky[6].r))), std::string::npos);
  const auto json = nlohmann::json::parse(good({"shader", "sky.json", "--program", "--json"}).out);
  EXPECT_EQ(json.at("fragment").get<std::string>(), bytes_of(path("out/glsl.frag.glsl")));
  EXPECT_NE(good({"shader", "sky.json", "--program", "--to", "godot", "-o", "g"}).err.find("first 3 of the 4 bands"),
            std::string::npos);
  bad(2, {"shader", "sky.json", "--program"}, "four files");
  bad(2, {"shader", "sky.json", "--program", "-o", "-"}, "four files");
  bad(2, {"shader", "sky.json", "--program", "-o", "p", "--returns", "radiance"}, "no meaning");
}

TEST_F(CliPipes, FilesThatAreNoCoefficients) {
  good({"light", "cone", "--half-angle", "10", "-o", "good.json"});
  const std::string text = bytes_of(path("good.json"));
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string copy = text;
    EXPECT_NE(copy.find(from), std::string::npos) << from;
    return copy.replace(copy.find(from), from.size(), to);
  };
  write("empty.json", "");
  write("text.json", "no JSON");
  write("other.json", "{\"format\": \"gltf\"}");
  write("frame.json", changed("z-up", "y-up"));
  write("bands.json", changed("\"bands\": 3", "\"bands\": 4"));
  write("nan.json", changed("0.0", "NaN"));
  write("cut.json", text.substr(0, text.size() / 2));
  int refused = 0;
  for (const std::string name : {"empty", "text", "other", "frame", "bands", "nan", "cut", "missing"}) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"sh"}, {"shader"}, {"lights"}, {"ambient-cube"}}) {
      bad(3, {words[0], name + ".json"}, name + ".json");
      ++refused;
    }
    bad(3, {"multiply", "good.json", name + ".json"}, name + ".json");
    ++refused;
  }
  EXPECT_EQ(refused, 40);
  // Coefficients are known by what they are, not only by name; and are no pictures.
  write("unnamed", text);
  EXPECT_EQ(good({"sh", "unnamed"}).out, text);
  bad(2, {"sh", "good.json", "--fov", "90"}, "--fov describes a picture");
  bad(2, {"sh", "good.json", "--fix"}, "--fix describes a picture");
  bad(2, {"sh", "good.json", "good.json"}, "needs no other input");
  bad(2, {"sh", "good.json", "--rotate", "1,2,3,4"}, "--rotate");
  bad(2, {"sh", "good.json", "--bands", "0"}, "--bands");
}

TEST_F(CliPipes, LightsThatAreNone) {
  bad(2, {"light", "lamp"}, "no light 'lamp'");
  bad(2, {"light", "directional", "--toward", "0,0,0"}, "no direction");
  bad(2, {"light", "directional", "--toward", "0,0,nan"}, "not a list of numbers");
  bad(2, {"light", "directional", "--toward", "0,0,1", "--azimuth", "3"}, "both say where");
  bad(2, {"light", "directional", "--half-angle", "3"}, "has no --half-angle");
  bad(2, {"light", "directional", "--radiance", "3"}, "has no --radiance");
  bad(2, {"light", "cone"}, "needs --half-angle");
  bad(2, {"light", "cone", "--half-angle", "181"}, "half angle");
  bad(2, {"light", "smooth-cone", "--half-angle", "0"}, "half angle");
  bad(2, {"light", "cone", "--half-angle", "0", "--normalise"}, "reflects nothing");
  bad(2, {"light", "sphere", "--radius", "3"}, "--center");
  bad(2, {"light", "sphere", "--center", "0,0,0", "--radius", "0"}, "");
  bad(2, {"light", "polygon", "--vertex", "1,0,0", "--vertex", "0,1,0"}, "three times");
  bad(2, {"light", "polygon", "--vertex", "1,0,0", "--vertex", "-1,0,0", "--vertex", "0,1,0"}, "lit point");
  bad(2, {"light", "sky", "--elevation", "-5"}, "horizon");
  bad(2, {"light", "ambient", "--radiance", "1,2"}, "one number or three");
  bad(2, {"light", "ambient", "--bands", "2000"}, "--bands");
  EXPECT_NE(good({"light", "cone", "--half-angle", "0"}).err.find("This light is black"), std::string::npos);
}

}  // namespace
}  // namespace zonal
