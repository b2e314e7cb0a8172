#include "zonal/report/pixel_text.h"

#include <array>

namespace zonal {
namespace {

constexpr int kWidth = 3;

/// Rows from the top, three bits each, the left dot in the highest.
using Glyph = std::array<unsigned, kPixelTextDots>;

constexpr std::array<Glyph, 10> kFigures = {{{7, 5, 5, 5, 7},
                                             {2, 6, 2, 2, 7},
                                             {7, 1, 7, 4, 7},
                                             {7, 1, 3, 1, 7},
                                             {5, 5, 7, 1, 1},
                                             {7, 4, 7, 1, 7},
                                             {7, 4, 7, 5, 7},
                                             {7, 1, 1, 2, 2},
                                             {7, 5, 7, 5, 7},
                                             {7, 5, 7, 1, 7}}};
constexpr std::array<Glyph, 26> kCapitals = {
    {{2, 5, 7, 5, 5}, {6, 5, 6, 5, 6}, {3, 4, 4, 4, 3}, {6, 5, 5, 5, 6}, {7, 4, 6, 4, 7}, {7, 4, 6, 4, 4},
     {3, 4, 5, 5, 3}, {5, 5, 7, 5, 5}, {7, 2, 2, 2, 7}, {1, 1, 1, 5, 2}, {5, 5, 6, 5, 5}, {4, 4, 4, 4, 7},
     {5, 7, 7, 5, 5}, {6, 5, 5, 5, 5}, {2, 5, 5, 5, 2}, {6, 5, 6, 4, 4}, {2, 5, 5, 6, 3}, {6, 5, 6, 5, 5},
     {3, 4, 2, 1, 6}, {7, 2, 2, 2, 2}, {5, 5, 5, 5, 7}, {5, 5, 5, 5, 2}, {5, 5, 7, 7, 5}, {5, 5, 2, 5, 5},
     {5, 5, 2, 2, 2}, {7, 1, 2, 4, 7}}};

Glyph glyph_of(char letter) {
  if (letter >= '0' && letter <= '9') return kFigures[static_cast<std::size_t>(letter - '0')];
  if (letter >= 'A' && letter <= 'Z') return kCapitals[static_cast<std::size_t>(letter - 'A')];
  if (letter >= 'a' && letter <= 'z') return kCapitals[static_cast<std::size_t>(letter - 'a')];
  if (letter == '/') return {1, 1, 2, 4, 4};
  if (letter == '.') return {0, 0, 0, 0, 2};
  if (letter == '%') return {5, 1, 2, 4, 5};
  if (letter == '-') return {0, 0, 7, 0, 0};
  return {};
}

}  // namespace

int pixel_text_width(std::string_view word, int dot) {
  return word.empty() ? 0 : dot * ((kWidth + 1) * static_cast<int>(word.size()) - 1);
}

void draw_pixel_text(Image<Rgb8>& picture, int x, int y, std::string_view word, int dot, Rgb8 ink) {
  for (const char letter : word) {
    const Glyph glyph = glyph_of(letter);
    for (int v = 0; v < kPixelTextDots * dot; ++v) {
      for (int u = 0; u < kWidth * dot; ++u) {
        const bool on = glyph[static_cast<std::size_t>(v / dot)] >> (kWidth - 1 - u / dot) & 1;
        const bool inside = x + u >= 0 && x + u < picture.width() && y + v >= 0 && y + v < picture.height();
        if (on && inside) picture(x + u, y + v) = ink;
      }
    }
    x += (kWidth + 1) * dot;
  }
}

}  // namespace zonal
