#include "zonal/io/exr_channels.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfPartType.h>

#include <algorithm>

namespace zonal {
namespace {

bool is_flat(const Imf::Header& header) { return !header.hasType() || !Imf::isDeepData(header.type()); }

std::string part_name(const Imf::MultiPartInputFile& file, int part) {
  const Imf::Header& header = file.header(part);
  return header.hasName() ? "\"" + header.name() + "\"" : std::to_string(part + 1);
}

/// The beginnings of all channel names, each once and with its dot; the main layer, "", first.
std::vector<std::string> layers_of(const Imf::ChannelList& channels) {
  std::vector<std::string> layers = {""};
  for (auto it = channels.begin(); it != channels.end(); ++it) {
    const std::string name = it.name();
    const std::string layer = name.substr(0, name.rfind('.') + 1);  // npos + 1 == 0: no dot, the main layer
    if (std::find(layers.begin(), layers.end(), layer) == layers.end()) layers.push_back(layer);
  }
  return layers;
}

std::optional<ExrChoice> choose_in_layer(const Imf::ChannelList& channels, const std::string& layer) {
  const auto has = [&](const char* name) { return channels.findChannel(layer + name) != nullptr; };
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

}  // namespace

std::optional<ExrChoice> choose_exr_channels(const Imf::MultiPartInputFile& file) {
  for (int part = 0; part < file.parts(); ++part) {
    const Imf::Header& header = file.header(part);
    if (!is_flat(header)) continue;
    for (const std::string& layer : layers_of(header.channels())) {
      std::optional<ExrChoice> choice = choose_in_layer(header.channels(), layer);
      if (!choice) continue;
      // OpenEXR reconstructs luminance-chroma in the first part only.
      if (choice->kind == ExrChoice::kLuminanceChroma && part > 0) continue;
      choice->part = part;
      if (file.parts() > 1) {
        choice->notes.push_back("part " + part_name(file, part) + " of " + std::to_string(file.parts()) +
                                " parts is read");
      }
      if (!layer.empty()) {
        choice->notes.push_back("layer \"" + layer.substr(0, layer.size() - 1) +
                                "\" is read: the main layer has no colour");
      }
      return choice;
    }
  }
  return std::nullopt;
}

std::string describe_exr_channels(const Imf::MultiPartInputFile& file) {
  constexpr std::size_t kLongest = 300;
  std::string text;
  for (int part = 0; part < file.parts() && text.size() < kLongest; ++part) {
    text += (part > 0 ? "; part " : "part ") + part_name(file, part) + (is_flat(file.header(part)) ? ":" : " (deep):");
    const Imf::ChannelList& channels = file.header(part).channels();
    for (auto it = channels.begin(); it != channels.end(); ++it) text += std::string(" ") + it.name();
  }
  if (text.size() > kLongest) text = text.substr(0, kLongest) + " ...";
  return text;
}

}  // namespace zonal
