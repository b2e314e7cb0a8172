#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "zonal/sphere/projection.h"

namespace zonal {
namespace {

/// A picture's name without folders, in small letters.
std::string plain_name(std::string_view file_name) {
  const auto slash = file_name.find_last_of("/\\");
  std::string name(slash == std::string_view::npos ? file_name : file_name.substr(slash + 1));
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

/// Words that point to a layout. Unused places are empty.
struct Hint {
  Layout layout;
  std::array<std::string_view, 4> words;
};
constexpr std::array kHints = {
    Hint{Layout::kDualFisheye, {"dualfisheye", "dual_fisheye", "dual-fisheye", "dual fisheye"}},
    Hint{Layout::kDualParaboloid, {"paraboloid"}},
    Hint{Layout::kEquirect, {"equirect", "latlong", "lat_long", "lat-long"}},
    Hint{Layout::kFisheye, {"fisheye", "fish_eye", "fish-eye", "allsky"}},
};
/// Believed for squares only.
constexpr std::array kSquareHints = {
    Hint{Layout::kOctahedralEqualArea, {"equalarea", "equal_area", "equal-area"}},
    Hint{Layout::kOctahedral, {"octahedr", "octmap", "octa", "oct"}},
    Hint{Layout::kSphereMap, {"spheremap", "sphere_map", "sphere-map", "matcap"}},
    Hint{Layout::kMirrorBall, {"mirror", "chrome", "ball"}},
    Hint{Layout::kAngular, {"angular", "probe", "angmap"}},
    Hint{Layout::kFisheye, {"skymap", "sky"}},
};

/// Which of a hint's words stands in the name: long ones anywhere, short ones (up to four letters, which also occur
/// inside other words: a sky in "kaminsky", a ball in "ballroom") only with no letter beside them. Empty: none.
std::string_view word_in(std::string_view name, const Hint& hint) {
  const auto letter_at = [&](std::size_t i) {
    return i < name.size() && std::isalpha(static_cast<unsigned char>(name[i])) != 0;
  };
  for (const std::string_view word : hint.words) {
    if (word.empty()) continue;
    for (auto at = name.find(word); at != std::string_view::npos; at = name.find(word, at + 1)) {
      const bool alone = (at == 0 || !letter_at(at - 1)) && !letter_at(at + word.size());
      if (word.size() > 4 || alone) return word;
    }
  }
  return {};
}

/// The first layout with a word in the name and a shape that fits.
std::optional<Guess> by_name(ImageSize size, std::string_view name) {
  const auto first_of = [&](std::span<const Hint> hints) -> std::optional<Guess> {
    for (const Hint& hint : hints) {
      const std::string_view word = word_in(name, hint);
      if (word.empty() || !natural_size(hint.layout, size)) continue;
      Guess guess{{hint.layout}, "its name says \""};
      guess.reason.append(word).append("\"");
      return guess;
    }
    return std::nullopt;
  };
  if (const auto guess = first_of(kHints)) return guess;
  return size.width == size.height ? first_of(kSquareHints) : std::nullopt;
}

std::optional<Guess> by_shape(ImageSize size) {
  const auto fits = [&](Layout layout) { return natural_size(layout, size).has_value(); };
  if (fits(Layout::kEquirect)) {
    const bool exact = size.width == 2 * size.height;
    return Guess{{Layout::kEquirect},
                 std::string(exact ? "2:1" : "2:1 within 1 %") + ", and nothing in its name says otherwise"};
  }
  if (fits(Layout::kCubeRow)) return Guess{{Layout::kCubeRow}, "6:1, six faces in a row"};
  if (fits(Layout::kCubeStack)) return Guess{{Layout::kCubeStack}, "1:6, six faces in a stack"};
  if (fits(Layout::kCubeCross)) return Guess{{Layout::kCubeCross}, "4:3, the shape of a horizontal cross"};
  if (fits(Layout::kCubeCrossVertical)) {
    return Guess{{Layout::kCubeCrossVertical},
                 "3:4, the shape of a vertical cross (with its lowest face rotated, as usual)"};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Guess> guess_projection(ImageSize size, std::string_view file_name) {
  if (size.width < 1 || size.height < 1) return std::nullopt;
  if (const auto guess = by_name(size, plain_name(file_name))) return guess;
  return by_shape(size);
}

}  // namespace zonal
