// The specular chain of a 2048x1024 panorama, 256² to 16² with GGX, and an irradiance map, against importance sampling;
// and how wrong each is.
#include <cmath>
#include <cstdio>
#include <random>

#include "bench/importance.h"
#include "bench/stopwatch.h"
#include "zonal/io/environment_file.h"
#include "zonal/light/convolve.h"
#include "zonal/light/reference.h"
#include "zonal/light/resample.h"
#include "zonal/light/synthetic.h"
#include "zonal/sphere/mapping.h"

namespace {

using namespace zonal;

constexpr Projection kCube{Layout::kCubeStack};
constexpr int kLevels = 5, kSize = 256;

ImageSize cube_size(int face) { return image_size(Layout::kCubeStack, face); }
double alpha_of(int level) { return std::pow(level / (kLevels - 1.0), 2); }

using Chain = std::vector<Image<Rgb>>;

double checksum(const Chain& chain) {
  double total = 0;
  for (const auto& level : chain) {
    for (const Rgb& texel : level.values()) total += texel.g;
  }
  return total;
}

Chain ours(const Environment& sky, const Run& run) {
  Chain chain = {resample(sky, kCube, cube_size(kSize), {}, run).radiance};
  std::vector<Lobe> lobes;
  for (int level = 1; level < kLevels; ++level) lobes.push_back(Lobe::ggx(alpha_of(level)));
  const Convolution convolution(sky, lobes, {}, run);
  for (int level = 1; level < kLevels; ++level) {
    chain.push_back(convolution.render(level - 1, kCube, cube_size(kSize >> level), run).map.radiance);
  }
  return chain;
}

Chain sampled(const Environment& sky, const Run& run) {
  Chain mips = {resample(sky, kCube, cube_size(kSize), {}, run).radiance};
  for (int face = kSize / 2; face >= 1; face /= 2) {
    mips.push_back(resample({mips.back(), kCube}, kCube, cube_size(face), {}, run).radiance);
  }
  Chain chain = {mips[0]};
  for (int level = 1; level < kLevels; ++level) {
    chain.push_back(bench::importance_sampled_ggx(mips, alpha_of(level), kSize >> level, 1024, run.threads));
  }
  return chain;
}

/// RMS error relative to the value at random texels of a level.
double error_of(const Environment& sky, const Image<Rgb>& level, double alpha) {
  std::mt19937 random(1);
  const Mapping mapping(kCube, {level.width(), level.height()});
  std::vector<Vec3> directions;
  std::vector<Rgb> got;
  for (int i = 0; i < 48; ++i) {
    const int x = static_cast<int>(random() % level.width()), y = static_cast<int>(random() % level.height());
    directions.push_back(*mapping.direction({x + 0.5, y + 0.5}));
    got.push_back(level(x, y));
  }
  const auto expected = convolve_at(sky, Lobe::ggx(alpha), directions);
  double squares = 0;
  for (std::size_t i = 0; i < got.size(); ++i) squares += std::pow(got[i].g / expected[i].g - 1, 2);
  return std::sqrt(squares / static_cast<double>(got.size()));
}

}  // namespace

int main(int argc, char** argv) {
  const Projection panorama{Layout::kEquirect};
  Environment sky = argc > 1 ? load_environment(argv[1]).environment : daylight_sky(panorama, {2048, 1024});
  if (sky.radiance.width() != 2048) sky = resample(sky, panorama, {2048, 1024});
  Run one, two;
  one.threads = 1;
  two.threads = 2;

  bench::race("specular chain, 2048x1024 to 256², 128², 64², 32², 16², GGX",
              {{"importance sampling, 1024 samples, one core", [&] { return checksum(sampled(sky, one)); }},
               {"zonal, one core", [&] { return checksum(ours(sky, one)); }},
               {"zonal, two cores", [&] { return checksum(ours(sky, two)); }}},
              5);
  const Chain theirs = sampled(sky, two), mine = ours(sky, two);
  std::printf("\nRMS error relative to the value, against the sum over all texels\n");
  for (int level = 1; level < kLevels; ++level) {
    std::printf("  level %d, alpha %.4f: sampled %.1e, zonal %.1e\n", level, alpha_of(level),
                error_of(sky, theirs[level], alpha_of(level)), error_of(sky, mine[level], alpha_of(level)));
  }

  std::vector<Lobe> lobes = {Lobe::cosine()};
  for (int level = 1; level < kLevels; ++level) lobes.push_back(Lobe::ggx(alpha_of(level)));
  const Convolution convolution(sky, lobes, {}, one);
  const auto sum = [](const Convolved& c) { return checksum({c.map.radiance}); };
  std::vector<bench::Contender> steps = {
      {"resample to the 256² cube",
       [&] { return checksum({resample(sky, kCube, cube_size(kSize), {}, one).radiance}); }},
      {"analysis for all lobes", [&] { return Convolution(sky, lobes, {}, one).coefficients()[0].g; }},
      {"irradiance 256² after analysis", [&] { return sum(convolution.render(0, kCube, cube_size(256), one)); }}};
  for (int level = 1; level < kLevels; ++level) {
    steps.push_back({"level " + std::to_string(level) + " after analysis",
                     [&, level] { return sum(convolution.render(level, kCube, cube_size(kSize >> level), one)); }});
  }
  bench::race("the steps, one core", steps, 7);
}
