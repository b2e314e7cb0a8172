#include "zonal/report/png_uri.h"

#include "zonal/base/check.h"
#include "zonal/io/base64.h"
#include "zonal/io/png.h"

namespace zonal {

std::string png_data_uri(const Image<Rgb8>& picture) {
  check(!picture.empty(), "a picture for the page must not be empty");
  return "data:image/png;base64," + base64_text(encode_png(picture));
}

}  // namespace zonal
