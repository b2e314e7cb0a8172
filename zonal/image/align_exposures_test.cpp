#include "zonal/image/align_exposures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "zonal/image/merge_exposures.h"
#include "zonal/image/synthetic_bracket_test.h"

namespace zonal {
namespace {

constexpr int kWidth = 320, kHeight = 240;

/// What a camera sees. Moved by whole texels, all see the same values.
Image<Rgb> scene_of(const Placement& hand, bool whole) {
  if (!whole) return sample::placed_scene(kWidth, kHeight, hand);
  return sample::scene(kWidth, kHeight, {static_cast<int>(hand.dx), static_cast<int>(hand.dy)});
}

/// A hand-held bracket: every shot looks elsewhere.
Exposures hand_held(const std::vector<Placement>& hands, const std::vector<double>& seconds, double noise) {
  Exposures bracket;
  const bool whole = std::all_of(hands.begin(), hands.end(), is_whole);
  for (std::size_t k = 0; k < hands.size(); ++k) {
    const Image<Rgb> seen = scene_of(hands[k], whole);
    bracket.push_back(
        {"", seconds[k], CodedPicture(sample::photograph(seen, {sample::srgb_camera, noise}, seconds[k]))});
  }
  arrange(bracket);
  return bracket;
}

/// What the middle shot has at p, shot k has where its own camera saw the same point of the scene.
Placement expected(const std::vector<Placement>& hands, std::size_t k) {
  return composed(inverse(hands[k]), hands[hands.size() / 2]);
}

/// How far apart two placements put a corner of the picture, at most.
double distance_px(const Placement& a, const Placement& b) {
  const PicturePoint center{kWidth / 2.0, kHeight / 2.0};
  const Placing first(a, center), second(b, center);
  double largest = 0;
  for (const PicturePoint corner :
       {PicturePoint{0, 0}, PicturePoint{kWidth, 0}, PicturePoint{0, kHeight}, PicturePoint{kWidth, kHeight}}) {
    const PicturePoint p = first(corner), q = second(corner);
    largest = std::max(largest, std::hypot(p.x - q.x, p.y - q.y));
  }
  return largest;
}

struct Hand {
  const char* name;
  std::vector<Placement> placements;
};
const Hand kHands[] = {
    {"still", {{}, {}, {}, {}, {}}},
    {"whole texels", {{7, -3}, {12, 5}, {}, {-9, 14}, {-20, -6}}},
    {"far", {{-31, 22}, {-3, 40}, {5, 5}, {30, -17}, {55, -33}}},
    {"parts of texels", {{0.37, 0}, {0, -0.37}, {}, {-0.37, 0.21}, {0.63, 0.37}}},
    {"twelve and a half", {{12.6, 0.4}, {0, 12.6}, {}, {-12.6, 3.7}, {0.2, -12.6}}},
    {"a little turned", {{1.2, 0.3, 0.3}, {-0.4, 0.9, -0.3}, {0, 0, 0.1}, {2.1, -1.7, 0.3}, {0.6, 0.1, -0.6}}},
    {"turned", {{3.3, 0.3, 1.5}, {-4.4, 6.9, -1.5}, {0, 0, 0.4}, {8.1, -5.7, 1.9}, {0.6, 0.1, -2.6}}},
};

TEST(SlowAlignExposures, FindsShiftsAndRotations) {
  int found = 0;
  for (const auto& [name, hands] : kHands) {
    for (const double noise : {0.0, 2.0}) {
      Exposures bracket = hand_held(hands, sample::five_times(), noise);
      const std::vector<Alignment> alignments = align_exposures(bracket);
      ASSERT_EQ(alignments.size(), hands.size());
      for (std::size_t k = 0; k < hands.size(); ++k, ++found) {
        EXPECT_TRUE(alignments[k].aligned) << name << ' ' << k;
        // A corner, after up to two pairs three stops apart, the shortest with a fifth of the picture over black.
        EXPECT_LT(distance_px(alignments[k].placement, expected(hands, k)), 0.1) << name << ' ' << k << ' ' << noise;
        EXPECT_EQ(bracket[k].placement, alignments[k].placement);
      }
    }
  }
  EXPECT_EQ(found, 7 * 2 * 5);
}

TEST(AlignExposures, WholeTexelsStayWhole) {
  Exposures bracket = hand_held(kHands[1].placements, sample::five_times(), 1);
  align_exposures(bracket);
  for (std::size_t k = 0; k < bracket.size(); ++k)
    EXPECT_EQ(bracket[k].placement, expected(kHands[1].placements, k)) << k;
}

TEST(AlignExposures, WhatMovesByItselfDoesNotPull) {
  const std::vector<Placement> hands = {{2.37, -1.2, 0.3}, {}, {-3.4, 0.6, -0.4}};
  const std::vector<double> seconds = {0.125, 1, 8};
  Exposures bracket;
  for (int k = 0; k < 3; ++k) {
    Image<Rgb> seen = sample::placed_scene(kWidth, kHeight, hands[k]);
    // Two squares that cross the picture, a sixth of its area.
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        if (x >= 40 + 30 * k && x < 120 + 30 * k && y >= 30 && y < 110) seen(x, y) = {1.5f, 1.2f, 1};
        if (x >= 200 - 25 * k && x < 280 - 25 * k && y >= 130 && y < 210) seen(x, y) = {0.3f, 0.2f, 0.1f};
      }
    }
    bracket.push_back({"", seconds[k], CodedPicture(sample::photograph(seen, {sample::srgb_camera, 1.0}, seconds[k]))});
  }
  const std::vector<Alignment> alignments = align_exposures(bracket);
  for (int k = 0; k < 3; ++k) {
    EXPECT_TRUE(alignments[k].aligned);
    EXPECT_LT(distance_px(alignments[k].placement, expected(hands, k)), 0.15) << k;
  }
}

TEST(AlignExposures, SixStopsApart) {
  const std::vector<Placement> hands = {{4.63, 2.37, 0.7}, {}};
  Exposures bracket = hand_held(hands, {1.0 / 16, 4}, 1);
  const std::vector<Alignment> alignments = align_exposures(bracket);
  EXPECT_TRUE(alignments[0].aligned);
  EXPECT_LT(distance_px(alignments[0].placement, expected(hands, 0)), 0.1);
  EXPECT_LT(alignments[0].error_px, 0.1);
}

TEST(SlowAlignExposures, MergesHandHeldShotsAsIfTheyWereNot) {
  const auto errors = [](const std::vector<Placement>& hands, bool align) {
    Exposures bracket = hand_held(hands, sample::five_times(), 0);
    if (align) align_exposures(bracket);
    const Merge merge = merge_exposures(bracket, Response::srgb());
    const Image<Rgb> truth = scene_of(hands[2], is_whole(hands[0]));
    std::vector<double> stops;
    for (int y = 30; y < 210; ++y) {
      for (int x = 30; x < 290; ++x) stops.push_back(std::abs(std::log2(merge.radiance(x, y).g / truth(x, y).g)));
    }
    std::sort(stops.begin(), stops.end());
    return stops;
  };
  // Whole texels: nothing is filtered; five exposures three stops apart, 8 bits, no code darker than 20 in the best.
  const std::vector<double> whole = errors(kHands[1].placements, true);
  ASSERT_EQ(whole.size(), 180u * 260);
  EXPECT_LT(whole.back(), 0.1);
  // Turned: mixing neighbours rounds off the edges of the blocks, which are one texel in eight.
  const std::vector<double> turned = errors(kHands[6].placements, true), left = errors(kHands[6].placements, false);
  EXPECT_LT(turned[turned.size() / 2], 0.02);
  EXPECT_LT(turned[turned.size() * 9 / 10], 0.15);
  EXPECT_GT(left[left.size() / 2], 5 * turned[turned.size() / 2]);
}

TEST(AlignExposures, LeavesWhatItCannotSee) {
  // The first is black; it cannot be laid on any other.
  Exposures bracket = hand_held({{4, 2}, {}, {-3, 1}}, {1e-9, 0.5, 4}, 0);
  const std::vector<Alignment> alignments = align_exposures(bracket);
  EXPECT_FALSE(alignments[0].aligned);
  EXPECT_EQ(bracket[0].placement, Placement{});
  EXPECT_TRUE(alignments[2].aligned);
  EXPECT_EQ(bracket[2].placement, (Placement{3, -1}));
}

TEST(AlignExposures, GoesPastAnExposureThatShowsNothing) {
  const std::vector<Placement> hands = {{4.5, 2, 0.5}, {9, 9}, {}, {}};
  Exposures bracket = hand_held(hands, {0.25, 0.5, 1, 2}, 0);
  bracket[1].picture = CodedPicture(Image<Rgb>(kWidth, kHeight));
  const std::vector<Alignment> alignments = align_exposures(bracket);
  EXPECT_FALSE(alignments[1].aligned);
  EXPECT_TRUE(alignments[0].aligned);
  EXPECT_LT(distance_px(alignments[0].placement, expected(hands, 0)), 0.1);
}

TEST(AlignExposures, DoesNotLayOneSceneOnAnother) {
  Exposures bracket = hand_held({{}, {4000, 3000, 90}}, {0.5, 1}, 1);
  const std::vector<Alignment> alignments = align_exposures(bracket);
  EXPECT_FALSE(alignments[0].aligned) << alignments[0].correlation << ' ' << alignments[0].error_px;
  EXPECT_EQ(bracket[0].placement, Placement{});
}

TEST(AlignExposures, RepeatsItsBitsOnAnyThreads) {
  zonal::Run one, seven;
  one.threads = 1, seven.threads = 7;
  Exposures a = hand_held(kHands[6].placements, sample::five_times(), 1), b = a;
  align_exposures(a, {}, one);
  align_exposures(b, {}, seven);
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].placement, b[k].placement) << k;
}

TEST(AlignExposures, MissingTexelsDoNotCount) {
  const std::vector<Placement> hands = {{3.4, 1.2, 0.5}, {}};
  Exposures bracket = hand_held(hands, {0.5, 1}, 0);
  // A frame of one colour that stays where it is, as a scanner's would.
  for (Exposure& e : bracket) {
    Image<Rgb> framed(kWidth, kHeight, {0, 1, 1});
    std::vector<Rgb> row(kWidth);
    for (int y = 40; y < kHeight - 40; ++y) {
      e.picture.row(y, row);
      std::copy(row.begin() + 40, row.end() - 40, framed.row(y).begin() + 40);
    }
    e.picture = CodedPicture(framed);
    EXPECT_GT(mark_missing(e, {0, 1, 1}, 0), 30000);
  }
  const std::vector<Alignment> alignments = align_exposures(bracket);
  EXPECT_TRUE(alignments[0].aligned);
  EXPECT_LT(distance_px(alignments[0].placement, expected(hands, 0)), 0.15);
}

TEST(AlignExposures, TinyPicturesAreSafe) {
  for (const int side : {1, 2, 15, 33}) {
    Exposures bracket = sample::bracket(sample::scene(side, side), {sample::srgb_camera}, {0.25, 1});
    EXPECT_EQ(align_exposures(bracket).size(), 2u);
  }
}

}  // namespace
}  // namespace zonal
