#pragma once

#include <OpenEXR/ImfMultiPartInputFile.h>

#include <optional>
#include <string>
#include <vector>

namespace zonal {

/// Where the colour of an OpenEXR file is.
struct ExrChoice {
  int part = 0;
  enum Kind { kRgb, kLuminance, kLuminanceChroma } kind = kRgb;
  std::string layer;                  ///< with its dot; empty for the main layer
  std::vector<std::string> channels;  ///< R, G, B or Y, with their layer
  bool alpha = false;
  std::vector<std::string> notes;
};

/// The first flat part with R, G, B or Y, in its main layer or else in its first layer that has them. nullopt: none.
std::optional<ExrChoice> choose_exr_channels(const Imf::MultiPartInputFile&);

/// Parts and channels in words, for the message that none of them will do.
std::string describe_exr_channels(const Imf::MultiPartInputFile&);

}  // namespace zonal
