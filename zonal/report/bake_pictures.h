#pragma once

#include <string>
#include <vector>

#include "zonal/base/run.h"
#include "zonal/image/tonemap.h"
#include "zonal/report/bake_page.h"

namespace zonal {

/// A picture ready to be shown.
struct EncodedPicture {
  std::string uri;
  int width = 0, height = 0;
};

/// Everything that the page of a bake shows, at one exposure. Irradiance is divided by π: the radiance of a white matt
/// surface.
struct BakePictures {
  Tonemap tonemap;
  EncodedPicture panorama, irradiance;
  std::vector<EncodedPicture> chain_balls;
  EncodedPicture exact_ball, exact_map;
  struct Fit {
    EncodedPicture ball, map, error;  ///< the error in false colours, white at the picture's own largest
  };
  std::vector<Fit> fits;
  EncodedPicture error_scale;  ///< the false colours from nothing to the largest error
  EncodedPicture split_sum;    ///< empty without one
};

/// Sizes are fixed, so that the page's size does not grow with the maps. Throws as bake_page_html() does.
BakePictures draw_bake_pictures(const BakePage&, const Run&);

inline constexpr int kPagePanoramaHeight = 512;

}  // namespace zonal
