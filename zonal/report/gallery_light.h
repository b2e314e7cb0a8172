#pragma once

#include <vector>

#include "zonal/base/run.h"
#include "zonal/light/environment.h"
#include "zonal/report/gallery.h"

namespace zonal {

/// The figures of the gallery that show light on balls and all around, in the order of the paper: "rotating-light",
/// "probe-bands", "extracted-lights", "windowed-probe", "yellow-light", "content-window", "hole-in-the-sky". The second
/// to fourth show `probe`, which may be any environment, also black, tiny or of low range; their exposure puts the
/// mean of its luminance at 1/3. The others have lights of their own. The same for any number of threads. Throws
/// Error{kInput} when the size does not fit the projection or a value is not finite, Error{kCancelled}.
std::vector<GalleryFigure> gallery_lights(const Environment& probe, const Run& run = {});

}  // namespace zonal
