#pragma once

#include <functional>

#include "zonal/base/run.h"
#include "zonal/image/tonemap.h"
#include "zonal/light/environment.h"
#include "zonal/report/gallery.h"
#include "zonal/sh/sh.h"

namespace zonal {

// What the figures of gallery_lights() share, and the figures, each in the file gallery_light_NAME.cpp. Only for
// gallery_lights().

inline constexpr int kGalleryBands = 6;        ///< as nearly all figures of the paper
inline constexpr int kProbeRows = 256;         ///< of the picture that stands for the probe
inline constexpr double kShownMean = 1.0 / 3;  ///< where its exposure puts its mean luminance, before the tone curve

/// The probe as the figures use it.
struct ShownProbe {
  Environment map;           ///< equirectangular, kProbeRows high
  Sh<RgbD> radiance;         ///< of `map`, kGalleryBands
  Tonemap curve;             ///< the one exposure of all pictures of it
  Rotation world_from_view;  ///< the viewer's +X, +Y, +Z are toward the viewer, right, up
};

/// Throws as gallery_lights() does.
ShownProbe shown_probe(const Environment& probe, const Run&);

/// A function of the world as the viewer of draw_ball() or draw_sphere_disc() sees it; up to kGalleryBands.
std::function<Rgb(Vec3)> seen(const Sh<RgbD>&, const Rotation& world_from_view = {});
/// The same for one channel.
std::function<double(Vec3)> seen(const Sh<double>&, const Rotation& world_from_view = {});
/// Rec. 709 luminance, which is linear.
Sh<double> luminance(const Sh<RgbD>&);
/// Linear light 0..1 as the display shows it; what is brighter is white, what is negative black.
Image<Rgb8> displayed(const Image<Rgb>&);

GalleryFigure rotating_light_figure();
GalleryFigure probe_bands_figure(const ShownProbe&);
GalleryFigure extracted_lights_figure(const ShownProbe&);
GalleryFigure windowed_probe_figure(const ShownProbe&);
GalleryFigure yellow_light_figure();
GalleryFigure content_window_figure();
GalleryFigure hole_in_the_sky_figure();

}  // namespace zonal
