#include "zonal/io/response_file.h"

#include <gtest/gtest.h>

#include "zonal/base/error.h"
#include "zonal/io/file.h"
#include "zonal/io/sample_files_test.h"

namespace zonal {
namespace {

TEST(ResponseFile, KeepsEveryBit) {
  Response response = Response::srgb();
  for (double& x : response.exposure[1]) x *= 1.1;
  for (double& x : response.exposure[2]) x /= 3;
  EXPECT_EQ(parse_response("r", response_text(response)).exposure, response.exposure);
  const sample::TemporaryFolder folder;
  write_file(folder / "r.txt", response_text(response));
  EXPECT_EQ(load_response(folder / "r.txt").exposure, response.exposure);
}

TEST(ResponseFile, OneColumnServesAllChannels) {
  std::string text = "# linear\n\n";
  for (int z = 0; z < kCodes; ++z) text += std::to_string(z) + "  # code\r\n";
  const Response response = parse_response("r", text);
  for (const ResponseCurve& curve : response.exposure) EXPECT_EQ(curve[200], 200);
}

TEST(ResponseFile, RefusesWhatIsNoResponse) {
  const std::string good = response_text(Response::linear());
  const auto replaced = [&](const std::string& line) {
    const std::size_t at = good.find('\n', good.find('\n') + 1) + 1;  // the line of code 1
    return std::string(good).replace(at, good.find('\n', at) - at, line);
  };
  int refused = 0;
  for (const auto& [text, says] : {std::pair{std::string(), "only 0 codes"},
                                   {good + "9 9 9\n", "more than 256"},
                                   {good.substr(0, good.size() / 2), "codes"},
                                   {replaced("1 2"), "neither one nor three"},
                                   {replaced("a b c"), "no number"},
                                   {replaced("-1 1 1"), "no number"},
                                   {replaced("nan 1 1"), "no number"},
                                   {replaced("9 0 0"), "falls"}}) {
    try {
      parse_response("r.txt", text);
      ADD_FAILURE() << says;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::kInput);
      EXPECT_NE(std::string(e.what()).find(says), std::string::npos) << e.what();
      ++refused;
    }
  }
  std::string zero;
  for (int z = 0; z < kCodes; ++z) zero += "0\n";
  EXPECT_THROW(parse_response("r", zero), Error);
  EXPECT_EQ(refused, 8);
}

}  // namespace
}  // namespace zonal
