#include "zonal/io/file.h"

#include <cerrno>
#include <random>
#include <string>
#include <system_error>

#include "zonal/base/error.h"
#include "zonal/io/byte_reader.h"

namespace zonal {
namespace fs = std::filesystem;
namespace {

std::string words_of(int error_number) {
  return error_number == 0 ? "the write was cut short" : std::generic_category().message(error_number);
}

std::string hint_for(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "free some space or write to another disk";
    case EACCES:
    case EPERM:
    case EROFS:
      return "write to a folder you may write to";
    case ENOENT:
      return "create the folder first";
    default:
      return "write to another folder";
  }
}

Error cannot_write(const fs::path& target, const std::string& why, std::string hint) {
  return Error(ErrorKind::kOutput, "cannot write " + target.string() + ": " + why, std::move(hint));
}

/// Where the bytes shall end up; throws when that cannot be a file.
fs::path final_target(const fs::path& asked) {
  std::error_code ignored;
  const fs::path target = fs::is_symlink(asked, ignored) ? fs::weakly_canonical(asked, ignored) : asked;
  if (target.filename().empty()) throw cannot_write(asked, "it names a folder, not a file", "add a file name");
  const fs::file_status status = fs::status(target, ignored);
  if (fs::is_directory(status)) throw cannot_write(asked, "it is a folder", "name a file in it");
  // Renaming over a device would replace the device itself.
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw cannot_write(asked, "it is not a regular file", "write to an ordinary file");
  }
  return target;
}

}  // namespace

std::vector<std::byte> read_file(const fs::path& path, std::uint64_t max_bytes) {
  ByteReader reader(path);
  if (reader.size() > max_bytes) {
    reader.fail("is " + std::to_string(reader.size()) + " bytes long",
                "at most " + std::to_string(max_bytes) + " bytes are read");
  }
  std::vector<std::byte> bytes(reader.size());
  reader.read(bytes);
  return bytes;
}

OutputFile::OutputFile(const fs::path& target) : target_(final_target(target)) {
  // The exclusive mode makes sure that nobody else's file is opened; a taken name is tried again with another number.
  std::random_device random;
  for (int attempt = 0; attempt < 16 && !file_; ++attempt) {
    temporary_ = target_;
    temporary_ += '.';
    temporary_ += std::to_string(random());
    temporary_ += ".part";
    errno = 0;
    file_.reset(std::fopen(temporary_.c_str(), "wbx"));
    if (!file_ && errno != EEXIST) break;
  }
  if (!file_) {
    const int error_number = errno;
    throw cannot_write(target_, words_of(error_number), hint_for(error_number));
  }
}

OutputFile::~OutputFile() {
  file_.reset();
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void OutputFile::fail(int error_number) {
  failed_ = true;
  throw cannot_write(target_, words_of(error_number), hint_for(error_number));
}

void OutputFile::write(std::span<const std::byte> bytes) {
  if (bytes.empty()) return;
  errno = 0;
  if (failed_ || !file_ || std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) fail(errno);
  position_ += bytes.size();
}

void OutputFile::seek(std::uint64_t position) {
  errno = 0;
  if (failed_ || !file_ || ::fseeko(file_.get(), static_cast<off_t>(position), SEEK_SET) != 0) fail(errno);
  position_ = position;
}

void OutputFile::flush() {
  errno = 0;
  if (failed_ || !file_ || std::fflush(file_.get()) != 0) fail(errno);
}

void OutputFile::commit() {
  errno = 0;
  if (failed_ || !file_) fail(0);
  // Closing flushes, so this is where a full disk may first be noticed.
  if (std::fclose(file_.release()) != 0) fail(errno);
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) fail(error.value());
  temporary_.clear();
}

void write_file(const fs::path& path, std::span<const std::byte> bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

void write_file(const fs::path& path, std::string_view text) { write_file(path, std::as_bytes(std::span(text))); }

}  // namespace zonal
