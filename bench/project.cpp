// Few bands of a large panorama, against reading its pixels once at full speed.
#include <cstdio>
#include <numeric>

#include "bench/stopwatch.h"
#include "zonal/light/project.h"

namespace {

using namespace zonal;

using Vec = float __attribute__((vector_size(64)));

/// Every pixel once, as fast as memory gives it.
double read_once(const Image<Rgb>& image) {
  const auto* data = reinterpret_cast<const Vec*>(image.values().data());
  const std::size_t count = image.size() * sizeof(Rgb) / sizeof(Vec);
  Vec sums[8] = {};
  for (std::size_t i = 0; i + 8 <= count; i += 8) {
    for (int k = 0; k < 8; ++k) {
      Vec v;
      __builtin_memcpy(&v, data + i + k, sizeof v);
      sums[k] += v;
    }
  }
  double total = 0;
  for (const Vec& sum : sums) {
    for (int k = 0; k < 16; ++k) total += sum[k];
  }
  return total;
}

double sum_of(const Sh<RgbD>& sh) {
  double total = 0;
  for (const RgbD& c : sh.values()) total += c.r + c.g + c.b;
  return total;
}

}  // namespace

int main() {
  for (const int height : {512, 1024, 2048}) {
    Environment sky{Image<Rgb>(2 * height, height), {Layout::kEquirect}};
    for (std::size_t i = 0; i < sky.radiance.size(); ++i) {
      const float v = 0.5f + static_cast<float>(i % 977) / 977;
      sky.radiance.values()[i] = {v, 1, 2 * v};
    }
    std::vector<bench::Contender> contenders = {{"read the pixels once", [&] { return read_once(sky.radiance); }}};
    for (const int bands : {3, 6}) {
      for (const Isa isa : available_isas()) {
        Run run;
        run.threads = 1;
        run.isa = isa;
        contenders.push_back({std::to_string(bands) + " bands, " + std::string(name_of(isa)),
                              [&sky, bands, run] { return sum_of(project(sky, bands, run)); }});
      }
    }
    char title[96];
    std::snprintf(title, sizeof title, "project %dx%d RGB float, one core", 2 * height, height);
    bench::race(title, contenders, 15);
  }
  const Sh<RgbD> constant = project({Image<Rgb>(4096, 2048, {0.1f, 1, 7}), {Layout::kEquirect}}, 3);
  std::printf("\nconstant sky 4096x2048: relative error %.1e\n", constant[0].r / (0.1f * std::sqrt(4 * kPi)) - 1);
}
