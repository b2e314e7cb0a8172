#include "zonal/io/ktx2_zstd.h"

#include "zonal/base/check.h"
#include "zonal/base/error.h"

#ifdef ZONAL_HAS_ZSTD
#include <zstd.h>

#include <memory>
#endif

namespace zonal {

#ifdef ZONAL_HAS_ZSTD

bool has_zstd() { return true; }

std::size_t zstd_bound(std::size_t size) { return ZSTD_compressBound(size); }

std::size_t zstd_compress(std::span<const std::byte> in, std::span<std::byte> out, int level) {
  const std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> context(ZSTD_createCCtx(), ZSTD_freeCCtx);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  const std::size_t length = ZSTD_compress2(context.get(), out.data(), out.size(), in.data(), in.size());
  check(ZSTD_isError(length) == 0, "zstd_compress: the output is too small");
  return length;
}

std::optional<std::uint64_t> zstd_content_size(std::span<const std::byte> in) {
  const unsigned long long size = ZSTD_getFrameContentSize(in.data(), in.size());
  if (size == ZSTD_CONTENTSIZE_UNKNOWN || size == ZSTD_CONTENTSIZE_ERROR) return std::nullopt;
  const std::size_t frame = ZSTD_findFrameCompressedSize(in.data(), in.size());
  if (ZSTD_isError(frame) || frame != in.size()) return std::nullopt;
  return size;
}

bool zstd_decompress(std::span<const std::byte> in, std::span<std::byte> out) {
  return ZSTD_decompress(out.data(), out.size(), in.data(), in.size()) == out.size();
}

#else

namespace {
[[noreturn]] void fail() {
  throw Error(ErrorKind::kUsage, "this build has no Zstandard",
              "install libzstd-dev and build again, or use no compression");
}
}  // namespace

bool has_zstd() { return false; }
std::size_t zstd_bound(std::size_t) { fail(); }
std::size_t zstd_compress(std::span<const std::byte>, std::span<std::byte>, int) { fail(); }
std::optional<std::uint64_t> zstd_content_size(std::span<const std::byte>) { fail(); }
bool zstd_decompress(std::span<const std::byte>, std::span<std::byte>) { fail(); }

#endif

}  // namespace zonal
