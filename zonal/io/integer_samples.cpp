#include "zonal/io/integer_samples.h"

#include "zonal/base/check.h"
#include "zonal/image/color.h"

namespace zonal {

bool decide_srgb(const LoadOptions& options, bool file_says_linear, Picture& picture) {
  picture.srgb_decoded =
      options.encoding == Encoding::kSrgb || (options.encoding == Encoding::kAuto && !file_says_linear);
  if (options.encoding == Encoding::kAuto) {
    picture.notes.push_back(file_says_linear ? "the file says that its values are linear"
                                             : "the values are taken as sRGB (nothing says that they are linear)");
  }
  return picture.srgb_decoded;
}

std::vector<float> linear_of_samples(int bits, bool srgb) {
  check(bits >= 1 && bits <= 16, "integer samples have 1 to 16 bits");
  const int count = 1 << bits;
  std::vector<float> linear(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const float value = static_cast<float>(i) / static_cast<float>(count - 1);
    linear[static_cast<std::size_t>(i)] = srgb ? srgb_decode(value) : value;
  }
  return linear;
}

}  // namespace zonal
