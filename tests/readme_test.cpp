// The program on the first screen of README.md is the one compiled and run here.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/readme_program.h"
#include "zonal/view/technique.h"

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The lines between two markers, without indentation.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const auto from = text.find(begin);
  if (from == std::string::npos) return {};
  const auto start = from + begin.size();
  std::stringstream lines(text.substr(start, text.find(end, start) - start));
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    const auto first = line.find_first_not_of(' ');
    if (first != std::string::npos) result += line.substr(first) + "\n";
  }
  return result;
}

TEST(Readme, ShowsTheProgramThatIsTested) {
  const fs::path source = ZONAL_SOURCE_DIR;
  const std::string shown = between(text_of(source / "README.md"), "```cpp\n", "```");
  const std::string tested =
      between(text_of(source / "tests/readme_program.h"), "// README begins\n", "// README ends");
  ASSERT_FALSE(tested.empty());
  EXPECT_NE(shown.find(tested), std::string::npos) << "README.md shows:\n"
                                                   << shown << "tests/readme_program.h has:\n"
                                                   << tested;
}

TEST(Readme, TheProgramRuns) {
  const fs::path folder = fs::temp_directory_path() / ("zonal-readme-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  write_readme_sky();
  readme_program();
  fs::current_path(before);
  EXPECT_GT(fs::file_size(folder / "gloss.hdr"), 10000U);
  fs::remove_all(folder);
}

TEST(Docs, TheViewersPageNamesEveryTechnique) {
  const std::string page = text_of(fs::path(ZONAL_SOURCE_DIR) / "docs/viewer.md");
  std::size_t named = 0;
  for (const zonal::Technique& technique : zonal::all_techniques()) {
    const std::string row = std::string(technique.title) + " (`" + std::string(technique.id) + "`)";
    EXPECT_NE(page.find(row), std::string::npos) << row;
    ++named;
  }
  EXPECT_GT(named, 20u);
}

}  // namespace
