#include "zonal/image/response_samples.h"

#include <algorithm>
#include <cmath>

#include "zonal/base/check.h"
#include "zonal/base/parallel.h"

namespace zonal {
namespace {

constexpr int kCandidatesPerSample = 12;
constexpr int kBrightnessSteps = 64;
constexpr int kLargestFall = 8;  // codes: noise and JPEG stay below, moving things do not

using Row = std::vector<Rgb>;

std::uint8_t code_of(float encoded) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(encoded, 0.0f, 1.0f)));
}

/// One texel's codes, [channel][exposure].
struct Candidate {
  float roughness = 0;  ///< largest difference in the neighbourhood, over exposures and channels
  int brightness = 0;   ///< sum of the green codes
  std::array<std::vector<std::uint8_t>, 3> codes;
};

/// Three rows around y of one exposure; beyond the edge the edge's own row.
struct Neighbourhood {
  std::array<Row, 3> rows;

  void read(const Exposure& exposure, int y) {
    const int height = exposure.picture.height();
    for (int i = 0; i < 3; ++i) {
      rows[i].resize(static_cast<std::size_t>(exposure.picture.width()));
      read_row(exposure, std::clamp(y + i - 1, 0, height - 1), rows[i]);
    }
  }
  /// NaN where a neighbour has no data.
  float roughness(int x) const {
    const int width = static_cast<int>(rows[0].size());
    Rgb lowest = rows[1][x], highest = lowest;
    for (const Row& row : rows) {
      for (int i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i) {
        const Rgb p = row[i];
        if (!(p.r >= 0)) return std::nanf("");
        lowest = {std::min(lowest.r, p.r), std::min(lowest.g, p.g), std::min(lowest.b, p.b)};
        highest = {std::max(highest.r, p.r), std::max(highest.g, p.g), std::max(highest.b, p.b)};
      }
    }
    return max_channel(highest - lowest);
  }
};

/// Adds texel x of the rows around it; false where it is of no use.
bool add_exposure(const Neighbourhood& near, int x, Candidate& candidate) {
  const float roughness = near.roughness(x);
  if (std::isnan(roughness)) return false;
  candidate.roughness = std::max(candidate.roughness, roughness);
  const Rgb p = near.rows[1][x];
  const std::array<std::uint8_t, 3> now = {code_of(p.r), code_of(p.g), code_of(p.b)};
  candidate.brightness += now[1];
  for (int c = 0; c < 3; ++c) {
    std::vector<std::uint8_t>& codes = candidate.codes[c];
    if (!codes.empty() && now[c] + kLargestFall < codes.back()) return false;
    codes.push_back(now[c]);
  }
  return true;
}

std::vector<Candidate> candidates_of_row(const Exposures& bracket, int y, int step) {
  const int width = bracket[0].picture.width();
  std::vector<Candidate> row(static_cast<std::size_t>((width - 1 - step / 2 + step) / step));
  std::vector<bool> good(row.size(), true);
  Neighbourhood near;
  for (const Exposure& exposure : bracket) {
    near.read(exposure, y);
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (good[i]) good[i] = add_exposure(near, step / 2 + static_cast<int>(i) * step, row[i]);
    }
  }
  std::vector<Candidate> kept;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (good[i]) kept.push_back(std::move(row[i]));
  }
  return kept;
}

std::vector<Candidate> find_candidates(const Exposures& bracket, int count, const Run& run) {
  const double texels = static_cast<double>(bracket[0].picture.width()) * bracket[0].picture.height();
  const int step = std::max(1, static_cast<int>(std::sqrt(texels / count)));
  const int rows = (bracket[0].picture.height() - 1 - step / 2 + step) / step;
  return reduce_blocks(
      run, "sampling", rows, 1, std::vector<Candidate>{},
      [&](Block block) { return candidates_of_row(bracket, step / 2 + block.begin * step, step); },
      [](std::vector<Candidate>& all, const std::vector<Candidate>& row) {
        all.insert(all.end(), row.begin(), row.end());
      });
}

/// The flattest `count`, spread over the brightnesses: each step of brightness gives the same number as long as it has
/// any.
std::vector<const Candidate*> choose(const std::vector<Candidate>& all, int count, int exposures) {
  std::array<std::vector<const Candidate*>, kBrightnessSteps> steps;
  for (const Candidate& c : all) steps[c.brightness * kBrightnessSteps / (255 * exposures + 1)].push_back(&c);
  for (auto& step : steps) {
    std::stable_sort(step.begin(), step.end(),
                     [](const Candidate* a, const Candidate* b) { return a->roughness < b->roughness; });
  }
  std::vector<const Candidate*> chosen;
  for (std::size_t rank = 0; static_cast<int>(chosen.size()) < count; ++rank) {
    const std::size_t before = chosen.size();
    for (const auto& step : steps) {
      if (rank < step.size()) chosen.push_back(step[rank]);
    }
    if (chosen.size() == before) break;
  }
  return chosen;
}

CodeSamples empty_samples(const Exposures& bracket) {
  CodeSamples samples;
  for (const Exposure& exposure : bracket) samples.seconds.push_back(exposure.seconds);
  return samples;
}

}  // namespace

CodeSamples sample_flat_texels(const Exposures& bracket, int count, const Run& run) {
  check(bracket.size() >= 2 && count > 0, "sampling needs an arranged bracket and a positive count");
  const std::vector<Candidate> all = find_candidates(bracket, count * kCandidatesPerSample, run);
  CodeSamples samples = empty_samples(bracket);
  for (const Candidate* chosen : choose(all, count, samples.exposures())) {
    for (int c = 0; c < 3; ++c)
      samples.codes[c].insert(samples.codes[c].end(), chosen->codes[c].begin(), chosen->codes[c].end());
  }
  return samples;
}

CodeSamples sample_all_texels(const Exposures& bracket, int at_most, const Run& run) {
  check(bracket.size() >= 2 && at_most >= 0, "sampling needs an arranged bracket and a limit");
  const int width = bracket[0].picture.width(), height = bracket[0].picture.height();
  const auto on_grid = [&](int n) { return static_cast<std::int64_t>((width + n - 1) / n) * ((height + n - 1) / n); };
  int step = 1;
  while (at_most > 0 && on_grid(step) > at_most) ++step;

  CodeSamples samples = empty_samples(bracket);
  const int exposures = samples.exposures();
  const auto work = [&](Block block) {
    std::array<std::vector<std::uint8_t>, 3> codes;
    std::vector<Row> rows(bracket.size(), Row(static_cast<std::size_t>(width)));
    for (int k = 0; k < exposures; ++k) read_row(bracket[k], block.begin * step, rows[k]);
    for (int x = 0; x < width; x += step) {
      if (std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return std::isnan(row[x].r); })) continue;
      for (const Row& row : rows) {
        codes[0].push_back(code_of(row[x].r));
        codes[1].push_back(code_of(row[x].g));
        codes[2].push_back(code_of(row[x].b));
      }
    }
    return codes;
  };
  samples.codes = reduce_blocks(run, "sampling", (height + step - 1) / step, 1, samples.codes, work,
                                [](auto& all, const auto& row) {
                                  for (int c = 0; c < 3; ++c) all[c].insert(all[c].end(), row[c].begin(), row[c].end());
                                });
  return samples;
}

}  // namespace zonal
