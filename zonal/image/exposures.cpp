#include "zonal/image/exposures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "zonal/base/check.h"
#include "zonal/base/error.h"

namespace zonal {
namespace {

constexpr Rgb kNone = {kNoCode, kNoCode, kNoCode};

/// The values as integers of 0..largest, if that keeps each bit of them.
template <class Code>
std::optional<std::vector<Code>> as_codes(std::span<const Rgb> pixels) {
  constexpr float kLargest = std::numeric_limits<Code>::max();
  std::vector<Code> codes;
  codes.reserve(3 * pixels.size());
  for (const Rgb& p : pixels) {
    for (const float value : {p.r, p.g, p.b}) {
      if (!(value >= 0 && value <= 1)) return std::nullopt;
      const Code code = static_cast<Code>(value * kLargest + 0.5f);
      if (static_cast<float>(code) / kLargest != value) return std::nullopt;
      codes.push_back(code);
    }
  }
  return codes;
}

std::vector<float> as_floats(std::span<const Rgb> pixels) {
  std::vector<float> values;
  values.reserve(3 * pixels.size());
  for (const Rgb& p : pixels) values.insert(values.end(), {p.r, p.g, p.b});
  return values;
}

void check_finite(std::span<const Rgb> pixels) {
  const auto bad = std::count_if(pixels.begin(), pixels.end(), [](const Rgb& p) {
    return !std::isfinite(p.r) || !std::isfinite(p.g) || !std::isfinite(p.b);
  });
  if (bad == 0) return;
  throw Error(ErrorKind::kInput, std::to_string(bad) + " pixels are not finite (NaN or infinite)",
              "develop or export the photograph again");
}

std::string size_of(const CodedPicture& p) { return std::to_string(p.width()) + "x" + std::to_string(p.height()); }

void check_pair(const Exposure& a, const Exposure& b) {
  if (a.picture.width() != b.picture.width() || a.picture.height() != b.picture.height()) {
    throw Error(ErrorKind::kInput, a.name + " is " + size_of(a.picture) + ", " + b.name + " is " + size_of(b.picture),
                "a bracket is of one size: export all photographs alike");
  }
  if (std::abs(a.seconds - b.seconds) <= 0.01 * std::max(a.seconds, b.seconds)) {
    throw Error(ErrorKind::kInput, a.name + " and " + b.name + " have the same exposure",
                "leave one of them out, or say with --times what they really had");
  }
}

}  // namespace

CodedPicture::CodedPicture(const Image<Rgb>& encoded) : width_(encoded.width()), height_(encoded.height()) {
  check_finite(encoded.values());
  if (auto bytes = as_codes<std::uint8_t>(encoded.values())) {
    samples_ = std::move(*bytes);
  } else if (auto words = as_codes<std::uint16_t>(encoded.values())) {
    samples_ = std::move(*words);
  } else {
    samples_ = as_floats(encoded.values());
  }
}

int CodedPicture::levels() const {
  constexpr int kLevels[] = {256, 65536, 0};
  return kLevels[samples_.index()];
}

namespace {

/// Three samples as 0..1.
template <class T>
Rgb encoded_of(const T* samples) {
  constexpr float kLargest = std::is_floating_point_v<T> ? 1.0f : static_cast<float>(std::numeric_limits<T>::max());
  return {static_cast<float>(samples[0]) / kLargest, static_cast<float>(samples[1]) / kLargest,
          static_cast<float>(samples[2]) / kLargest};
}

}  // namespace

void CodedPicture::row(int y, std::span<Rgb> into) const {
  check(y >= 0 && y < height_ && into.size() == static_cast<std::size_t>(width_), "a row must be in the picture");
  std::visit(
      [&](const auto& samples) {
        const auto* at = samples.data() + std::size_t{3} * static_cast<std::size_t>(y) * into.size();
        for (Rgb& p : into) p = encoded_of(at), at += 3;
      },
      samples_);
}

void CodedPicture::pick(std::span<const std::size_t> texels, std::span<Rgb> into) const {
  check(texels.size() == into.size(), "every texel needs its place");
  std::visit(
      [&](const auto& samples) {
        std::transform(texels.begin(), texels.end(), into.begin(),
                       [&](std::size_t texel) { return encoded_of(samples.data() + 3 * texel); });
      },
      samples_);
}

void arrange(Exposures& bracket) {
  for (const Exposure& e : bracket) {
    if (e.seconds > 0 && std::isfinite(e.seconds)) continue;
    throw Error(ErrorKind::kInput, e.name + ": an exposure of " + std::to_string(e.seconds) + " s is impossible",
                "exposure times are positive seconds: --times 1/1000,1/250,1/60");
  }
  if (bracket.size() < 2) {
    throw Error(ErrorKind::kInput, "one exposure makes no bracket",
                "give two photographs or more; zonal convert reads a single one");
  }
  std::stable_sort(bracket.begin(), bracket.end(),
                   [](const Exposure& a, const Exposure& b) { return a.seconds < b.seconds; });
  for (std::size_t i = 1; i < bracket.size(); ++i) check_pair(bracket[i - 1], bracket[i]);
}

namespace {

/// The row of a photograph that was moved by whole texels.
void read_moved_row(const Exposure& exposure, Shift shift, int y, std::span<Rgb> into) {
  const CodedPicture& picture = exposure.picture;
  const auto [dx, dy] = shift;
  const int width = picture.width(), from_y = y + dy;
  const int begin = std::clamp(-dx, 0, width), end = std::clamp(width - dx, 0, width);
  if (from_y < 0 || from_y >= picture.height() || begin >= end) {
    std::fill(into.begin(), into.end(), kNone);
    return;
  }
  picture.row(from_y, into);
  if (!exposure.missing.empty()) {
    const auto missing = exposure.missing.row(from_y);
    for (std::size_t x = 0; x < into.size(); ++x) {
      if (missing[x] != 0) into[x] = kNone;
    }
  }
  if (dx > 0) std::move(into.begin() + dx, into.end(), into.begin());
  if (dx < 0) std::move_backward(into.begin(), into.end() + dx, into.end());
  std::fill(into.begin(), into.begin() + begin, kNone);
  std::fill(into.begin() + end, into.end(), kNone);
}

/// The row of a photograph that was moved by parts of texels, or turned.
void read_placed_row(const Exposure& exposure, int y, std::span<Rgb> into) {
  const CodedPicture& picture = exposure.picture;
  const Placing placing(exposure.placement, picture.center());
  std::vector<std::size_t> texels(into.size());
  std::vector<bool> shown(into.size());
  for (std::size_t x = 0; x < into.size(); ++x) {
    const PicturePoint q = placing({static_cast<double>(x) + 0.5, y + 0.5});
    if (!(q.x >= 0 && q.y >= 0 && q.x < picture.width() && q.y < picture.height())) continue;
    texels[x] = static_cast<std::size_t>(q.y) * into.size() + static_cast<std::size_t>(q.x);
    shown[x] = exposure.missing.empty() || exposure.missing.values()[texels[x]] == 0;
  }
  picture.pick(texels, into);
  for (std::size_t x = 0; x < into.size(); ++x) {
    if (!shown[x]) into[x] = kNone;
  }
}

}  // namespace

void read_row(const Exposure& exposure, int y, std::span<Rgb> into) {
  if (const std::optional<Shift> shift = whole_shift(exposure)) {
    read_moved_row(exposure, *shift, y, into);
  } else {
    read_placed_row(exposure, y, into);
  }
}

std::optional<Shift> whole_shift(const Exposure& exposure) {
  const Placement& p = exposure.placement;
  // Beyond this nothing of the photograph is left, and the move must fit an int.
  constexpr double kFarthest = 1 << 30;
  if (!is_whole(p) || std::abs(p.dx) > kFarthest || std::abs(p.dy) > kFarthest) return std::nullopt;
  return Shift{static_cast<int>(p.dx), static_cast<int>(p.dy)};
}

std::int64_t mark_missing(Exposure& exposure, Rgb color, float tolerance) {
  const int width = exposure.picture.width(), height = exposure.picture.height();
  if (exposure.missing.empty()) exposure.missing = Image<std::uint8_t>(width, height);
  std::vector<Rgb> row(static_cast<std::size_t>(width));
  const auto near = [&](float a, float b) { return std::abs(a - b) <= tolerance; };
  std::int64_t count = 0;
  for (int y = 0; y < height; ++y) {
    exposure.picture.row(y, row);
    const auto missing = exposure.missing.row(y);
    for (std::size_t x = 0; x < row.size(); ++x) {
      if (!near(row[x].r, color.r) || !near(row[x].g, color.g) || !near(row[x].b, color.b)) continue;
      missing[x] = 1;
      ++count;
    }
  }
  return count;
}

}  // namespace zonal
