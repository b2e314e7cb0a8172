#include "zonal/image/align_exposures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "zonal/image/merge_exposures.h"
#include "zonal/image/synthetic_bracket_test.h"

namespace zonal {
namespace {

/// A hand-held bracket: every shot looks elsewhere.
Exposures hand_held(const std::vector<Shift>& shifts, const std::vector<double>& seconds, double noise) {
  Exposures bracket;
  for (std::size_t k = 0; k < shifts.size(); ++k) {
    const Image<Rgb> seen = sample::scene(320, 240, shifts[k]);
    bracket.push_back(
        {"", seconds[k], CodedPicture(sample::photograph(seen, {sample::srgb_camera, noise}, seconds[k]))});
  }
  arrange(bracket);
  return bracket;
}

/// What was seen at (x, y) of the middle shot is at (x, y) + middle - shift in another.
Shift expected(const std::vector<Shift>& shifts, std::size_t k) {
  const Shift middle = shifts[shifts.size() / 2];
  return {middle.dx - shifts[k].dx, middle.dy - shifts[k].dy};
}

TEST(AlignExposures, FindsShiftsExactly) {
  const std::vector<std::vector<Shift>> hands = {{{0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
                                                 {{1, 0}, {0, 1}, {0, 0}, {-1, -1}, {2, -1}},
                                                 {{7, -3}, {12, 5}, {0, 0}, {-9, 14}, {-20, -6}},
                                                 {{-31, 22}, {-3, 40}, {5, 5}, {30, -17}, {55, -33}}};
  int found = 0;
  for (const std::vector<Shift>& shifts : hands) {
    for (const double noise : {0.0, 2.0}) {
      Exposures bracket = hand_held(shifts, sample::five_times(), noise);
      const std::vector<Alignment> alignments = align_exposures(bracket);
      ASSERT_EQ(alignments.size(), shifts.size());
      for (std::size_t k = 0; k < shifts.size(); ++k, ++found) {
        EXPECT_EQ(bracket[k].shift, expected(shifts, k)) << k << " of hand " << shifts[0].dx;
        EXPECT_EQ(alignments[k].shift, bracket[k].shift);
        EXPECT_FALSE(alignments[k].too_flat);
        EXPECT_LT(alignments[k].disagreement, 0.02);
      }
    }
  }
  EXPECT_EQ(found, 4 * 2 * 5);
}

TEST(AlignExposures, MergesHandHeldShotsAsIfTheyWereNot) {
  const std::vector<Shift> shifts = {{7, -3}, {12, 5}, {0, 0}, {-9, 14}, {-20, -6}};
  Exposures bracket = hand_held(shifts, sample::five_times(), 0);
  align_exposures(bracket);
  const Merge merge = merge_exposures(bracket, Response::srgb());
  const Image<Rgb> truth = sample::scene(320, 240);
  int compared = 0;
  for (int y = 30; y < 210; ++y) {
    for (int x = 30; x < 290; ++x, ++compared) {
      // Five exposures three stops apart, 8 bits: no code is darker than 20 in the best of them.
      EXPECT_NEAR(std::log2(merge.radiance(x, y).g / truth(x, y).g), 0, 0.1);
    }
  }
  EXPECT_EQ(compared, 180 * 260);
}

TEST(AlignExposures, LeavesWhatItCannotSee) {
  Exposures bracket = hand_held({{4, 2}, {0, 0}, {-3, 1}}, {1e-9, 0.5, 4}, 0);  // the first is black
  const std::vector<Alignment> alignments = align_exposures(bracket);
  EXPECT_TRUE(alignments[0].too_flat);
  EXPECT_EQ(bracket[0].shift, (Shift{0, 0}));
  EXPECT_FALSE(alignments[2].too_flat);
  EXPECT_EQ(bracket[2].shift, (Shift{3, -1}));
}

TEST(AlignExposures, TinyPicturesAreSafe) {
  for (const int side : {1, 2, 15, 33}) {
    Exposures bracket = sample::bracket(sample::scene(side, side), {sample::srgb_camera}, {0.25, 1});
    EXPECT_EQ(align_exposures(bracket).size(), 2u);
  }
}

}  // namespace
}  // namespace zonal
