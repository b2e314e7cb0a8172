#include "zonal/io/exr_channels.h"

#include <algorithm>
#include <cmath>

namespace zonal {
namespace {

std::string part_name(std::span<const ExrPart> parts, std::size_t i) {
  return parts[i].name.empty() ? std::to_string(i + 1) : "\"" + parts[i].name + "\"";
}

/// The beginnings of all channel names, each once and with its dot; the main layer, "", first.
std::vector<std::string> layers_of(const ExrPart& part) {
  std::vector<std::string> layers = {""};
  for (const std::string& name : part.channels) {
    const std::string layer = name.substr(0, name.rfind('.') + 1);  // npos + 1 == 0: no dot, the main layer
    if (std::ranges::find(layers, layer) == layers.end()) layers.push_back(layer);
  }
  return layers;
}

std::optional<ExrChoice> choose_in_layer(const ExrPart& part, const std::string& layer) {
  const auto has = [&](const char* name) {
    return std::ranges::find(part.channels, layer + name) != part.channels.end();
  };
  ExrChoice choice;
  choice.layer = layer;
  choice.alpha = has("A");
  if (has("R") && has("G") && has("B")) {
    choice.channels = {layer + "R", layer + "G", layer + "B"};
  } else if (has("Y") && has("RY") && has("BY")) {
    choice.kind = ExrChoice::kLuminanceChroma;
    choice.channels = {layer + "Y"};
  } else if (has("Y")) {
    choice.kind = ExrChoice::kLuminance;
    choice.channels = {layer + "Y"};
  } else {
    return std::nullopt;
  }
  return choice;
}

std::string words_of(const ExrWindow& window) {
  return std::to_string(window.right - window.left + 1) + "x" + std::to_string(window.bottom - window.top + 1) +
         " at (" + std::to_string(window.left) + ", " + std::to_string(window.top) + ")";
}

bool is_rec709(const std::array<float, 8>& c) {
  constexpr std::array<float, 8> kRec709 = {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
  for (std::size_t i = 0; i < c.size(); i += 2) {
    if (!(std::hypot(c[i] - kRec709[i], c[i + 1] - kRec709[i + 1]) < 0.002f)) return false;  // the figures' own digits
  }
  return true;
}

void note_header(const ExrPart& part, std::vector<std::string>& notes) {
  if (part.data != part.display) {
    notes.push_back("the data window, " + words_of(part.data) + ", is read; the display window is " +
                    words_of(part.display));
  }
  if (part.chromaticities && !is_rec709(*part.chromaticities)) {
    notes.emplace_back("the file's primaries are not Rec. 709 and are not converted");
  }
  if (part.envmap) {
    notes.emplace_back(*part.envmap == 0 ? "the file says that it is a latitude-longitude map"
                                         : "the file says that it is an OpenEXR cube map");
  }
}

/// Parts and channels in words.
std::string words_of(std::span<const ExrPart> parts) {
  constexpr std::size_t kLongest = 300;
  std::string text;
  for (std::size_t i = 0; i < parts.size() && text.size() < kLongest; ++i) {
    text += (i > 0 ? "; part " : "part ") + part_name(parts, i) + (parts[i].is_deep ? " (deep):" : ":");
    for (const std::string& name : parts[i].channels) text += " " + name;
  }
  if (text.size() > kLongest) text = text.substr(0, kLongest) + " ...";
  return text;
}

}  // namespace

ExrChoice choose_exr_channels(const ByteReader& reader, std::span<const ExrPart> parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].is_deep) continue;
    for (const std::string& layer : layers_of(parts[i])) {
      std::optional<ExrChoice> choice = choose_in_layer(parts[i], layer);
      if (!choice) continue;
      // OpenEXR reconstructs luminance-chroma in the first part only.
      if (choice->kind == ExrChoice::kLuminanceChroma && i > 0) continue;
      choice->part = static_cast<int>(i);
      if (parts.size() > 1) {
        choice->notes.push_back("part " + part_name(parts, i) + " of " + std::to_string(parts.size()) +
                                " parts is read");
      }
      if (!layer.empty()) {
        choice->notes.push_back("layer \"" + layer.substr(0, layer.size() - 1) +
                                "\" is read: the main layer has no colour");
      }
      note_header(parts[i], choice->notes);
      return *std::move(choice);
    }
  }
  reader.fail("this OpenEXR has no flat R, G, B or Y channels: " + words_of(parts), "export a colour layer");
}

Picture exr_picture(const ExrChoice& choice, int width, int height) {
  Picture picture;
  picture.pixels = Image<Rgb>(width, height);
  picture.format = "OpenEXR";
  picture.alpha = choice.alpha;
  picture.channels = (choice.kind == ExrChoice::kLuminance ? 1 : 3) + (choice.alpha ? 1 : 0);
  picture.notes = choice.notes;
  return picture;
}

}  // namespace zonal
