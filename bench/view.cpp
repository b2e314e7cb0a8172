// What a picture of each technique costs, 1280x720, one object, and the data they share. Of what the graphics driver
// does: Mesa's llvmpipe, on the processor, where there is no other.
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
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

/// The median of some pictures, the first (in which the driver compiles) left out.
double frame_ms(zonal::Scene& scene, const zonal::ViewState& state, int width, int height) {
  std::vector<double> times;
  for (int i = 0; i < 10; ++i) {
    const auto start = Clock::now();
    scene.draw(state, width, height);
    glFinish();
    times.push_back(milliseconds(start));
  }
  times.erase(times.begin());
  std::ranges::nth_element(times, times.begin() + 4);
  return times[4];
}

}  // namespace

int main() {
  using namespace zonal;
  const Environment sky = daylight_sky({Layout::kEquirect}, image_size(Layout::kEquirect, 256));
  const auto start = Clock::now();
  const ViewData data = view_data(sky);
  fmt::print("view_data of 256 rows: {:.0f} ms\n", milliseconds(start));

  const OffscreenContext context;
  Scene scene;
  scene.set_light(data);
  scene.set_mesh(torus_knot_mesh());
  constexpr int kWidth = 1280, kHeight = 720;
  const DrawTarget target(kWidth, kHeight);
  target.bind();
  fmt::print("{}, {}x{}, torus knot\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)), kWidth, kHeight);
  for (const Technique& technique : all_techniques()) {
    ViewState state;
    state.technique = &technique;
    const double ms = frame_ms(scene, state, kWidth, kHeight);
    fmt::print("  {:20} {:6.1f} ms {:6.1f} pictures a second\n", technique.id, ms, 1000 / ms);
  }
}
