#include "zonal/io/exposure_list.h"

#include <gtest/gtest.h>

#include "zonal/base/error.h"

namespace zonal {
namespace {

TEST(ExposureTimes, AreSecondsFractionsOrSteps) {
  EXPECT_EQ(parse_exposure_times("1/1000,1/250,0.5,2"), (std::vector<double>{0.001, 0.004, 0.5, 2}));
  EXPECT_EQ(parse_exposure_times("-2ev,0ev,+1ev"), (std::vector<double>{0.25, 1, 2}));
  int refused = 0;
  for (const char* text : {"", "1,", "0", "-1", "1/0", "a", "1/250s", "1,2ev", "nan", "1e999", "1/-5", "9999ev"}) {
    try {
      parse_exposure_times(text);
      ADD_FAILURE() << text;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::kUsage);
      ++refused;
    }
  }
  EXPECT_EQ(refused, 12);
}

TEST(ExposureList, HasTimesNamesOrColumns) {
  const auto times = parse_exposure_list("l", "# mine\n1/250\n 0.5  # the second\r\n\n-3ev\n");
  ASSERT_EQ(times.size(), 3u);
  EXPECT_EQ(times[0].settings.seconds, 0.004);
  EXPECT_EQ(times[2].settings.seconds, 0.125);
  EXPECT_TRUE(times[0].file.empty());

  const auto names = parse_exposure_list("l", "a.jpg 1/4\nb.jpg 2");
  ASSERT_EQ(names.size(), 2u);
  EXPECT_EQ(names[1].file, "b.jpg");
  EXPECT_EQ(names[1].settings.seconds, 2);

  const auto hdrgen = parse_exposure_list("l", "a.jpg 30 8.0 200 0\nb.jpg 0.5 4 200 1.5\n");
  ASSERT_EQ(hdrgen.size(), 2u);
  EXPECT_EQ(hdrgen[0].settings, (ExposureSettings{1.0 / 30, 8.0, 200.0, 0}));
  EXPECT_EQ(hdrgen[1].settings, (ExposureSettings{2.0, 4.0, 200.0, 1.5}));

  const auto gain = parse_exposure_list(
      "l",
      "# Number of Images\n2\n# Filename  1/shutter_speed f/stop gain(db) ND_filters\na.ppm 0.5 8 0 0\nb.ppm 4 8 6 0");
  ASSERT_EQ(gain.size(), 2u);
  EXPECT_EQ(gain[0].settings, (ExposureSettings{2.0, 8.0, {}, 0}));
  EXPECT_EQ(gain[1].settings.seconds, 1.0);  // 6 dB are two doublings
}

TEST(ExposureList, SaysWhichLineIsWrong) {
  int refused = 0;
  for (const char* text :
       {"a.jpg 1\nb.jpg zero", "1\nb.jpg 0 8 100 0", "1\nb.jpg 5 -8 100 0", "1\n1 2 3 4 5 6", "1\nx"}) {
    try {
      parse_exposure_list("list.txt", text);
      ADD_FAILURE() << text;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::kInput);
      EXPECT_NE(std::string(e.what()).find("list.txt, line 2"), std::string::npos) << e.what();
      ++refused;
    }
  }
  EXPECT_EQ(refused, 5);
  EXPECT_THROW(parse_exposure_list("l", "# nothing\n"), Error);
}

}  // namespace
}  // namespace zonal
