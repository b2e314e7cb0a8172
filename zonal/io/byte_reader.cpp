#include "zonal/io/byte_reader.h"

#include <algorithm>
#include <cstring>

#include "zonal/base/error.h"

namespace zonal {

ByteReader::ByteReader(std::string name, std::vector<std::byte> bytes)
    : name_(std::move(name)), memory_(std::make_shared<const std::vector<std::byte>>(std::move(bytes))) {
  window_ = *memory_;
  size_ = window_.size();
}

ByteReader ByteReader::another() const {
  if (!memory_) return ByteReader(path_);
  ByteReader copy(name_, {});
  copy.memory_ = memory_;
  copy.window_ = *memory_;
  copy.size_ = size_;
  return copy;
}

void ByteReader::seek(std::uint64_t position) {
  if (position >= window_start_ && position - window_start_ <= window_.size()) {
    next_ = static_cast<std::size_t>(position - window_start_);
    return;
  }
  // An empty window at the new place: the next read fills it, or finds that the file has ended.
  window_ = {};
  window_start_ = position;
  next_ = 0;
}

bool ByteReader::try_refill() noexcept {
  const std::uint64_t place = position();
  if (place >= size_) return false;
  if (memory_) {
    window_ = *memory_;
    window_start_ = 0;
    next_ = static_cast<std::size_t>(place);
    return true;
  }
  stream_->clear();
  stream_->seekg(static_cast<std::streamoff>(place));
  stream_->read(reinterpret_cast<char*>(buffer_.data()), static_cast<std::streamsize>(buffer_.size()));
  window_ = std::span<const std::byte>(buffer_).first(
      static_cast<std::size_t>(std::max<std::streamsize>(0, stream_->gcount())));
  window_start_ = place;
  next_ = 0;
  return !window_.empty();
}

void ByteReader::refill() {
  if (!try_refill()) fail_early_end();
}

std::size_t ByteReader::read_some(std::span<std::byte> into) noexcept {
  std::size_t done = 0;
  while (done < into.size()) {
    if (next_ == window_.size() && !try_refill()) break;
    const std::size_t count = std::min(into.size() - done, window_.size() - next_);
    std::memcpy(into.data() + done, window_.data() + next_, count);
    next_ += count;
    done += count;
  }
  return done;
}

void ByteReader::read(std::span<std::byte> into) {
  if (read_some(into) != into.size()) fail_early_end();
}

std::vector<std::uint8_t> ByteReader::head(std::size_t count) {
  seek(0);
  std::vector<std::uint8_t> bytes(count);
  bytes.resize(read_some(std::as_writable_bytes(std::span(bytes))));
  seek(0);
  return bytes;
}

void ByteReader::fail(const std::string& what, const std::string& hint) const {
  throw Error(ErrorKind::kInput, name_ + ": " + what, hint);
}

void ByteReader::fail_early_end() const {
  fail("the file ends early, after " + std::to_string(size_) + " bytes", "copy or download it again");
}

}  // namespace zonal
