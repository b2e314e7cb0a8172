// What a picture of each technique costs, 1280x720, one object, and the data they share. Of what the graphics driver
// does: Mesa's llvmpipe, on the processor, where there is no other.
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <string>
#include <vector>

#include "zonal/gl/context.h"
#include "zonal/gl/scene.h"
#include "zonal/gl/target.h"
#include "zonal/light/synthetic.h"

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point since) {
  return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
}

/// Of one picture; the processor's time is that of all threads, and says more on a machine that others use too.
struct Cost {
  double ms = 0, processor_ms = 0;
};

/// The medians of some pictures, the first (in which the driver compiles) left out; with their copy to another target.
Cost frame_cost(zonal::Scene& scene, const zonal::ViewState& state, const zonal::DrawTarget& target,
                const zonal::DrawTarget* copy = nullptr) {
  std::vector<double> times, processor;
  for (int i = 0; i < 10; ++i) {
    const auto start = Clock::now();
    const std::clock_t ticks = std::clock();
    target.bind();
    scene.draw(state, target.width(), target.height());
    if (copy != nullptr) target.copy_to(*copy, 0, target.height());
    glFinish();
    if (i == 0) continue;
    times.push_back(milliseconds(start));
    processor.push_back(1000.0 * static_cast<double>(std::clock() - ticks) / CLOCKS_PER_SEC);
  }
  std::ranges::sort(times);
  std::ranges::sort(processor);
  return {times[4], processor[4]};
}

}  // namespace

int main() {
  using namespace zonal;
  const Environment sky = daylight_sky({Layout::kEquirect}, image_size(Layout::kEquirect, 256));
  const auto start = Clock::now();
  const std::clock_t ticks = std::clock();
  const ViewData data = view_data(sky);
  fmt::print("view_data of 256 rows: {:.0f} ms, {:.0f} ms of processor\n", milliseconds(start),
             1000.0 * static_cast<double>(std::clock() - ticks) / CLOCKS_PER_SEC);

  const OffscreenContext context;
  Scene scene;
  scene.set_light(data);
  scene.set_mesh(torus_knot_mesh());
  constexpr int kWidth = 1280, kHeight = 720;
  const DrawTarget plain(kWidth, kHeight, {.texels = TargetTexels::kBytes}),
      smooth(kWidth, kHeight, {.texels = TargetTexels::kBytes, .samples = kEdgeSamples});
  fmt::print("{}, {}x{}, torus knot\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)), kWidth, kHeight);
  for (const Technique& technique : all_techniques()) {
    ViewState state;
    state.technique = &technique;
    const Cost cost = frame_cost(scene, state, plain), smoothed = frame_cost(scene, state, smooth, &plain);
    fmt::print(
        "  {:20} {:6.1f} ms {:6.1f} pictures a second {:6.1f} ms of processor, {:.2f} times that with smooth edges\n",
        technique.id, cost.ms, 1000 / cost.ms, cost.processor_ms, smoothed.processor_ms / cost.processor_ms);
  }
}
