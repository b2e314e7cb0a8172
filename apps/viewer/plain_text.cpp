#include "apps/viewer/plain_text.h"

#include <imgui.h>

#include <array>
#include <filesystem>
#include <utility>

namespace zonal {
namespace {

/// Where common systems keep a font with Greek letters and mathematical signs.
constexpr std::array kFonts = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf",
                               "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                               "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                               "/usr/share/fonts/truetype/freefont/FreeSans.ttf"};

/// Latin, Greek, combining marks, punctuation, super- and subscripts, arrows, mathematical operators.
constexpr ImWchar kRanges[] = {0x20,   0x17f,  0x2b0,  0x36f,  0x370,  0x3ff,  0x1d00, 0x1dbf,
                               0x2010, 0x209f, 0x2190, 0x21ff, 0x2200, 0x22ff, 0};

constexpr std::pair<std::string_view, std::string_view> kWritten[] = {
    {"π", "pi"},  {"ω", "w"},    {"α", "alpha"}, {"θ", "theta"}, {"φ", "phi"},  {"λ", "lambda"},
    {"Σ", "sum"}, {"∫", "int "}, {"²", "^2"},    {"³", "^3"},    {"½", "1/2 "}, {"√", "sqrt"},
    {"·", "."},   {"−", "-"},    {"–", "-"},     {"×", "x"},     {"⊥", "'"},    {"→", "->"},
    {"≥", ">="},  {"≤", "<="},   {"’", "'"},     {"°", " deg"},  {"∈", "in"}};

}  // namespace

void load_font(float scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  for (const char* path : kFonts) {
    std::error_code error;
    if (std::filesystem::exists(path, error) && atlas.AddFontFromFileTTF(path, 15 * scale, nullptr, kRanges)) return;
  }
  atlas.AddFontDefault();
  ImGui::GetIO().FontGlobalScale = scale;
}

std::string shown(std::string_view text) {
  std::string result;
  const ImFont& font = *ImGui::GetFont();
  while (!text.empty()) {
    // One character of UTF-8, whose first byte tells how many there are.
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    const std::string_view sign = text.substr(0, length);
    text.remove_prefix(sign.size());
    unsigned code = first & (length == 1 ? 0x7f : 0xff >> (length + 1));
    for (std::size_t i = 1; i < sign.size(); ++i) code = code << 6 | (static_cast<unsigned char>(sign[i]) & 0x3f);
    std::string_view written = sign;
    if (code >= 0x80 && font.FindGlyphNoFallback(static_cast<ImWchar>(code)) == nullptr) {
      written = "?";
      for (const auto& [from, to] : kWritten) {
        if (from == sign) written = to;
      }
    }
    result += written;
  }
  return result;
}

}  // namespace zonal
