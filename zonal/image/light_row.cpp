#include "zonal/image/light_row.h"

#include <algorithm>
#include <cmath>

namespace zonal {
namespace {

LightTexel light_of(const CodeTable& table, Rgb encoded) {
  return {table(0, encoded.r), table(1, encoded.g), table(2, encoded.b)};
}

/// Four texels around a point and how much of each is taken; those of which nothing is do not matter.
struct Taps {
  std::array<std::size_t, 4> texel = {};
  std::array<float, 4> share = {};
  bool outside = false;
};

Taps taps_at(PicturePoint q, int width, int height) {
  const double x = q.x - 0.5, y = q.y - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  const auto right_share = static_cast<float>(x - left), lower_share = static_cast<float>(y - top);
  Taps taps;
  for (int i = 0; i < 4; ++i) {
    const bool right = (i & 1) != 0, lower = (i & 2) != 0;
    taps.share[i] = (right ? right_share : 1 - right_share) * (lower ? lower_share : 1 - lower_share);
    const double u = left + right, v = top + lower;
    const bool inside = u >= 0 && v >= 0 && u < width && v < height;
    if (inside)
      taps.texel[i] = static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
    taps.outside = taps.outside || (!inside && taps.share[i] > 0);
  }
  return taps;
}

/// Adds a share of what one code says.
void mix(const CodeValue& value, float share, CodeValue& sum) {
  sum.exposure += share * value.exposure;
  sum.slope += share * value.exposure * value.slope;
  sum.weight = std::min(sum.weight, value.weight);
  sum.state = std::max(sum.state, value.state);  // in the order in which one spoils the others
}

void finish(CodeValue& sum) {
  if (sum.exposure <= 0) return;
  sum.slope /= sum.exposure;
  sum.log_exposure = std::log(sum.exposure);
}

void read_mixed(const Exposure& exposure, const CodeTable& table, int y, std::span<LightTexel> into) {
  const CodedPicture& picture = exposure.picture;
  const Placing placing(exposure.placement, picture.center());
  std::vector<Taps> taps;
  std::vector<std::size_t> texels;
  for (std::size_t x = 0; x < into.size(); ++x) {
    taps.push_back(taps_at(placing({static_cast<double>(x) + 0.5, y + 0.5}), picture.width(), picture.height()));
    texels.insert(texels.end(), taps.back().texel.begin(), taps.back().texel.end());
  }
  std::vector<Rgb> codes(texels.size());
  picture.pick(texels, codes);
  for (std::size_t x = 0; x < into.size(); ++x) {
    into[x] = {};
    if (taps[x].outside) continue;
    for (CodeValue& sum : into[x]) sum = {0, 0, 0, 1, CodeState::kTrusted};
    for (std::size_t i = 0; i < 4; ++i) {
      if (taps[x].share[i] == 0) continue;
      const bool missing = !exposure.missing.empty() && exposure.missing.values()[taps[x].texel[i]] != 0;
      const LightTexel light = missing ? LightTexel{} : light_of(table, codes[4 * x + i]);
      for (int c = 0; c < 3; ++c) mix(light[c], taps[x].share[i], into[x][c]);
    }
    for (CodeValue& sum : into[x]) finish(sum);
  }
}

}  // namespace

void read_light(const Exposure& exposure, const CodeTable& table, int y, std::span<LightTexel> into) {
  if (!whole_shift(exposure)) {
    read_mixed(exposure, table, y, into);
    return;
  }
  std::vector<Rgb> codes(into.size());
  read_row(exposure, y, codes);
  std::transform(codes.begin(), codes.end(), into.begin(), [&](Rgb encoded) { return light_of(table, encoded); });
}

}  // namespace zonal
