#include "zonal/light/lobe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "zonal/base/error.h"
#include "zonal/math/quadrature.h"
#include "zonal/math/vec.h"

namespace zonal {
namespace {

/// 2 pi int k(c) dc, with panels in 1 - c that shrink towards c = 1 and c = 0 and break at a cone's rim.
double integral(const Lobe& lobe) {
  std::vector<double> edges = {0};
  for (double gap = 0.5; gap > 1e-13; gap /= 1.5) edges.insert(edges.end(), {gap, 1 - gap});
  edges.insert(edges.end(), {1, 1.5, 2});
  if (lobe.kind() == LobeKind::kCone) edges.push_back(2 * std::pow(std::sin(lobe.parameter() / 2), 2));
  std::ranges::sort(edges);
  const Quadrature rule = gauss_legendre_panels(20, edges);
  double sum = 0;
  for (std::size_t i = 0; i < rule.size(); ++i)
    sum += 2 * kPi * rule.weights[i] * lobe.kernel_from_versine(rule.nodes[i]);
  return sum;
}

std::vector<Lobe> lobes() {
  std::vector<Lobe> all = {Lobe::cosine()};
  for (const double s : {0.0, 0.5, 1.0, 7.3, 100.0, 1e5}) all.insert(all.end(), {Lobe::phong(s), Lobe::blinn_phong(s)});
  for (const double alpha : {1e-4, 1e-3, 0.01, 0.1, 0.5, 0.77, 0.775, 0.9, 0.999999, 1.0})
    all.push_back(Lobe::ggx(alpha));
  for (const double alpha : {1e-4, 0.01, 0.1, 0.5, 1.0}) all.push_back(Lobe::charlie(alpha));
  for (const double angle : {1e-6, 0.0047, 0.3, kPi / 2, 2.5, kPi}) all.push_back(Lobe::cone(angle));
  for (const double width : {1e-5, 0.01, 0.3, 2.0, 100.0}) all.push_back(Lobe::gaussian(width));
  return all;
}

TEST(Lobe, IntegratesToOne) {
  for (const Lobe& lobe : lobes()) {
    EXPECT_NEAR(integral(lobe), 1, 1e-12) << name_of(lobe.kind()) << " " << lobe.parameter();  // 2000 terms
  }
}

TEST(Lobe, IsNowhereNegativeNorAboveItsMaximum) {
  for (const Lobe& lobe : lobes()) {
    double greatest = lobe.kernel_from_versine(0);
    for (double c = 1; c > 1e-6; c *= 0.99) {
      EXPECT_GE(lobe.kernel(c), 0);
      EXPECT_GE(lobe.kernel(-c), 0);
      greatest = std::max({greatest, lobe.kernel(c), lobe.kernel(-c)});
    }
    EXPECT_LE(greatest, lobe.kernel_maximum() * (1 + 1e-14)) << name_of(lobe.kind());
    EXPECT_GE(greatest, lobe.kernel_maximum() * 0.999) << name_of(lobe.kind());
  }
}

TEST(Lobe, KernelsAreTheirFormulas) {
  const double c = 0.8;
  EXPECT_NEAR(Lobe::cosine().kernel(c), c / kPi, 1e-16);
  EXPECT_NEAR(Lobe::phong(5).kernel(c) / Lobe::phong(5).kernel(0.5), std::pow(c / 0.5, 5), 1e-13);
  EXPECT_NEAR(Lobe::blinn_phong(7).kernel(c) / Lobe::blinn_phong(7).kernel(0.5), c / 0.5 * std::pow(0.9 / 0.75, 3.5),
              1e-13);
  // n.h = sqrt((1+c)/2); the lobe is D(h) n.l.
  const auto ggx_d = [](double cosine, double a) { return std::pow((1 + cosine) / 2 * (a * a - 1) + 1, -2.0); };
  EXPECT_NEAR(Lobe::ggx(0.3).kernel(c) / Lobe::ggx(0.3).kernel(0.5), c / 0.5 * ggx_d(c, 0.3) / ggx_d(0.5, 0.3), 1e-13);
  const auto charlie_d = [](double cosine, double a) { return std::pow(std::sqrt((1 - cosine) / 2), 1 / a); };
  EXPECT_NEAR(Lobe::charlie(0.3).kernel(c) / Lobe::charlie(0.3).kernel(0.5),
              c / 0.5 * charlie_d(c, 0.3) / charlie_d(0.5, 0.3), 1e-13);
  EXPECT_EQ(Lobe::cone(0.5).kernel(std::cos(0.51)), 0);
  EXPECT_NEAR(Lobe::cone(0.5).kernel(std::cos(0.49)), 1 / (2 * kPi * (1 - std::cos(0.5))), 1e-14);
  EXPECT_NEAR(Lobe::gaussian(0.5).kernel(c) / Lobe::gaussian(0.5).kernel(0.5), std::exp(4 * (c - 0.5)), 1e-13);
  EXPECT_EQ(Lobe::cosine().kernel(-0.1), 0);
}

TEST(Lobe, RoughestLobesAreTheCosine) {
  for (const double c : {0.1, 0.5, 0.9, 1.0}) {
    for (const LobeKind kind : {LobeKind::kGgx, LobeKind::kBlinnPhong, LobeKind::kPhong}) {
      EXPECT_NEAR(lobe_for_roughness(kind, 1).kernel(c), c / kPi, 1e-15) << name_of(kind);
    }
  }
}

TEST(Lobe, RoughnessIsTheRootOfAlpha) {
  EXPECT_EQ(lobe_for_roughness(LobeKind::kGgx, 0.5), Lobe::ggx(0.25));
  EXPECT_EQ(lobe_for_roughness(LobeKind::kCharlie, 0.5), Lobe::charlie(0.25));
  EXPECT_EQ(lobe_for_roughness(LobeKind::kBlinnPhong, 0.5), Lobe::blinn_phong(30));
  EXPECT_EQ(lobe_for_roughness(LobeKind::kPhong, 0.5), Lobe::phong(8.5));
  EXPECT_THROW(lobe_for_roughness(LobeKind::kCone, 0.5), Error);
  EXPECT_THROW(lobe_for_roughness(LobeKind::kGgx, 0), Error);
}

TEST(Lobe, ReachesTheEndsOfItsDomain) {
  for (const LobeKind kind : {LobeKind::kGgx, LobeKind::kCharlie, LobeKind::kBlinnPhong, LobeKind::kPhong}) {
    EXPECT_GT(lobe_for_roughness(kind, 0.01).kernel_maximum(), 1) << name_of(kind);
  }
  // A dot product of unit vectors may exceed 1 by a rounding.
  for (const Lobe& lobe : lobes()) {
    EXPECT_EQ(lobe.kernel(1 + 4e-16), lobe.kernel(1));
    EXPECT_EQ(lobe.kernel(-1 - 4e-16), lobe.kernel(-1));
  }
}

TEST(Lobe, RefusesParametersOutsideItsDomain) {
  EXPECT_THROW(Lobe::ggx(0), Error);
  EXPECT_THROW(Lobe::ggx(1.01), Error);
  EXPECT_THROW(Lobe::ggx(std::nan("")), Error);
  EXPECT_THROW(Lobe::phong(-1), Error);
  EXPECT_THROW(Lobe::cone(4), Error);
  EXPECT_THROW(Lobe::gaussian(0), Error);
  try {
    Lobe::charlie(2);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    EXPECT_FALSE(error.hint().empty());
  }
}

TEST(Lobe, NamesGoBothWays) {
  int kinds = 0;
  for (const LobeKind kind : all_lobe_kinds()) {
    EXPECT_EQ(lobe_kind_named(name_of(kind)), kind);
    ++kinds;
  }
  EXPECT_EQ(kinds, 7);
  EXPECT_FALSE(lobe_kind_named("ggx "));
}

}  // namespace
}  // namespace zonal
