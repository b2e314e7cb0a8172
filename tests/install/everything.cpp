#include <cstdio>

#include "zonal/zonal.h"

int main() {
  using namespace zonal;
  const Environment sky = furnace({Layout::kEquirect}, {64, 32});
  const float white = evaluate(irradiance_over_pi(project<3>(sky)), {0, 0, 1}).g;
  std::printf("%.6f\n", white);
  return white > 0.999999f && white < 1.000001f ? 0 : 1;
}
