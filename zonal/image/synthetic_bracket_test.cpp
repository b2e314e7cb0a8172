#include "zonal/image/synthetic_bracket_test.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "zonal/image/color.h"

namespace zonal::sample {
namespace {

/// A hash of two integers as a number in 0..1.
double hashed(int x, int y) {
  unsigned h = static_cast<unsigned>(x) * 0x9e3779b1u ^ static_cast<unsigned>(y) * 0x85ebca6bu;
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  h ^= h >> 12;
  h *= 0x297a2d39u;
  h ^= h >> 15;
  return h / 4294967296.0;
}

/// Decades of radiance at a point of an endless scene.
double log10_radiance(double x, double y) {
  const double slope = 1.5 * std::sin(x / 47.0) + std::sin(y / 31.0 + x / 83.0);
  const double spots = 0.8 * std::sin(x / 7.0) * std::cos(y / 9.0);
  const auto block_of = [](double at) { return static_cast<int>(std::floor(at / 16)); };
  const double block = 1.2 * (hashed(block_of(x), block_of(y)) - 0.5);
  return std::clamp(slope + spots + block, -2.1, 2.1);
}

Rgb radiance_at(double x, double y) {
  const double level = std::pow(10, log10_radiance(x, y));
  const double warm = 0.3 * std::sin(x / 19.0 - y / 23.0);
  return {static_cast<float>(level * (1 + warm)), static_cast<float>(level), static_cast<float>(level * (1 - warm))};
}

}  // namespace

double srgb_camera(double exposure) { return srgb_encode(static_cast<float>(exposure)); }
double gamma_camera(double exposure) { return std::pow(exposure, 1 / 2.2); }
double film_camera(double exposure) {
  const double t = std::pow(exposure / 0.25, 0.9);
  return t / (1 + t);
}

Image<Rgb> scene(int width, int height, Shift offset) {
  Image<Rgb> radiance(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      radiance(x, y) = radiance_at(x + offset.dx, y + offset.dy);
    }
  }
  return radiance;
}

Image<Rgb> placed_scene(int width, int height, const Placement& placement) {
  constexpr int kSide = 3;
  Image<Rgb> radiance(width, height);
  const Placing placing(placement, {width / 2.0, height / 2.0});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Rgb sum;
      for (int i = 0; i < kSide * kSide; ++i) {
        // Jittered: on a grid, hard edges would move by whole steps of it only.
        const double u = hashed(kSide * x + i % kSide, kSide * y + i / kSide),
                     v = hashed(-kSide * y - i, kSide * x - i);
        const PicturePoint q = placing({x + (i % kSide + u) / kSide, y + (i / kSide + v) / kSide});
        sum = sum + radiance_at(q.x - 0.5, q.y - 0.5);
      }
      radiance(x, y) = (1.0f / (kSide * kSide)) * sum;
    }
  }
  return radiance;
}

Image<Rgb> photograph(const Image<Rgb>& radiance, const Camera& camera, double seconds) {
  // The same on every standard library: Box and Muller on the generator's own bits.
  std::mt19937 bits(camera.seed + static_cast<unsigned>(1000 * std::log2(seconds) + 1e6));
  const auto uniform = [&] { return (static_cast<double>(bits()) + 0.5) / 4294967296.0; };
  const double largest = std::exp2(camera.bits) - 1;
  const auto shoot = [&](float light) {
    double value = camera.encode(light * seconds);
    if (camera.noise_codes > 0)
      value += camera.noise_codes / 255 * std::sqrt(-2 * std::log(uniform())) * std::cos(6.283185307179586 * uniform());
    return static_cast<float>(std::lround(largest * std::clamp(value, 0.0, 1.0))) / static_cast<float>(largest);
  };
  Image<Rgb> encoded(radiance.width(), radiance.height());
  std::transform(radiance.values().begin(), radiance.values().end(), encoded.values().begin(), [&](const Rgb& c) {
    const float r = shoot(c.r), g = shoot(c.g), b = shoot(c.b);
    return Rgb(r, g, b);
  });
  return encoded;
}

Exposures bracket(const Image<Rgb>& radiance, const Camera& camera, const std::vector<double>& seconds) {
  Exposures exposures;
  for (const double t : seconds)
    exposures.push_back({std::to_string(t), t, CodedPicture(photograph(radiance, camera, t))});
  arrange(exposures);
  return exposures;
}

std::vector<double> nine_times() {
  std::vector<double> times;
  for (int i = -4; i <= 4; ++i) times.push_back(std::exp2(2 * i));
  return times;
}

std::vector<double> uneven_times() {
  std::vector<double> times;
  for (const double stops : {-8.0, -6.3, -3.8, -2.0, 0.1, 1.4, 4.1, 5.6, 8.0}) times.push_back(std::exp2(stops));
  return times;
}

std::vector<double> five_times() {
  std::vector<double> times;
  for (int i = -7; i <= 5; i += 3) times.push_back(std::exp2(i));
  return times;
}

}  // namespace zonal::sample
