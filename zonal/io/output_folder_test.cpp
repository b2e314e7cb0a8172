#include "zonal/io/output_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "zonal/base/error.h"

namespace zonal {
namespace fs = std::filesystem;
namespace {

class OutputFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::path(testing::TempDir()) / (std::string("zonal_output_folder_") + info->name());
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  void TearDown() override { fs::remove_all(root_); }

  static std::ptrdiff_t entries(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  }

  fs::path root_;
};

TEST_F(OutputFolderTest, AllAppearTogether) {
  OutputFolder folder(root_ / "a" / "b");
  folder.add("one.txt", "1");
  folder.add("two.txt", "22");
  EXPECT_FALSE(fs::exists(root_ / "a/b/one.txt"));
  folder.commit();
  EXPECT_EQ(fs::file_size(root_ / "a/b/one.txt"), 1u);
  EXPECT_EQ(fs::file_size(root_ / "a/b/two.txt"), 2u);
  EXPECT_EQ(entries(root_ / "a/b"), 2);
}

TEST_F(OutputFolderTest, WithoutCommitNothingStays) {
  {
    OutputFolder folder(root_ / "a" / "b/");
    folder.add("one.txt", "1");
    EXPECT_EQ(entries(root_ / "a/b"), 1);
  }
  EXPECT_EQ(entries(root_), 0);
}

TEST_F(OutputFolderTest, FoldersThatWereThereStay) {
  fs::create_directories(root_ / "a");
  write_file(root_ / "a/old.txt", std::string_view("old"));
  { OutputFolder(root_ / "a").add("old.txt", "new and longer"); }
  EXPECT_EQ(entries(root_ / "a"), 1);
  EXPECT_EQ(fs::file_size(root_ / "a/old.txt"), 3u);
}

TEST_F(OutputFolderTest, UnderAFileIsAnOutputError) {
  write_file(root_ / "file", std::string_view("x"));
  for (const fs::path& path : {root_ / "file", root_ / "file" / "below"}) {
    try {
      OutputFolder folder(path);
      FAIL() << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kOutput);
      EXPECT_FALSE(error.hint().empty());
    }
  }
  EXPECT_EQ(entries(root_), 1);
}

}  // namespace
}  // namespace zonal
