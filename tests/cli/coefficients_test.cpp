// Coefficients made and changed: light and sh.
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "tests/cli/command.h"
#include "zonal/io/sh_json.h"
#include "zonal/math/sphere_rule.h"
#include "zonal/sh/eval.h"

namespace zonal {
namespace {

class CliCoefficients : public Cli {
 protected:
  ShFile sh_of(const std::vector<std::string>& words) const { return parse_sh_json(good(words).out); }
  /// The largest difference of any coefficient.
  static double worst(const ShFile& a, const ShFile& b) {
    EXPECT_EQ(a.quantity, b.quantity);
    EXPECT_EQ(a.coefficients.bands(), b.coefficients.bands());
    double largest = 0;
    for (std::size_t i = 0; i < std::min(a.coefficients.size(), b.coefficients.size()); ++i) {
      const RgbD d = a.coefficients[i] - b.coefficients[i];
      largest = std::max({largest, std::abs(d.r), std::abs(d.g), std::abs(d.b)});
    }
    return largest;
  }
  static double at(const ShFile& sh, Vec3 d) { return evaluate(sh.coefficients, d).g; }
};

constexpr Vec3 kUp = {0, 0, 1}, kDown = {0, 0, -1};

TEST_F(CliCoefficients, ALightReflectsSeventeenToOne) {
  // Sloan 2008: a normalised directional light reflects 17:1 at the poles in 3 bands, 31:-1 in 5.
  good({"light", "directional", "--normalise", "-o", "three.json"});
  good({"light", "directional", "--normalise", "--bands", "5", "-o", "five.json"});
  const ShFile three = sh_of({"sh", "three.json", "--quantity", "irradiance/pi"}),
               five = sh_of({"sh", "five.json", "--quantity", "irradiance/pi"});
  EXPECT_NEAR(at(three, kUp), 1, 1e-14);
  EXPECT_NEAR(at(three, kUp) / at(three, kDown), 17, 1e-11);
  EXPECT_NEAR(at(five, kUp), 1, 1e-14);
  EXPECT_NEAR(at(five, kUp) / at(five, kDown), -31, 1e-10);
  const auto json = nlohmann::json::parse(good({"light", "directional", "--normalise", "--json"}).out);
  EXPECT_NEAR(json.at("normalising_factor").get<double>(), 16 * kPi / 17, 1e-14);
  // The colour is what is reflected.
  const ShFile gold =
      sh_of({"light", "cone", "--half-angle", "20", "--radiance", "3,2,0.5", "--normalise", "--toward", "0,3,4"});
  const RgbD reflected = evaluate(to_quantity(gold, ShQuantity::kIrradianceOverPi).coefficients, {0, 0.6, 0.8});
  EXPECT_NEAR(reflected.r, 3, 1e-13);
  EXPECT_NEAR(reflected.g, 2, 1e-13);
  EXPECT_NEAR(reflected.b, 0.5, 1e-13);
}

TEST_F(CliCoefficients, EveryLightHasItsEnergy) {
  // The integral over the sphere, sqrt(4 pi) L_00, is what each light is made of.
  const double cap = 2 * kPi * (1 - std::cos(radians(30))),
               octant = kPi / 2;  // the triangle of three axes as seen from the origin
  const std::vector<std::pair<std::vector<std::string>, double>> lights = {
      {{"directional", "--irradiance", "3"}, 3},
      {{"cone", "--half-angle", "30", "--radiance", "2", "--azimuth", "20", "--elevation", "-10"}, 2 * cap},
      {{"cone", "--half-angle", "180"}, 4 * kPi},
      {{"sphere", "--center", "0,-4,0", "--radius", "2"}, cap},
      {{"sphere", "--center", "0,0,0", "--radius", "2"}, 4 * kPi},
      {{"hemisphere", "--radiance", "3", "--ground", "1", "--toward", "1,1,0"}, 8 * kPi},
      {{"polygon", "--vertex", "-1,0,0", "--vertex", "0,-1,0", "--vertex", "0,0,1"}, octant},
      {{"ambient", "--radiance", "0.1"}, 0.4 * kPi},
  };
  int compared = 0;
  for (auto [words, energy] : lights) {
    words.insert(words.begin(), "light");
    EXPECT_NEAR(std::sqrt(4 * kPi) * sh_of(words).coefficients[0].b, energy, 1e-13) << words[1];
    ++compared;
  }
  EXPECT_EQ(compared, 8);
  // The smooth cone is one in its middle and loses to its rim: 2 pi int (2u^3 - 3u^2 + 1) sin.
  const double a = radians(30);
  const double smooth = kPi / (a * a * a) * 2 * (a * a * a + 6 * a + 6 * a * std::cos(a) - 12 * std::sin(a));
  EXPECT_NEAR(std::sqrt(4 * kPi) * sh_of({"light", "smooth-cone", "--half-angle", "30"}).coefficients[0].r, smooth,
              1e-12);
}

TEST_F(CliCoefficients, LightsLieWhereTheSkyVerbPutsThem) {
  good({"sky", "sun", "--azimuth", "50", "--elevation", "20", "--diameter", "20", "--contrast", "1e6", "--radiance",
        "1e-6", "--size", "256", "-o", "sun.exr"});
  const ShFile picture = sh_of({"sh", "sun.exr"}),
               cone = sh_of({"light", "cone", "--azimuth", "50", "--elevation", "20", "--half-angle", "10"});
  // Texels of 0.7 degrees at the rim of the disc.
  EXPECT_LE(worst(picture, cone), 3e-4 * cone.coefficients[0].r);
  good({"sky", "daylight", "--azimuth", "70", "--elevation", "40", "--size", "256", "-o", "sky.exr"});
  const ShFile seen = sh_of({"sh", "sky.exr"}), model = sh_of({"light", "sky", "--azimuth", "70", "--elevation", "40"});
  EXPECT_LE(worst(seen, model), 3e-3 * model.coefficients[0].r);  // the sun's centre within a texel of 0.012 radians
  EXPECT_LE(worst(sh_of({"light", "sky", "--toward", "0,1,1"}),
                  sh_of({"light", "sky", "--azimuth", "90", "--elevation", "45"})),
            1e-9 * model.coefficients[0].r);
}

TEST_F(CliCoefficients, ATurnMeansTheSameForCoefficientsAndPictures) {
  good({"testcard", "--size", "256", "-o", "card.exr"});
  good({"sh", "card.exr", "--bands", "6", "-o", "card.json"});
  int compared = 0;
  for (const std::string turn : {"90", "-37", "20,50", "10,-70,33", "0,0,120"}) {
    const ShFile picture = sh_of({"sh", "card.exr", "--bands", "6", "--rotate", turn}),
                 turned = sh_of({"sh", "card.json", "--rotate", turn});
    // By a quarter the texels of a panorama move as they are, which are floats. Else it is resampled: edges are
    // smoothed over a texel or two of 0.012 radians, which takes (5 * 0.02)^2/6 from the last band.
    EXPECT_LE(worst(picture, turned), (turn == "90" ? 1e-7 : 1e-3) * turned.coefficients[0].g) << turn;
    EXPECT_GT(worst(picture, parse_sh_json(bytes_of(path("card.json")))), 0.05) << turn;
    ++compared;
  }
  EXPECT_EQ(compared, 5);
  // A light that is turned lies where it would have been made; yaw to the left, pitch up.
  good({"light", "cone", "--half-angle", "25", "--toward", "1,0,0", "--bands", "8", "-o", "ahead.json"});
  EXPECT_LE(
      worst(sh_of({"sh", "ahead.json", "--rotate", "30,40"}),
            sh_of({"light", "cone", "--half-angle", "25", "--azimuth", "30", "--elevation", "40", "--bands", "8"})),
      1e-14);
}

TEST_F(CliCoefficients, BandsAndQuantities) {
  good({"light", "cone", "--half-angle", "40", "--bands", "3", "-o", "c.json"});
  const Result fewer = good({"sh", "c.json", "--bands", "2"}), more = good({"sh", "c.json", "--bands", "5"});
  EXPECT_NE(fewer.err.find("the first 2 of the 3 bands"), std::string::npos) << fewer.err;
  EXPECT_NE(more.err.find("the file has 3 bands"), std::string::npos) << more.err;
  const ShFile two = parse_sh_json(fewer.out), five = parse_sh_json(more.out);
  EXPECT_EQ(two.coefficients.bands(), 2);
  ASSERT_EQ(five.coefficients.bands(), 5);
  EXPECT_EQ(five.coefficients(3, 0), RgbD());
  EXPECT_EQ(five.coefficients(2, 0), parse_sh_json(bytes_of(path("c.json"))).coefficients(2, 0));

  good({"sh", "c.json", "--quantity", "irradiance", "-o", "e.json"});
  // Its own quantity unless told.
  EXPECT_EQ(sh_of({"sh", "e.json"}).quantity, ShQuantity::kIrradiance);
  EXPECT_LE(worst(sh_of({"sh", "e.json", "--quantity", "radiance"}), parse_sh_json(bytes_of(path("c.json")))), 1e-14);
  const ShFile e = sh_of({"sh", "e.json"}), white = sh_of({"sh", "e.json", "--quantity", "irradiance/pi"});
  EXPECT_NEAR(e.coefficients(1, 0).g / white.coefficients(1, 0).g, kPi, 1e-14);

  good({"sh", "c.json", "--bands", "5", "--quantity", "irradiance", "-o", "e5.json"});
  bad(2, {"sh", "e5.json", "--quantity", "radiance"}, "radiance cannot be had");
  bad(2, {"sh", "c.json", "--bands", "5", "--to", "filament"}, "filament takes 3 bands");
  bad(2, {"sh", "c.json", "--to", "filament", "--quantity", "irradiance"}, "filament stores irradiance/pi");
  // The engine's numbers are the same from the picture's coefficients as from the picture.
  good({"testcard", "--size", "64", "-o", "card.exr"});
  good({"sh", "card.exr", "-o", "card.json"});
  EXPECT_EQ(good({"sh", "card.json", "--to", "unity"}).out, good({"sh", "card.exr", "--to", "unity"}).out);
  EXPECT_EQ(good({"sh", "card.json", "--engine", "unity"}).out, good({"sh", "card.json", "--to", "unity"}).out);
}

TEST_F(CliCoefficients, WindowsDoWhatThePaperSays) {
  good({"light", "directional", "--bands", "6", "-o", "delta.json"});
  const auto windowed = [&](const std::string& window) {
    const Result result = good({"sh", "delta.json", "--window", window});
    EXPECT_NE(result.err.find("least value"), std::string::npos) << result.err;
    return parse_sh_json(result.out);
  };
  // Sloan 2008: of the 36/4pi in the middle of a 6-band delta these widths leave 2.25.
  EXPECT_NEAR(at(windowed("hann:12.010498"), kUp), 2.25, 1e-6);
  EXPECT_NEAR(at(windowed("lanczos:9.872527"), kUp), 2.25, 1e-6);
  const ShFile delta = parse_sh_json(bytes_of(path("delta.json"))), hann = windowed("hann"),
               squared = windowed("lanczos:6:2");
  EXPECT_NEAR(hann.coefficients(5, 0).r / delta.coefficients(5, 0).r, 0.066987298107781, 1e-14);
  EXPECT_NEAR(squared.coefficients(3, 0).r / delta.coefficients(3, 0).r, 0.636619772367581 * 0.636619772367581, 1e-14);

  // ... and these weights bring its squared Laplacian to 10 % and 50 %.
  int compared = 0;
  for (const auto& [fraction, weight] : {std::pair{"0.1", 0.00420855331055888}, {"0.5", 0.000631543536668657}}) {
    const auto json = nlohmann::json::parse(
        good({"sh", "delta.json", "--window", std::string("laplacian:") + fraction, "--json"}).out);
    EXPECT_NEAR(json.at("window").at("weights").at(0).get<double>() / weight, 1, 1e-12);
    EXPECT_NEAR(json["window"]["factors"][0][2].get<double>(), 1 / (1 + 36 * weight), 1e-12);
    const double before = json.at("minimum").at("before"), after = json["minimum"]["after"];
    EXPECT_LT(before, -0.2);
    EXPECT_GT(after, before);
    EXPECT_LE(json["minimum"]["guaranteed_after"].get<double>(), after);
    ++compared;
  }
  EXPECT_EQ(compared, 2);
  EXPECT_EQ(windowed("laplacian"), windowed("laplacian:0.5"));
  EXPECT_LE(worst(windowed("laplacian-weight:0.00420855331055888"), windowed("laplacian:0.1")), 1e-14);
}

TEST_F(CliCoefficients, ANonNegativeWindowLeavesNothingNegative) {
  good({"light", "cone", "--half-angle", "15", "--radiance", "4,2,1", "--bands", "6", "-o", "cone.json"});
  int searched = 0;
  for (const std::string family : {"", ":hann", ":lanczos", ":laplacian"}) {
    const ShFile sh = sh_of({"sh", "cone.json", "--window", "nonnegative" + family});
    const double mean = sh.coefficients[0].r / std::sqrt(4 * kPi);
    double least = 1;
    for (const Vec3 d : spiral_directions(4000)) least = std::min(least, evaluate(sh.coefficients, d).r);
    EXPECT_GE(least, -1e-5 * mean) << family;
    EXPECT_LE(least, 0.05 * mean) << family;  // not stronger than it must be
    ++searched;
  }
  EXPECT_EQ(searched, 4);
  bad(2, {"sh", "cone.json", "--window", "nonnegative", "--bands", "65"}, "64 bands at most");
  // What is not negative is left alone.
  good({"light", "hemisphere", "--ground", "1", "-o", "even.json"});
  const Result even = good({"sh", "even.json", "--window", "nonnegative"});
  EXPECT_NE(even.err.find("no window is needed"), std::string::npos) << even.err;
  EXPECT_EQ(parse_sh_json(even.out), parse_sh_json(bytes_of(path("even.json"))));
}

TEST_F(CliCoefficients, WindowsOfEachChannel) {
  // Red is a sharp light, green a constant, blue both.
  good({"light", "hemisphere", "--toward", "1,2,3", "--radiance", "2,1,3", "--ground", "0,1,1", "--bands", "5", "-o",
        "h.json"});
  const auto json =
      nlohmann::json::parse(good({"sh", "h.json", "--window", "laplacian:0.2", "--channels", "each", "--json"}).out);
  ASSERT_EQ(json.at("window").at("weights").size(), 3u);
  EXPECT_EQ(json["window"]["weights"][1], 0);  // nothing to reduce
  EXPECT_NEAR(json["window"]["weights"][0].get<double>(), json["window"]["weights"][2].get<double>(), 1e-12);
  EXPECT_EQ(nlohmann::json::parse(good({"sh", "h.json", "--window", "laplacian:0.2", "--json"}).out)
                .at("window")
                .at("weights")
                .size(),
            1u);
  bad(2, {"sh", "h.json", "--window", "hann", "--channels", "each"}, "only the window laplacian");
  bad(2, {"sh", "h.json", "--channels", "each"}, "--channels");
  for (const std::string window : {"han", "hann:0", "hann:-2", "hann:x", "hann:3:3", "lanczos:6:0", "laplacian:0",
                                   "laplacian:2", "laplacian-weight", "nonnegative:box", "hann:", ":"}) {
    EXPECT_EQ(run({"sh", "h.json", "--window", window}).code, 2) << window;
  }
}

}  // namespace
}  // namespace zonal
