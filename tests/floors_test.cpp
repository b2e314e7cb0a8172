// The house keeps its shape: a file includes only its own floor or lower ones, and stays a room one can see all of.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr int kLongestFile = 400;

/// What each floor may include besides itself; sphere and image are siblings.
const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"base", {}},
    {"math", {"base"}},
    {"sphere", {"base", "math"}},
    {"image", {"base", "math"}},
    {"sh", {"base", "math"}},
    {"sht", {"base", "math", "sh"}},
    {"light", {"base", "math", "sphere", "image", "sh", "sht"}},
    {"io", {"base", "math", "sphere", "image", "sh", "sht", "light"}},
    {"view", {"base", "math", "sphere", "image", "sh", "sht", "light", "io"}},
    {"report", {"base", "math", "sphere", "image", "sh", "sht", "light", "io", "view"}},
    {"gl", {"base", "math", "sphere", "image", "sh", "sht", "light", "io", "view"}},
};

std::vector<fs::path> sources(const std::vector<std::string>& folders) {
  std::vector<fs::path> files;
  for (const std::string& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(ZONAL_SOURCE_DIR) / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".h" || extension == ".cpp") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream in(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(House, EveryIncludeStaysOnItsFloorOrGoesDown) {
  const std::regex include(R"(^#include "zonal/(\w+)/.*)");
  int includes = 0;
  for (const fs::path& path : sources({"zonal"})) {
    const fs::path inside = fs::relative(path, fs::path(ZONAL_SOURCE_DIR) / "zonal");
    const std::string floor = inside.begin()->string();
    if (inside.has_parent_path() == false) continue;  // the umbrella sees everything
    ASSERT_TRUE(kMayInclude.contains(floor)) << path << " is on no floor of the house";
    for (const std::string& line : lines_of(path)) {
      std::smatch match;
      if (!std::regex_match(line, match, include)) continue;
      ++includes;
      EXPECT_TRUE(match[1] == floor || kMayInclude.at(floor).contains(match[1])) << path << ": " << line;
    }
  }
  EXPECT_GT(includes, 300) << "the scan found too little to mean anything";
}

/// Two types of one name link silently and break each other's functions.
TEST(House, EveryTypeHasItsName) {
  const std::regex type(R"(^(?:class|struct|enum class) ([A-Z]\w*)(?: final)?(?: :.*)? \{.*)");
  std::map<std::string, fs::path> owners;
  for (const fs::path& path : sources({"zonal", "apps"})) {
    if (path.extension() != ".h") continue;
    const std::vector<std::string> lines = lines_of(path);
    // The parts of kernels are in a namespace for each instruction set.
    if (std::ranges::any_of(lines, [](const std::string& l) { return l.find("namespace zonal::ZONAL_ISA") == 0; })) {
      continue;
    }
    for (const std::string& line : lines) {
      std::smatch match;
      if (!std::regex_match(line, match, type)) continue;
      const auto [owner, first] = owners.try_emplace(match[1], path);
      EXPECT_TRUE(first) << match[1] << " is in " << owner->second << " and in " << path;
    }
  }
  EXPECT_GT(owners.size(), 150u);
}

TEST(House, EveryFileIsARoom) {
  int files = 0;
  for (const fs::path& path : sources({"zonal", "apps", "bench", "tests"})) {
    EXPECT_LE(static_cast<int>(lines_of(path).size()), kLongestFile) << path;
    EXPECT_EQ(path.string().find("util"), std::string::npos) << path << ": name it after what is in it";
    ++files;
  }
  EXPECT_GT(files, 100);
}

}  // namespace
