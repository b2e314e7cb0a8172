#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/image/image.h"
#include "zonal/light/environment.h"
#include "zonal/math/vec.h"

namespace zonal {

// The figures of "Stupid Spherical Harmonics (SH) Tricks" (Sloan 2008), drawn again by this library's own verbs, each
// with the numbers that the paper prints and ours beside them.

/// A number that the paper prints, and ours beside it. Holds when |ours - expected| <= tolerance.
struct PublishedNumber {
  std::string what;      ///< in words
  std::string printed;   ///< as the paper prints it; empty: the paper gives none, ours is told for its own sake
  double ours = 0;       ///< computed here
  double expected = 0;   ///< the printed number as a value, or what theory says
  double tolerance = 0;  ///< >= 0: half a unit of the last printed digit, or the rounding of ours
};

/// Whether ours agrees; false for NaN.
inline bool holds(const PublishedNumber& n) { return std::abs(n.ours - n.expected) <= n.tolerance; }

/// One drawing: either an SVG that stands alone, or a picture.
struct GalleryPicture {
  std::string name;  ///< the stem of its file: letters, digits and hyphens; unique in the gallery
  std::string alt;   ///< what it shows, for those who cannot see it
  std::string svg = {};
  Image<Rgb> picture = {};  ///< linear light of the display, 0..1, tone-mapped already; written with the sRGB curve
  int scale = 1;            ///< picture pixels for each pixel of the page, so that it is sharp on fine displays
};

struct GalleryFigure {
  std::string id;  ///< letters, digits and hyphens; unique in the gallery
  std::string title;
  std::string source;  ///< "Sloan 2008, section ..., figure ..."
  std::vector<GalleryPicture> pictures;
  std::string caption;
  std::vector<PublishedNumber> numbers = {};
};

/// The figures that are functions of one angle or shapes: they need no light from outside and are always the same.
/// Throws Error{kCancelled}.
std::vector<GalleryFigure> gallery_plots(const Run& = {});

/// All figures in the order of the paper; those that need light from everywhere show `probe`, which may be any
/// environment whose values are finite. Throws Error{kInput} for values that are not, Error{kCancelled}.
std::vector<GalleryFigure> gallery_figures(const Environment& probe, const Run& = {});

}  // namespace zonal
