#include "zonal/light/dfg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "zonal/base/error.h"
#include "zonal/math/quadrature.h"
#include "zonal/math/vec.h"

namespace zonal {
namespace {

constexpr std::array kCosines = {0.03, 0.1, 0.3, 0.6, 0.9, 1.0};

/// Heitz 2014, eq. 72: the part of the microsurface that shadows.
double smith_lambda(double cosine, double alpha) {
  const double tangent2 = 1 / (cosine * cosine) - 1;
  return (std::sqrt(1 + alpha * alpha * tangent2) - 1) / 2;
}

/// What the half vector says of a pair of directions.
struct HalfVector {
  double n_dot_h, v_dot_h;
};
HalfVector half_vector(Vec3 v, Vec3 l) {
  const Vec3 h = normalize(v + l);
  return {h.z, dot(v, h)};
}

/// A second opinion that shares neither the variables nor the form of the shadowing: the sum of brdf(v, l) n.l over
/// directions of light, with panels refined around the mirror direction. Returns (scale, bias, charlie).
std::array<double, 3> brute_force(double n_dot_v, double alpha) {
  const double theta_v = std::acos(n_dot_v), finest = alpha * alpha / 50;
  // Edges around `centre` in [0, end], spaced by halves down to `finest`.
  const auto edges_around = [&](double centre, double end) {
    std::vector<double> edges = {0, centre, end};
    for (double gap = 1; gap > finest; gap *= 0.6) {
      edges.insert(edges.end(), {centre - gap, centre + gap, end - gap * gap});
    }
    std::erase_if(edges, [&](double edge) { return edge < 0 || edge > end; });
    std::ranges::sort(edges);
    return edges;
  };
  const Quadrature polar = gauss_legendre_panels(10, edges_around(theta_v, kPi / 2));
  const Quadrature azimuth = gauss_legendre_panels(10, edges_around(0, kPi));  // from the mirror direction, one side
  const Vec3 v = {std::sin(theta_v), 0, n_dot_v};
  std::array<double, 3> sums = {};
  for (std::size_t i = 0; i < polar.size(); ++i) {
    const double cos_l = std::cos(polar.nodes[i]), sin_l = std::sin(polar.nodes[i]);
    const double shadowing = 1 / (1 + smith_lambda(n_dot_v, alpha) + smith_lambda(cos_l, alpha));
    for (std::size_t k = 0; k < azimuth.size(); ++k) {
      const Vec3 l = {-sin_l * std::cos(azimuth.nodes[k]), sin_l * std::sin(azimuth.nodes[k]), cos_l};
      const auto [n_dot_h, v_dot_h] = half_vector(v, l);
      const double weight = 2 * polar.weights[i] * azimuth.weights[k] * sin_l * cos_l;
      const double slope2 = 1 / (n_dot_h * n_dot_h) - 1;
      const double d = 1 / (kPi * alpha * alpha * std::pow(n_dot_h, 4) * std::pow(1 + slope2 / (alpha * alpha), 2));
      const double specular = weight * d * shadowing / (4 * n_dot_v * cos_l), fresnel = std::pow(1 - v_dot_h, 5);
      sums[0] += specular * (1 - fresnel);
      sums[1] += specular * fresnel;
      const double charlie = (2 + 1 / alpha) * std::pow(std::max(0.0, 1 - n_dot_h * n_dot_h), 0.5 / alpha) / (2 * kPi);
      sums[2] += weight * charlie / (4 * (cos_l + n_dot_v - cos_l * n_dot_v));
    }
  }
  return sums;
}

TEST(Dfg, AgreesWithTheSumOverDirectionsOfLight) {
  int compared = 0;
  for (const double roughness : {0.3, 0.5, 0.8, 1.0}) {
    for (const double n_dot_v : kCosines) {
      const double alpha = roughness * roughness;
      const auto [scale, bias, charlie] = brute_force(n_dot_v, alpha);
      const SplitSum sum = ggx_split_sum(n_dot_v, alpha);
      EXPECT_NEAR(sum.scale, scale, 3e-6) << roughness << " " << n_dot_v;
      EXPECT_NEAR(sum.bias, bias, 3e-6) << roughness << " " << n_dot_v;
      EXPECT_NEAR(charlie_albedo(n_dot_v, alpha), charlie, 3e-6) << roughness << " " << n_dot_v;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 24);
}

TEST(Dfg, AgreesForSharpLobesToo) {
  int compared = 0;
  for (const double roughness : {0.05, 0.1, 0.15}) {
    for (const double n_dot_v : {0.01, 0.1, 0.4, 0.95}) {
      const double alpha = roughness * roughness;
      const auto [scale, bias, charlie] = brute_force(n_dot_v, alpha);
      const SplitSum sum = ggx_split_sum(n_dot_v, alpha);
      EXPECT_NEAR(sum.scale, scale, 1e-5) << roughness << " " << n_dot_v;
      EXPECT_NEAR(sum.bias, bias, 1e-5) << roughness << " " << n_dot_v;
      EXPECT_NEAR(charlie_albedo(n_dot_v, alpha), charlie, 1e-5) << roughness << " " << n_dot_v;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 12);
}

TEST(Dfg, KnowsTheClosedFormsAtNormalIncidence) {
  // alpha = 1, n.v = 1: D = 1/pi, v.h = n.h = m, c = n.l = 2 m^2 - 1, masking 2c/(1+c): the albedo is int c/(1+c) dc
  // over [0, 1].
  const SplitSum sum = ggx_split_sum(1, 1);
  EXPECT_NEAR(sum.scale + sum.bias, 1 - std::log(2.0), 1e-12);
  // Charlie, alpha = 1: D = 3/(2 pi) sqrt((1-c)/2), and n.l/(4 (n.l + 1 - n.l)) = c/4: 3/4 int c sqrt((1-c)/2) dc =
  // sqrt(2)/10.
  EXPECT_NEAR(charlie_albedo(1, 1), std::sqrt(2.0) / 10, 1e-12);
}

TEST(Dfg, BecomesAMirror) {
  for (const double n_dot_v : kCosines) {
    const SplitSum sum = ggx_split_sum(n_dot_v, 1e-5);
    const double fresnel = std::pow(1 - n_dot_v, 5);
    EXPECT_NEAR(sum.scale, 1 - fresnel, 1e-6) << n_dot_v;
    EXPECT_NEAR(sum.bias, fresnel, 1e-6) << n_dot_v;
  }
}

TEST(Dfg, NeverReflectsMoreThanArrivesAndLosesMoreTheRougher) {
  int compared = 0;
  for (const double n_dot_v : kCosines) {
    double smoother = 1 + 3e-6;  // the stated error
    for (const double alpha : {1e-4, 0.01, 0.1, 0.3, 0.6, 1.0}) {
      const SplitSum sum = ggx_split_sum(n_dot_v, alpha);
      EXPECT_GT(sum.scale, 0);
      EXPECT_GE(sum.bias, 0);
      // Near grazing a rough surface shows its facets' faces, so the order holds away from it only.
      if (n_dot_v >= 0.6) {
        EXPECT_LT(sum.scale + sum.bias, smoother) << n_dot_v << " " << alpha;
        smoother = sum.scale + sum.bias;
      }
      EXPECT_LT(sum.scale + sum.bias, 1 + 3e-6);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 36);
}

TEST(DfgTable, HoldsItsTexelCentresAndBothVariants) {
  const Image<Rgb> standard = dfg_table(16), multiscatter = dfg_table(16, DfgVariant::kMultiscatter, {.threads = 3});
  ASSERT_EQ(standard.width(), 16);
  ASSERT_EQ(standard.height(), 16);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const double n_dot_v = (x + 0.5) / 16, alpha = std::pow((y + 0.5) / 16, 2);
      const SplitSum sum = ggx_split_sum(n_dot_v, alpha);
      const auto sheen = static_cast<float>(charlie_albedo(n_dot_v, alpha));
      EXPECT_EQ(standard(x, y), Rgb(static_cast<float>(sum.scale), static_cast<float>(sum.bias), sheen));
      EXPECT_EQ(multiscatter(x, y), Rgb(static_cast<float>(sum.bias), static_cast<float>(sum.scale + sum.bias), sheen));
    }
  }
}

TEST(DfgTable, HasTheSameBitsOnAnyNumberOfThreads) {
  const Image<Rgb> one = dfg_table(12, DfgVariant::kStandard, {.threads = 1});
  for (const int threads : {2, 7}) EXPECT_EQ(one, dfg_table(12, DfgVariant::kStandard, {.threads = threads}));
}

TEST(DfgTable, RefusesAbsurdSizesAndStops) {
  EXPECT_THROW(dfg_table(0), Error);
  EXPECT_THROW(dfg_table(5000), Error);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(dfg_table(8, DfgVariant::kStandard, {.stop = stop.get_token()}), Error);
  EXPECT_THROW(ggx_split_sum(0, 0.5), std::logic_error);
}

}  // namespace
}  // namespace zonal
