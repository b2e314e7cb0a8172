// Three maps at once, double, 1024 bands, against libsharp where it is installed, and each instruction set.
#include <cmath>
#include <complex>
#include <cstdio>
#include <random>

#include "bench/stopwatch.h"
#include "zonal/sht/transform.h"

#if defined(ZONAL_HAS_LIBSHARP)
#include <libsharp/sharp.h>
#include <libsharp/sharp_almhelpers.h>
#include <libsharp/sharp_geomhelpers.h>
#endif

namespace {

using namespace zonal;

double sum_of(const Grid<RgbD>& map) {
  double total = 0;
  for (const RgbD& c : map.values()) total += c.r + c.g + c.b;
  return total;
}

double sum_of(const Sh<RgbD>& sh) {
  double total = 0;
  for (const RgbD& c : sh.values()) total += c.r + c.g + c.b;
  return total;
}

#if defined(ZONAL_HAS_LIBSHARP)
/// Three scalar transforms, which is what libsharp offers for three maps.
class Sharp {
 public:
  Sharp(int bands, RingGrid grid)
      : alm_(static_cast<std::size_t>(bands) * (bands + 1) / 2), map_(grid.width * grid.height) {
    sharp_make_triangular_alm_info(bands - 1, bands - 1, 1, &alm_info_);
    sharp_make_ecp_geom_info(grid.height, grid.width, 0, 1, grid.width, &geom_info_);
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (auto& a : alm_) a = {normal(random), normal(random)};
  }
  ~Sharp() {
    sharp_destroy_alm_info(alm_info_);
    sharp_destroy_geom_info(geom_info_);
  }
  Sharp(const Sharp&) = delete;
  Sharp& operator=(const Sharp&) = delete;

  double run(sharp_jobtype type) {
    for (int map = 0; map < 3; ++map) {
      void* alm = alm_.data();
      void* pixels = map_.data();
      sharp_execute(type, 0, &alm, &pixels, geom_info_, alm_info_, SHARP_DP | SHARP_NO_OPENMP, nullptr, nullptr);
    }
    return map_[map_.size() / 2] + alm_.back().real();
  }

 private:
  sharp_alm_info* alm_info_ = nullptr;
  sharp_geom_info* geom_info_ = nullptr;
  std::vector<std::complex<double>> alm_;
  std::vector<double> map_;
};
#endif

}  // namespace

int main() {
  for (const int bands : {256, 512, 1024}) {
    const RingGrid grid{2 * bands, bands};
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    Sh<RgbD> sh(bands);
    for (RgbD& c : sh.values()) c = {normal(random), normal(random), normal(random)};
    const Grid<RgbD> map = synthesize_double(sh, grid);
    Grid<RgbD> target(grid.width, grid.height);

    std::vector<bench::Contender> synthesis, analysis;
#if defined(ZONAL_HAS_LIBSHARP)
    Sharp sharp(bands, grid);
    synthesis.push_back({"libsharp, three times", [&] { return sharp.run(SHARP_ALM2MAP); }});
    analysis.push_back({"libsharp, three times", [&] { return sharp.run(SHARP_MAP2ALM); }});
#endif
    for (const Isa isa : available_isas()) {
      Run run;
      run.threads = 1;
      run.isa = isa;
      const std::string name(name_of(isa));
      synthesis.push_back({name, [&, run] {
                             synthesize(sh, target, run);
                             return sum_of(target);
                           }});
      analysis.push_back({name, [&, run] { return sum_of(analyze(map, bands, RingWeights::kFejer, run)); }});
    }
    char title[128];
    std::snprintf(title, sizeof title, "synthesis of three maps, %d bands, %dx%d, double, one core", bands, grid.width,
                  grid.height);
    bench::race(title, synthesis, 5);
    std::snprintf(title, sizeof title, "analysis of three maps, %d bands, %dx%d, double, one core", bands, grid.width,
                  grid.height);
    bench::race(title, analysis, 5);
  }
}
