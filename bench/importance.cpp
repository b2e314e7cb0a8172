#include "bench/importance.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "zonal/base/parallel.h"
#include "zonal/sphere/cube.h"

namespace zonal::bench {
namespace {

struct Sample {
  Vec3 toward_light;  // in the frame of the normal
  double weight;
  double level;
};

std::vector<Sample> samples_of(double alpha, int count, int source_face) {
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    std::uint32_t bits = static_cast<std::uint32_t>(i);
    bits = (bits << 16) | (bits >> 16);
    for (int shift = 8; shift > 0; shift /= 2) {
      const std::uint32_t mask = shift == 8   ? 0x00ff00ffU
                                 : shift == 4 ? 0x0f0f0f0fU
                                 : shift == 2 ? 0x33333333U
                                              : 0x55555555U;
      bits = ((bits & mask) << shift) | ((bits >> shift) & mask);
    }
    const double u = (i + 0.5) / count, v = bits * 0x1p-32;
    const double cos2 = (1 - u) / (1 + (alpha * alpha - 1) * u), cos_h = std::sqrt(cos2), sin_h = std::sqrt(1 - cos2);
    const Vec3 l = {2 * cos_h * sin_h * std::cos(2 * kPi * v), 2 * cos_h * sin_h * std::sin(2 * kPi * v), 2 * cos2 - 1};
    if (l.z <= 0) continue;
    const double t = cos2 * (alpha * alpha - 1) + 1, pdf = alpha * alpha / (kPi * t * t) / 4;
    const double solid_angle = 1 / (count * pdf), texel = 4 * kPi / (6.0 * source_face * source_face);
    samples.push_back({l, l.z, std::max(0.0, 0.5 * std::log2(solid_angle / texel) + 1)});
  }
  return samples;
}

RgbD read(const Image<Rgb>& cube, Vec3 d) {
  const FacePoint p = face_point(sampler_from_world(d));
  const int n = cube.width();
  const double x = std::clamp((p.u + 1) / 2 * n - 0.5, 0.0, n - 1.0),
               y = std::clamp((p.v + 1) / 2 * n - 0.5, 0.0, n - 1.0);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y), x1 = std::min(x0 + 1, n - 1),
            y1 = std::min(y0 + 1, n - 1);
  const double fx = x - x0, fy = y - y0;
  const auto at = [&](int i, int j) { return RgbD(cube(i, p.face * n + j)); };
  return (1 - fy) * ((1 - fx) * at(x0, y0) + fx * at(x1, y0)) + fy * ((1 - fx) * at(x0, y1) + fx * at(x1, y1));
}

}  // namespace

Image<Rgb> importance_sampled_ggx(const std::vector<Image<Rgb>>& cubes, double alpha, int face_size, int count,
                                  int threads) {
  const std::vector<Sample> samples = samples_of(alpha, count, cubes[0].width());
  const Cube cube(Layout::kCubeStack, face_size);
  Image<Rgb> out(face_size, 6 * face_size);
  Run run;
  run.threads = threads;
  for_each_block(run, {}, out.height(), 4, [&](Block rows) {
    for (int y = rows.begin; y < rows.end; ++y) {
      for (int x = 0; x < face_size; ++x) {
        const Vec3 n = *cube.direction({x + 0.5, y + 0.5});
        const Vec3 t = normalize(cross(std::abs(n.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}, n)), b = cross(n, t);
        RgbD sum;
        double weight = 0;
        for (const Sample& s : samples) {
          const Vec3 l = s.toward_light.x * t + s.toward_light.y * b + s.toward_light.z * n;
          const double level = std::min(s.level, static_cast<double>(cubes.size()) - 1);
          const int low = static_cast<int>(level), high = std::min<int>(low + 1, static_cast<int>(cubes.size()) - 1);
          const double f = level - low;
          sum += s.weight * ((1 - f) * read(cubes[low], l) + f * read(cubes[high], l));
          weight += s.weight;
        }
        out(x, y) = static_cast<Rgb>(1 / weight * sum);
      }
    }
  });
  return out;
}

}  // namespace zonal::bench
