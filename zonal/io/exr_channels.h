#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "zonal/io/picture.h"

namespace zonal {

/// Inclusive corners, as OpenEXR writes them.
struct ExrWindow {
  int left = 0, top = 0, right = 0, bottom = 0;
  bool operator==(const ExrWindow&) const = default;
};

/// What the header of one part says about its pixels, by whichever library it was read.
struct ExrPart {
  std::string name;
  bool is_deep = false;
  std::vector<std::string> channels;
  ExrWindow data, display;
  std::optional<std::array<float, 8>> chromaticities;  ///< x and y of red, green, blue and white
  std::optional<int> envmap;                           ///< 0: latitude-longitude, 1: cube
};

/// Where the colour of an OpenEXR file is.
struct ExrChoice {
  int part = 0;
  enum Kind { kRgb, kLuminance, kLuminanceChroma } kind = kRgb;
  std::string layer;                  ///< with its dot; empty for the main layer
  std::vector<std::string> channels;  ///< R, G, B or Y, with their layer
  bool alpha = false;
  std::vector<std::string> notes;  ///< of the choice, and of what the part's header says beside it
};

/// The first flat part with R, G, B or Y, in its main layer or else in its first layer that has them. Where none has,
/// throws the reader's Error{kInput}, which lists what is there.
ExrChoice choose_exr_channels(const ByteReader&, std::span<const ExrPart>);

/// A black picture of this size that says of itself what the choice does.
Picture exr_picture(const ExrChoice&, int width, int height);

}  // namespace zonal
