#include "zonal/io/file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "zonal/base/error.h"
#include "zonal/io/byte_reader.h"
#include "zonal/io/hash.h"
#include "zonal/io/sample_files_test.h"

namespace zonal {
namespace {

using sample::bytes_of;

/// The kind of Error that `work` throws; fails the test when it throws none.
template <class Work>
ErrorKind kind_thrown(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()), "");
    EXPECT_NE(error.hint(), "") << error.what();
    return error.kind();
  }
  ADD_FAILURE() << "nothing was thrown";
  return ErrorKind::kCancelled;
}

TEST(OutputFile, AppearsWholeOnCommit) {
  const sample::TemporaryFolder folder;
  OutputFile file(folder / "a.bin");
  file.write(bytes_of("hello"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.bin"));
  EXPECT_EQ(file.temporary_path().parent_path(), folder.path());
  file.seek(1);
  file.write(bytes_of("E"));
  EXPECT_EQ(file.position(), 2u);
  file.commit();
  EXPECT_EQ(read_file(folder / "a.bin"), bytes_of("hEllo"));
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(OutputFile, WithoutCommitTheTargetStaysAsItWas) {
  const sample::TemporaryFolder folder;
  write_file(folder / "a.bin", "old");
  {
    OutputFile file(folder / "a.bin");
    file.write(bytes_of("new"));
  }
  EXPECT_EQ(read_file(folder / "a.bin"), bytes_of("old"));
  EXPECT_EQ(folder.file_count(), 1u);
  write_file(folder / "a.bin", "new");
  EXPECT_EQ(read_file(folder / "a.bin"), bytes_of("new"));
}

TEST(OutputFile, FollowsALinkAndKeepsIt) {
  const sample::TemporaryFolder folder;
  write_file(folder / "real.bin", "old");
  std::filesystem::create_symlink("real.bin", folder / "link.bin");
  write_file(folder / "link.bin", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.bin"));
  EXPECT_EQ(read_file(folder / "real.bin"), bytes_of("new"));
}

TEST(OutputFile, RefusesWhatCannotBeAFile) {
  const sample::TemporaryFolder folder;
  EXPECT_EQ(kind_thrown([&] { OutputFile(folder / "missing" / "a.bin"); }), ErrorKind::kOutput);
  EXPECT_EQ(kind_thrown([&] { OutputFile file(folder.path()); }), ErrorKind::kOutput);
  // Renaming over a device would replace the device.
  EXPECT_EQ(kind_thrown([&] { OutputFile("/dev/null"); }), ErrorKind::kOutput);
  // Nobody, not even root, may create a file here.
  EXPECT_EQ(kind_thrown([&] { OutputFile("/proc/zonal.bin"); }), ErrorKind::kOutput);
  EXPECT_EQ(folder.file_count(), 0u);
}

/// Files of this process may not grow beyond a few bytes while one of these lives: a full disk in small.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_limit_);
    const rlimit limit = {bytes, old_limit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &old_limit_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_limit_ = {};
  void (*old_handler_)(int);
};

TEST(OutputFile, AFullDiskIsReportedAndLeavesNothing) {
  const sample::TemporaryFolder folder;
  write_file(folder / "a.bin", "old");
  const std::vector<std::byte> much(1 << 20);
  {
    const FullDisk full(4096);
    EXPECT_EQ(kind_thrown([&] { write_file(folder / "a.bin", much); }), ErrorKind::kOutput);
    // So little that only closing the file writes it.
    EXPECT_EQ(kind_thrown([&] {
                const FullDisk fuller(10);
                write_file(folder / "a.bin", "more than ten bytes");
              }),
              ErrorKind::kOutput);
  }
  EXPECT_EQ(read_file(folder / "a.bin"), bytes_of("old"));
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(OutputFile, AfterAFailureCommitFailsToo) {
  const sample::TemporaryFolder folder;
  OutputFile file(folder / "a.bin");
  const std::vector<std::byte> much(1 << 20);
  {
    const FullDisk full(4096);
    EXPECT_THROW(file.write(much), Error);
  }
  EXPECT_THROW(file.commit(), Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.bin"));
}

TEST(ReadFile, RefusesWhatItCannotRead) {
  const sample::TemporaryFolder folder;
  write_file(folder / "a.bin", "12345");
  EXPECT_EQ(read_file(folder / "a.bin", 5).size(), 5u);
  EXPECT_EQ(kind_thrown([&] { read_file(folder / "a.bin", 4); }), ErrorKind::kInput);
  EXPECT_EQ(kind_thrown([&] { read_file(folder / "missing.bin"); }), ErrorKind::kInput);
  EXPECT_EQ(kind_thrown([&] { read_file(folder.path()); }), ErrorKind::kInput);
  EXPECT_EQ(kind_thrown([&] { read_file("/dev/zero"); }), ErrorKind::kInput);
}

TEST(ByteReader, FileAndMemoryReadAlike) {
  const sample::TemporaryFolder folder;
  std::vector<std::byte> bytes(200'001);  // several windows and a rest
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i * 2654435761u >> 13);
  write_file(folder / "a.bin", bytes);
  int compared = 0;
  const auto try_all = [&](ByteReader reader) {
    EXPECT_EQ(reader.size(), bytes.size());
    for (const std::size_t place : {0, 1, 65535, 65536, 70000, 65537, 131071, 200000, 3}) {
      reader.seek(place);
      EXPECT_EQ(reader.position(), place);
      EXPECT_EQ(reader.byte(), static_cast<std::uint8_t>(bytes[place]));
      ++compared;
    }
    reader.seek(60'000);
    std::vector<std::byte> piece(80'000);
    reader.read(piece);
    EXPECT_TRUE(std::equal(piece.begin(), piece.end(), bytes.begin() + 60'000));
    EXPECT_EQ(reader.remaining(), 60'001u);
    EXPECT_EQ(reader.read_some(piece), 60'001u);
    EXPECT_THROW(reader.byte(), Error);
    reader.seek(300'000);
    EXPECT_THROW(reader.byte(), Error);
    ByteReader other = reader.another();
    EXPECT_EQ(other.byte(), static_cast<std::uint8_t>(bytes[0]));
  };
  try_all(ByteReader(folder / "a.bin"));
  try_all(ByteReader("a.bin", bytes));
  EXPECT_EQ(compared, 18);
}

TEST(Hash, PublishedVectors) {
  // From the authors' test suite of FNV-1a, 64 bits.
  const auto hash_of = [](std::string_view text) {
    Fnv1a hash;
    hash.add(std::as_bytes(std::span(text)));
    return hash.value();
  };
  EXPECT_EQ(hash_of(""), 0xcbf29ce484222325u);
  EXPECT_EQ(hash_of("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(hash_of("foobar"), 0x85944171f73967e8u);
}

TEST(Hash, OfAFileIsThatOfItsBytes) {
  const sample::TemporaryFolder folder;
  const std::vector<std::byte> bytes(100'000, std::byte{7});
  write_file(folder / "a.bin", bytes);
  Fnv1a from_file, from_memory;
  add_file(from_file, folder / "a.bin");
  from_memory.add(bytes);
  EXPECT_EQ(from_file.text(), from_memory.text());
  EXPECT_EQ(Fnv1a().text(), "fnv1a64:cbf29ce484222325");
}

}  // namespace
}  // namespace zonal
