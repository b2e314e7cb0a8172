#include "zonal/sphere/projection.h"

#include <gtest/gtest.h>

#include <set>

#include "zonal/sphere/shape.h"

namespace zonal {
namespace {

TEST(Projection, NamesAreUniqueAndFound) {
  std::set<std::string_view> names;
  for (const Layout layout : all_layouts()) {
    EXPECT_EQ(layout_named(name_of(layout)), layout);
    names.insert(name_of(layout));
  }
  EXPECT_EQ(names.size(), 14u);
  EXPECT_EQ(layout_named("cube"), std::nullopt);
  EXPECT_EQ(layout_named(""), std::nullopt);

  std::set<std::string_view> models;
  for (const LensModel model :
       {LensModel::kEquidistant, LensModel::kEquisolid, LensModel::kStereographic, LensModel::kOrthographic}) {
    EXPECT_EQ(lens_model_named(name_of(model)), model);
    models.insert(name_of(model));
  }
  EXPECT_EQ(models.size(), 4u);
  EXPECT_EQ(lens_model_named("fisheye"), std::nullopt);
}

TEST(Projection, SizesGoBothWays) {
  int checked = 0;
  for (const Layout layout : all_layouts()) {
    for (const int natural : {1, 2, 7, 256, 1000}) {
      EXPECT_EQ(natural_size(layout, image_size(layout, natural)), natural) << name_of(layout);
      EXPECT_EQ(nearest_size(layout, image_size(layout, natural)), image_size(layout, natural)) << name_of(layout);
      ++checked;
    }
    EXPECT_EQ(natural_size(layout, {0, 0}), std::nullopt);
    EXPECT_EQ(natural_size(layout, {-2, -1}), std::nullopt);
    EXPECT_FALSE(shape_in_words(layout).empty());
  }
  EXPECT_EQ(checked, 70);
  EXPECT_EQ(image_size(Layout::kCubeCross, 256), (ImageSize{1024, 768}));
  EXPECT_EQ(image_size(Layout::kCubeStack, 16), (ImageSize{16, 96}));
  EXPECT_THROW(image_size(Layout::kEquirect, 0), std::logic_error);
  EXPECT_THROW(image_size(Layout::kCubeRow, 2000000000), std::logic_error);
}

TEST(Projection, ShapesAreExactButForPanoramasAndFisheyes) {
  EXPECT_EQ(natural_size(Layout::kEquirect, {1922, 958}), 958);
  EXPECT_EQ(natural_size(Layout::kEquirect, {1940, 958}), std::nullopt);
  EXPECT_EQ(natural_size(Layout::kCubeCross, {1024, 767}), std::nullopt);
  EXPECT_EQ(natural_size(Layout::kCubeCross, {1023, 768}), std::nullopt);
  EXPECT_EQ(natural_size(Layout::kAngular, {640, 639}), std::nullopt);
  EXPECT_EQ(natural_size(Layout::kFisheye, {3111, 2074}), 2074);
  EXPECT_EQ(natural_size(Layout::kDualFisheye, {1920, 1080}), 960);
  EXPECT_EQ(natural_size(Layout::kDualFisheye, {1921, 1080}), std::nullopt);
}

TEST(Guess, FollowsNameThenShape) {
  struct Row {
    ImageSize size;
    const char* name;
    std::optional<Layout> expected;
  };
  const Row rows[] = {
      {{2048, 1024}, "quarry_01_1k.hdr", Layout::kEquirect},
      {{1600, 800}, "newport_loft.hdr", Layout::kEquirect},
      {{1922, 958}, "theta_s_stitched.png", Layout::kEquirect},
      {{2048, 1024}, "evening_sky.exr", Layout::kEquirect},
      {{640, 320}, "dualfisheye.png", Layout::kDualFisheye},
      {{1920, 1080}, "lobby_dual_fisheye.jpg", Layout::kDualFisheye},
      {{512, 256}, "hall_dual_paraboloid.png", Layout::kDualParaboloid},
      {{640, 640}, "beach_probe.hdr", Layout::kAngular},
      {{640, 640}, "/probes/stuff.hdr", std::nullopt},
      {{640, 640}, "GRACE_ANGULAR.HDR", Layout::kAngular},
      {{381, 381}, "office_ball_calib.hdr", Layout::kMirrorBall},
      {{381, 381}, "mirrorball.hdr", Layout::kMirrorBall},
      {{381, 381}, "ballroom.hdr", std::nullopt},
      {{512, 512}, "matcap_jade.exr", Layout::kSphereMap},
      {{256, 256}, "skymap0.tga", Layout::kFisheye},
      {{256, 256}, "sky-3.tga", Layout::kFisheye},
      {{256, 256}, "kaminsky.tga", std::nullopt},
      {{3111, 2074}, "roof_fisheye.jpg", Layout::kFisheye},
      {{256, 256}, "hall_octahedral.exr", Layout::kOctahedral},
      {{256, 256}, "hall_oct.exr", Layout::kOctahedral},
      {{256, 256}, "doctor.exr", std::nullopt},
      {{256, 256}, "equal_area_sky.exr", Layout::kOctahedralEqualArea},
      {{1024, 768}, "grace_cross.hdr", Layout::kCubeCross},
      {{768, 1024}, "grace_cross.hdr", Layout::kCubeCrossVertical},
      {{1536, 256}, "faces.png", Layout::kCubeRow},
      {{256, 1536}, "faces.png", Layout::kCubeStack},
      {{640, 640}, "picture.png", std::nullopt},
      {{1920, 1080}, "picture.png", std::nullopt},
      {{1, 1}, "", std::nullopt},
      {{0, 0}, "sky.png", std::nullopt},
  };
  int guessed = 0, unknown = 0;
  for (const Row& row : rows) {
    const auto guess = guess_projection(row.size, row.name);
    ASSERT_EQ(guess.has_value(), row.expected.has_value()) << row.name;
    if (!guess) {
      ++unknown;
      continue;
    }
    EXPECT_EQ(guess->projection, Projection{*row.expected}) << row.name;
    EXPECT_TRUE(natural_size(*row.expected, row.size)) << row.name;
    EXPECT_GT(guess->reason.size(), 10u) << row.name;
    ++guessed;
  }
  EXPECT_EQ(guessed, 22);
  EXPECT_EQ(unknown, 8);
  EXPECT_EQ(guess_projection({2048, 1024}, "a.hdr")->reason, "2:1, and nothing in its name says otherwise");
  EXPECT_EQ(guess_projection({640, 640}, "beach_probe.hdr")->reason, "its name says \"probe\"");
}

}  // namespace
}  // namespace zonal
