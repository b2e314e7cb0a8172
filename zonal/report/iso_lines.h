#pragma once

#include "zonal/image/image.h"
#include "zonal/image/tonemap.h"

namespace zonal {

/// How values become colours: `limit` is the size of the values with the strongest colours, `step` the distance of the
/// lines. Both 0 (a function that is zero everywhere): one colour and no lines.
struct IsoScale {
  double limit = 0, step = 0;
};

/// The colour of a value: from green at zero over yellow to red at the limit and beyond; *every* negative value is
/// blue, light just below zero and dark at minus the limit, so that the border of blue is the zero line. Blue is the
/// greatest channel of negative values and the least of all others. NaN is grey.
Rgb8 iso_color(double value, const IsoScale&);

/// A picture of values in these colours with white lines at whole multiples of the step (zero too), about one and a
/// half pixels wide at any slope. White never covers a pixel wholly, so the sign of each can still be seen.
Image<Rgb8> iso_lines(const Image<double>& values, const IsoScale&);

/// The colours and lines from -limit (left) to the limit (right).
Image<Rgb8> iso_key(const IsoScale&, int width_px, int height_px);

}  // namespace zonal
