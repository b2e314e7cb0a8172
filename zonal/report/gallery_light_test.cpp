#include "zonal/report/gallery_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>

#include "zonal/base/error.h"
#include "zonal/light/synthetic.h"
#include "zonal/report/gallery_light_figures.h"
#include "zonal/report/html_check.h"
#include "zonal/report/iso_lines.h"
#include "zonal/report/sheet_check.h"
#include "zonal/report/sphere_disc.h"
#include "zonal/sh/eval.h"
#include "zonal/sh/window.h"

namespace zonal {
namespace {

const Projection kFlat = {Layout::kEquirect};

/// Numbers of a figure that hold; the others fail the test.
int held(const GalleryFigure& figure) {
  int count = 0;
  for (const PublishedNumber& n : figure.numbers) {
    EXPECT_TRUE(holds(n)) << figure.id << ": " << n.what << ' ' << n.ours << " for " << n.expected;
    count += holds(n);
  }
  return count;
}

std::vector<Image<Rgb8>> pictures_of(const GalleryFigure& figure) { return pictures_in(figure.pictures.at(0).svg); }

/// Calls visit(x, y, right, up) for the pixels of a disc, one pixel inside its rim; right and up in -1..1. How many.
template <class Visit>
int for_disc(const Image<Rgb8>& picture, Visit&& visit) {
  const double radius = picture.width() / 2.0;
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const double right = (x + 0.5) / radius - 1, up = 1 - (y + 0.5) / radius;
      if (std::hypot(right, up) > 1 - 1 / radius) continue;
      visit(x, y, right, up);
      ++count;
    }
  }
  return count;
}

int count_in_disc(const Image<Rgb8>& picture, const std::function<bool(Rgb8)>& wanted) {
  int count = 0;
  for_disc(picture, [&](int x, int y, double, double) { count += wanted(picture(x, y)); });
  return count;
}

/// The largest difference of any channel in the disc.
int difference_of(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  int largest = 0;
  for_disc(a, [&](int x, int y, double, double) {
    const Rgb8 p = a(x, y), q = b(x, y);
    largest = std::max({largest, std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
  });
  return largest;
}

Rgb8 at(const Image<Rgb8>& picture, double right, double up) {
  return picture(static_cast<int>((1 + right) / 2 * picture.width()),
                 static_cast<int>((1 - up) / 2 * picture.height()));
}
Rgb8 at(const Image<Rgb8>& picture, DiscPlace place) { return at(picture, 2 * place.x - 1, 1 - 2 * place.y); }

/// Three lamps of different colour, size and brightness in a dim room.
Environment three_lamps() {
  return paint(kFlat, {128, 64}, [](Vec3 d) {
    Rgb light = {0.2f, 0.2f, 0.2f};
    const auto lamp = [&](Vec3 toward, double half_angle_deg, Rgb radiance) {
      if (angle_between(d, normalize(toward)) < radians(half_angle_deg)) light += radiance;
    };
    lamp({1, 0.2, 0.5}, 20, {12, 9, 6});
    lamp({-0.3, 1, 0.2}, 25, {2, 4, 7});
    lamp({0, -0.6, -0.7}, 15, {9, 1, 1});
    return light;
  });
}

TEST(SlowGalleryLight, ARotatingLightChangesTheCubeAlone) {
  const GalleryFigure figure = rotating_light_figure();
  EXPECT_EQ(held(figure), 4);
  const std::vector<Image<Rgb8>> balls = pictures_of(figure);
  ASSERT_EQ(balls.size(), 14u);
  for (std::size_t i = 1; i < 7; ++i) {
    EXPECT_LE(difference_of(balls[i], balls[0]), 1);  // a rounding to another code
    if (i < 6) {
      EXPECT_GT(difference_of(balls[7 + i], balls[7]), 20);
    }
  }
  EXPECT_LE(difference_of(balls[13], balls[7]), 1);  // a quarter turn brings the cube onto itself
}

TEST(SlowGalleryLight, AYellowLightLeavesABlueBand) {
  const GalleryFigure figure = yellow_light_figure();
  EXPECT_EQ(held(figure), 6);
  const std::vector<Image<Rgb8>> balls = pictures_of(figure);
  ASSERT_EQ(balls.size(), 5u);
  const Image<Rgb8>&plain3 = balls[0], &hann3 = balls[1], &truth = balls[2], &plain6 = balls[3], &hann6 = balls[4];
  const auto blue = [](Rgb8 c) { return c.b - c.r; };
  const auto bluest = [&](const Image<Rgb8>& ball) {
    int most = -255;
    for_disc(ball, [&](int x, int y, double, double) { most = std::max(most, blue(ball(x, y))); });
    return most;
  };
  EXPECT_EQ(bluest(truth), 0);
  EXPECT_GT(bluest(plain3), 35);
  EXPECT_GT(bluest(plain3), bluest(hann3) + 15);
  EXPECT_GT(bluest(plain6), bluest(hann6) + 10);

  // The band lies where the kernel of 3 bands is least, at a cosine of -8/15 to the light.
  const Vec3 toward = normalize({-0.5, 0.68, 0.54});
  double sum = 0;
  int pixels = 0;
  const int deepest = bluest(plain3);
  for_disc(plain3, [&](int x, int y, double right, double up) {
    if (blue(plain3(x, y)) < deepest) return;
    sum += dot(toward, {std::sqrt(1 - right * right - up * up), right, up});
    ++pixels;
  });
  ASSERT_GT(pixels, 100);
  EXPECT_NEAR(sum / pixels, -8.0 / 15, 0.02);
  // Opposite the light 3 bands are yellow, 6 bands blue.
  EXPECT_LT(blue(at(plain3, -toward.y, -toward.z)), -20);
  EXPECT_GT(blue(at(plain6, -toward.y, -toward.z)), 15);
}

TEST(SlowGalleryLight, ContentKeepsTheHighlightAndLosesTheRings) {
  const GalleryFigure figure = content_window_figure();
  EXPECT_EQ(held(figure), 9);
  const std::vector<Image<Rgb8>> balls = pictures_of(figure);
  ASSERT_EQ(balls.size(), 4u);
  const auto black = [](Rgb8 c) { return c.g == 0; };
  EXPECT_GT(count_in_disc(balls[0], black), 5000);
  EXPECT_EQ(count_in_disc(balls[1], black), 0);
  EXPECT_EQ(count_in_disc(balls[2], black), 0);
  // How far the highlight reaches: what is at least half as bright as white.
  const auto bright = [](Rgb8 c) { return c.g >= 188; };
  const int sharp = count_in_disc(balls[0], bright), broad = count_in_disc(balls[1], bright),
            content = count_in_disc(balls[2], bright);
  EXPECT_GT(sharp, 3000);
  EXPECT_GT(broad, 1.2 * sharp);
  EXPECT_LT(content, 1.1 * sharp);
  // The weight is zero over more than half of all directions and one at the light alone.
  EXPECT_GT(count_in_disc(balls[3], black), 20000);
  EXPECT_GT(count_in_disc(balls[3], [](Rgb8 c) { return c.g >= 250; }), 50);
}

TEST(SlowGalleryLight, AHoleIsDark) {
  const GalleryFigure figure = hole_in_the_sky_figure();
  EXPECT_EQ(held(figure), 5);
  const std::vector<Image<Rgb8>> discs = pictures_of(figure);
  ASSERT_EQ(discs.size(), 8u);
  const Image<Rgb8>&sky = discs[0], &left = discs[2], &truth = discs[3], &sky_sh = discs[4], &product = discs[6];
  const DiscPlace hole = sphere_disc_place(normalize({0.62, -0.42, 0.66}));
  EXPECT_EQ(at(left, hole), Rgb8());
  EXPECT_EQ(at(product, hole), Rgb8());  // below zero there: the band limit overshoots
  EXPECT_GT(at(sky, hole).b, 100);
  EXPECT_GT(at(sky_sh, hole).b, 60);
  // Away from the hole nothing was taken.
  int same = 0;
  for_disc(sky, [&](int x, int y, double right, double up) {
    const Vec3 d = sphere_disc_direction({(1 + right) / 2, (1 - up) / 2});
    if (angle_between(d, normalize({0.62, -0.42, 0.66})) < radians(37)) return;
    EXPECT_EQ(sky(x, y), left(x, y));
    ++same;
  });
  EXPECT_GT(same, 50000);
  EXPECT_LT(difference_of(product, truth), difference_of(sky_sh, truth));
}

TEST(SlowGalleryLight, MoreBandsHoldMoreOfAProbe) {
  const GalleryFigure figure = probe_bands_figure(shown_probe(three_lamps(), {}));
  EXPECT_EQ(held(figure), 8);
  const std::vector<Image<Rgb8>> discs = pictures_of(figure);
  ASSERT_EQ(discs.size(), 7u);
  for (std::size_t i = 1; i < 6; ++i) EXPECT_GT(figure.numbers[i].ours, figure.numbers[i - 1].ours);
  EXPECT_EQ(count_in_disc(discs[0], [&](Rgb8 c) { return c == discs[0](100, 100); }),
            for_disc(discs[0], [](auto...) {}));
  // The mean stands at a third before the curve L/(1 + L): a quarter of the display's light.
  const Rgb8 mean = discs[0](100, 100);
  EXPECT_NEAR(luminance(Rgb(srgb_decode(mean.r / 255.0f), srgb_decode(mean.g / 255.0f), srgb_decode(mean.b / 255.0f))),
              0.25, 0.005);
  for (std::size_t i = 1; i < 7; ++i) EXPECT_GT(difference_of(discs[i], discs[i - 1]), 50);
}

TEST(SlowGalleryLight, ThreeLampsAreFoundAndMarked) {
  const ShownProbe probe = shown_probe(three_lamps(), {});
  const GalleryFigure figure = extracted_lights_figure(probe);
  EXPECT_EQ(held(figure), 13);
  const std::size_t first = figure.numbers.size() - 3;
  EXPECT_LT(figure.numbers[first].ours, 0.1);  // three lights explain three lamps
  EXPECT_LT(figure.numbers[first].ours, figure.numbers[first + 1].ours);
  EXPECT_LT(figure.numbers[first + 1].ours, figure.numbers[first + 2].ours);
  ASSERT_EQ(pictures_of(figure).size(), 8u);
  const std::string& svg = figure.pictures[0].svg;
  int rings = 0;
  for (std::size_t found = 0; (found = svg.find("stroke=\"#fff\"", found)) != std::string::npos; ++found) ++rings;
  EXPECT_EQ(rings, 3 + 2 + 1);
}

TEST(SlowGalleryLight, BlueIsWhereTheFunctionIsNegative) {
  const ShownProbe probe = shown_probe(three_lamps(), {});
  const GalleryFigure figure = windowed_probe_figure(probe);
  EXPECT_EQ(held(figure), 5);
  const std::vector<Image<Rgb8>> pictures = pictures_of(figure);
  ASSERT_EQ(pictures.size(), 8u);
  std::vector<double> share;
  const auto compare = [&](const Image<Rgb8>& plot, const Window& with) {
    const Sh<double> light = luminance(window(probe.radiance, with));
    int compared = 0, negative = 0;
    for_disc(plot, [&](int x, int y, double right, double up) {
      const Vec3 seen_toward = sphere_disc_direction({(1 + right) / 2, (1 - up) / 2});
      const double value = evaluate(light, probe.world_from_view * seen_toward);
      if (std::abs(value) < 1e-9) return;  // its sign is a matter of rounding
      const Rgb8 c = plot(x, y);
      EXPECT_EQ(c.b > c.r && c.b > c.g, value < 0) << x << ' ' << y;
      ++compared;
      negative += value < 0;
    });
    EXPECT_GT(compared, 60000);
    share.push_back(static_cast<double>(negative) / compared);
  };
  compare(pictures[0], Window::none());
  compare(pictures[4], Window::hann(6));
  compare(pictures[7], Window::hann(12.0105));
  EXPECT_GT(share[0], 0.1);
  EXPECT_GT(share[0], share[2]);
  EXPECT_GT(share[2], share[1]);
}

TEST(SlowGalleryLight, EveryNumberHoldsForEveryProbe) {
  Environment one_pixel = furnace(kFlat, {4, 2}, {0, 0, 0});
  one_pixel.radiance(1, 0) = {0, 1e4f, 0};
  Environment faint = three_lamps();
  for (Rgb& c : faint.radiance.values()) c = 1e-30f * c;
  const std::vector<Environment> probes = {
      daylight_sky(kFlat, {256, 128}),
      testcard({Layout::kAngular}, {128, 128}),
      testcard({Layout::kCubeCross}, {64, 48}),
      furnace(kFlat, {32, 16}, {0.7f, 0.7f, 0.7f}),
      furnace(kFlat, {2, 1}, {0, 0, 0}),
      furnace(kFlat, {32, 16}, {-1, -1, -1}),
      gradient(kFlat, {64, 32}),
      one_pixel,
      faint,
  };
  int compared = 0;
  for (const Environment& environment : probes) {
    const ShownProbe probe = shown_probe(environment, {});
    for (const auto& figure :
         {probe_bands_figure(probe), extracted_lights_figure(probe), windowed_probe_figure(probe)}) {
      SCOPED_TRACE(compared);
      compared += held(figure);
      const HtmlCheck check = HtmlReader::read("<h1>figure</h1>" + figure.pictures.at(0).svg);
      EXPECT_EQ(check.problems, std::vector<std::string>());
      EXPECT_EQ(check.text.find("nan"), std::string::npos);
      EXPECT_EQ(figure.pictures[0].svg.find("=\"nan"), std::string::npos);
      for (const PublishedNumber& n : figure.numbers) EXPECT_TRUE(std::isfinite(n.ours)) << n.what;
    }
  }
  EXPECT_EQ(compared, 9 * (8 + 13 + 5) - 1);  // a negative mean has no window that helps
}

TEST(SlowGalleryLight, BlackIsBlack) {
  const ShownProbe probe = shown_probe(furnace(kFlat, {2, 1}, {0, 0, 0}), {});
  const auto black = [](Rgb8 c) { return c == Rgb8(); };
  const auto zero = [](Rgb8 c) { return c == iso_color(0, {}); };
  int discs = 0;
  const auto expect_all = [&](const Image<Rgb8>& picture, const std::function<bool(Rgb8)>& wanted) {
    EXPECT_TRUE(std::ranges::all_of(picture.values(), wanted));
    ++discs;
  };
  for (const Image<Rgb8>& disc : pictures_of(probe_bands_figure(probe))) expect_all(disc, black);
  for (const Image<Rgb8>& disc : pictures_of(extracted_lights_figure(probe))) expect_all(disc, black);
  const std::vector<Image<Rgb8>> windowed = pictures_of(windowed_probe_figure(probe));
  ASSERT_EQ(windowed.size(), 8u);
  for (const std::size_t i : {0, 4, 7}) expect_all(windowed[i], zero);
  for (const std::size_t i : {1, 2, 5, 6}) expect_all(windowed[i], black);
  EXPECT_EQ(discs, 7 + 8 + 7);
}

TEST(SlowGalleryLight, RefusesWhatIsNoNumber) {
  int refused = 0;
  for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Environment probe = furnace(kFlat, {8, 4});
    probe.radiance(3, 1).g = wrong;
    try {
      shown_probe(probe, {});
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      ++refused;
    }
  }
  EXPECT_EQ(refused, 2);
}

TEST(SlowGalleryLight, AllFiguresInTheOrderOfThePaperOnAnyThreads) {
  zonal::Run one, three;
  one.threads = 1;
  three.threads = 3;
  const std::vector<GalleryFigure> figures = gallery_lights(three_lamps(), one),
                                   again = gallery_lights(three_lamps(), three);
  const std::vector<std::string> ids = {"rotating-light", "probe-bands",    "extracted-lights", "windowed-probe",
                                        "yellow-light",   "content-window", "hole-in-the-sky"};
  ASSERT_EQ(figures.size(), ids.size());
  ASSERT_EQ(again.size(), ids.size());
  std::size_t bytes = 0;
  int compared = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    EXPECT_EQ(figures[i].id, ids[i]);
    EXPECT_FALSE(figures[i].title.empty() || figures[i].source.empty() || figures[i].caption.empty());
    ASSERT_EQ(figures[i].pictures.size(), 1u);
    EXPECT_EQ(figures[i].pictures[0].name, ids[i]);
    EXPECT_FALSE(figures[i].pictures[0].alt.empty());
    EXPECT_EQ(figures[i].pictures[0].svg, again[i].pictures[0].svg);
    bytes += figures[i].pictures[0].svg.size();
    compared += held(figures[i]);
  }
  EXPECT_EQ(compared, 4 + 8 + 13 + 5 + 6 + 9 + 5);
  EXPECT_LT(bytes, 3e6);  // what a page can carry
}

TEST(SlowGalleryLight, CanBeCancelled) {
  std::stop_source source;
  source.request_stop();
  zonal::Run run;
  run.stop = source.get_token();
  EXPECT_THROW(gallery_lights(three_lamps(), run), Error);
}

}  // namespace
}  // namespace zonal
