// A panorama in other projections, one core, against copying as many texels.
#include <string>

#include "bench/stopwatch.h"
#include "zonal/light/resample.h"
#include "zonal/light/synthetic.h"

int main() {
  using namespace zonal;
  const Environment sky = daylight_sky({Layout::kEquirect}, {2048, 1024});
  Run run;
  run.threads = 1;
  const auto sum = [](const Image<Rgb>& image) {
    double total = 0;
    for (const Rgb& texel : image.values()) total += texel.g;
    return total;
  };
  std::vector<bench::Contender> contenders = {{"copy 2048x1024", [&] { return sum(Image<Rgb>(sky.radiance)); }}};
  for (const Layout layout : all_layouts()) {
    if (layout == Layout::kEquirect) continue;
    contenders.push_back({std::string(name_of(layout)), [&, layout] {
                            return sum(resample(sky, {layout}, image_size(layout, 256), {}, run).radiance);
                          }});
  }
  bench::race("resample 2048x1024 to size 256, one core", contenders, 5);
}
