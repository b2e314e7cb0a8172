#include "zonal/report/response_figure.h"

#include <array>

#include "zonal/report/figure.h"

namespace zonal {
namespace {

/// Every 15th code, both ends among them: a dot at every one would make the line a worm.
constexpr int kStep = 15;
static_assert((kCodes - 1) % kStep == 0);

ChartSeries series_of(const char* name, const ResponseCurve& curve) {
  ChartSeries series{name, {}};
  for (int z = 0; z < kCodes; z += kStep) series.points.push_back({curve[z], static_cast<double>(z)});
  return series;
}

}  // namespace

std::string response_figure(const Response& response) {
  const auto& [red, green, blue] = response.exposure;
  const bool same = red == green && green == blue;
  LineChart chart{"How the camera answers to light: the code of each exposure",
                  {"exposure: radiance × seconds", true},
                  {"code", false, true, AxisRange{0, 255}},
                  {}};
  if (same) {
    chart.series = {series_of("all channels", red)};
  } else {
    chart.series = {series_of("red", red), series_of("green", green), series_of("blue", blue),
                    series_of("sRGB", Response::srgb().exposure[0])};
  }
  return line_chart(chart);
}

}  // namespace zonal
