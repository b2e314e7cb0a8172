#include <cstdio>

#include "zonal/sh/eval.h"
#include "zonal/sh/irradiance.h"

int main() {
  zonal::Sh<float, 3> light;
  light(0, 0) = 3.544908f;
  const float e = evaluate(zonal::irradiance(light), {0, 0, 1});
  std::printf("%.5f\n", e);
  return e > 3.1415f && e < 3.1417f ? 0 : 1;
}
