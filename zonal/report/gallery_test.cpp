#include "zonal/report/gallery.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "zonal/base/error.h"
#include "zonal/light/synthetic.h"

namespace zonal {
namespace {

TEST(SlowGallery, AllFiguresStandInTheOrderOfThePaper) {
  const Environment probe = gradient({Layout::kEquirect}, {32, 16});
  const std::vector<GalleryFigure> all = gallery_figures(probe);
  std::vector<std::string> ids;
  std::set<std::string> names;
  int numbers = 0, pictures = 0;
  for (const GalleryFigure& figure : all) {
    ids.push_back(figure.id);
    for (const GalleryPicture& picture : figure.pictures) {
      EXPECT_TRUE(names.insert(picture.name).second) << picture.name;
      ++pictures;
    }
    for (const PublishedNumber& n : figure.numbers) {
      EXPECT_TRUE(holds(n)) << figure.id << ": " << n.what << ' ' << n.ours << " for " << n.expected;
      ++numbers;
    }
  }
  EXPECT_EQ(ids, (std::vector<std::string>{
                     "basis-shapes", "basis-cubes", "rotating-light", "clamped-cosine-3", "clamped-cosine-5",
                     "probe-bands", "sphere-light", "cones", "extracted-lights", "windows", "delta-windows",
                     "laplacian", "windowed-probe", "yellow-light", "content-window", "hole-in-the-sky", "legendre"}));
  EXPECT_GE(numbers, 100);
  EXPECT_GE(pictures, 33);
}

TEST(SlowGallery, StopsAndRefuses) {
  Environment probe = furnace({Layout::kEquirect}, {8, 4});
  std::stop_source stop;
  stop.request_stop();
  zonal::Run run;  // testing::Test has a Run of its own
  run.stop = stop.get_token();
  EXPECT_THROW(gallery_figures(probe, run), Error);
  probe.radiance(0, 0).g = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(gallery_figures(probe), Error);
}

}  // namespace
}  // namespace zonal
