#include "zonal/image/align_exposures.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "zonal/base/check.h"
#include "zonal/base/parallel.h"
#include "zonal/image/align_bitmaps.h"
#include "zonal/image/align_refine.h"
#include "zonal/image/code_transfer.h"

namespace zonal {
namespace {

constexpr float kLeastRange = 8;  // codes in which both see the light
constexpr double kLeastCorrelation = 0.8, kLargestError_px = 0.5, kLargestRotation_deg = 10;
constexpr double kWholeTexel_px = 0.05;

/// A pair of exposures: `moving` as laid on `toward`, its neighbour on the way to the middle one.
struct Pair {
  Alignment alignment;
  int toward = 0;
};

/// Two photographs whose codes are made alike: pyramids of both, with a number of halves.
class AlikePair {
 public:
  AlikePair(const Exposure& fixed, const Exposure& moving)
      : fixed_(fixed), moving_(moving), a_(grey_of(fixed.picture)), b_(grey_of(moving.picture)) {}

  const Grey& fixed() const { return a_; }
  const Grey& moving() const { return b_; }

  /// By the part that both show when one is moved by whole texels.
  bool make_alike(Shift shift) {
    const Part part = shared_part(a_, b_, shift);
    return make_alike(histogram_of(a_, part), histogram_of(b_, moved(part, shift)));
  }

  /// By what shows the same in both: neither what moved by itself nor what only one shows.
  bool make_alike(const Refined& found) {
    const Image<std::uint8_t> agree = agreeing_texels(levels_of_fixed_[0], levels_of_moving_[0], found);
    const Placing placing(found.placement, fixed_.picture.center());
    GreyHistogram ha = {}, hb = {};
    for (int y = 0; y < a_.height(); ++y) {
      for (int x = 0; x < a_.width(); ++x) {
        if (agree(x, y) == 0) continue;
        const PicturePoint q = placing({x + 0.5, y + 0.5});
        ++ha[a_(x, y)];
        ++hb[b_(static_cast<int>(q.x), static_cast<int>(q.y))];
      }
    }
    return make_alike(ha, hb);
  }

  const std::vector<Image<float>>& levels_of_fixed() const { return levels_of_fixed_; }
  const std::vector<Image<float>>& levels_of_moving() const { return levels_of_moving_; }

 private:
  bool make_alike(const GreyHistogram& ha, const GreyHistogram& hb) {
    const bool longer = fixed_.seconds > moving_.seconds;
    const CodeTransfer transfer = longer ? transfer_codes(hb, ha) : transfer_codes(ha, hb);
    if (transfer.range < kLeastRange) return false;
    const int times = halvings(a_.width(), a_.height(), kCoarsestSide);
    levels_of_fixed_ = align_pyramid(a_, fixed_.missing, longer ? transfer.longer : transfer.shorter, times);
    levels_of_moving_ = align_pyramid(b_, moving_.missing, longer ? transfer.shorter : transfer.longer, times);
    return true;
  }

  const Exposure& fixed_;
  const Exposure& moving_;
  Grey a_, b_;
  std::vector<Image<float>> levels_of_fixed_, levels_of_moving_;
};

/// A placement that can be relied upon; nullopt: there is none.
std::optional<Refined> place(AlikePair& pair, int largest_shift_px) {
  const std::optional<Shift> start = align_bitmaps(pair.fixed(), pair.moving(), largest_shift_px);
  if (!start || !pair.make_alike(*start)) return std::nullopt;
  const auto good = [&](const Refined& r) {
    // The coarse search goes to the largest shift; steps from there correct it, they do not wander.
    return r.correlation >= kLeastCorrelation && r.error_px < kLargestError_px &&
           std::abs(r.placement.rotation_deg) <= kLargestRotation_deg &&
           std::hypot(r.placement.dx, r.placement.dy) <= 2.0 * largest_shift_px + 1;
  };
  Refined found = refine_placement(pair.levels_of_fixed(), pair.levels_of_moving(),
                                   {static_cast<double>(start->dx), static_cast<double>(start->dy), 0});
  if (!good(found) || !pair.make_alike(found)) return std::nullopt;
  found = polish_placement(pair.levels_of_fixed(), pair.levels_of_moving(), found.placement);
  return good(found) ? std::optional(found) : std::nullopt;
}

Alignment align_pair(const Exposure& fixed, const Exposure& moving, int largest_shift_px) {
  AlikePair pair(fixed, moving);
  const std::optional<Refined> found = place(pair, largest_shift_px);
  if (!found) return {{}, 0, 0, 0, false};
  return {found->placement, found->residual_codes, found->correlation, found->error_px, true};
}

/// Exposure k as laid on the nearest one toward the middle that it can be laid on; on its neighbour where there is
/// none.
Pair align_toward(const Exposures& bracket, int k, int middle, int largest_shift_px) {
  const int step = k < middle ? 1 : -1;
  std::optional<Pair> first;
  for (int toward = k + step; toward != middle + step; toward += step) {
    const Pair pair{align_pair(bracket[toward], bracket[k], largest_shift_px), toward};
    if (pair.alignment.aligned) return pair;
    if (!first) first = pair;
  }
  return *first;
}

}  // namespace

std::vector<Alignment> align_exposures(Exposures& bracket, const AlignOptions& options, const Run& run) {
  check(bracket.size() >= 2, "an alignment takes an arranged bracket");
  check(options.largest_shift_px >= 0, "the largest shift must not be negative");
  const int count = static_cast<int>(bracket.size()), middle = count / 2;
  const int width = bracket[0].picture.width(), height = bracket[0].picture.height();
  const int side = std::min(width, height);
  const int largest = std::min(options.largest_shift_px > 0 ? options.largest_shift_px : side / 8, side / 2);
  std::vector<Pair> pairs(static_cast<std::size_t>(count));
  for_each_block(run, "aligning", count, 1, [&](Block block) {
    if (block.begin != middle) pairs[block.begin] = align_toward(bracket, block.begin, middle, largest);
  });

  std::vector<Alignment> alignments(static_cast<std::size_t>(count));
  const auto chain = [&](int k) {
    alignments[k] = pairs[k].alignment;
    alignments[k].placement = composed(pairs[k].alignment.placement, alignments[pairs[k].toward].placement);
  };
  for (int k = middle + 1; k < count; ++k) chain(k);
  for (int k = middle - 1; k >= 0; --k) chain(k);
  for (int k = 0; k < count; ++k) {
    alignments[k].placement = settled(alignments[k].placement, width, height, kWholeTexel_px);
    bracket[k].placement = alignments[k].placement;
  }
  return alignments;
}

}  // namespace zonal
