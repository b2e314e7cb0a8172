#include <system_error>

#include "zonal/io/byte_reader.h"

// Readers of files, apart from the others: a program without a file system has memory to read.

namespace zonal {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kWindowBytes = std::size_t{1} << 16;

}  // namespace

ByteReader::ByteReader(const fs::path& path) : name_(path.string()), path_(path), buffer_(kWindowBytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) fail("there is no such file", "check the path");
  if (fs::is_directory(status)) fail("this is a folder, not a file", "name a file in it");
  if (!fs::is_regular_file(status)) fail("this is not a regular file", "write it to disk first");
  size_ = fs::file_size(path, error);
  stream_ = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (error || !*stream_) fail("the file cannot be opened", "check that you may read it");
}

}  // namespace zonal
