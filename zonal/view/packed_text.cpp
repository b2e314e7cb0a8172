#include "zonal/view/packed_text.h"

#include <zlib.h>

#include <vector>

#include "zonal/base/check.h"

namespace zonal {

std::string base91_text(std::span<const std::byte> bytes) {
  constexpr unsigned kBase = 91, kBits = 13, kBitsOfOne = 6;
  std::string text;
  text.reserve(bytes.size() * 16 / kBits + 2);
  const auto add = [&](unsigned digit) {
    text += static_cast<char>(digit + 36 - (digit < 29 ? 1 : 0) - (digit < 26 ? 1 : 0) - (digit < 1 ? 1 : 0));
  };
  unsigned bits = 0, held = 0;
  for (const std::byte byte : bytes) {
    bits |= std::to_integer<unsigned>(byte) << held;
    held += 8;
    if (held < kBits) continue;
    const unsigned pair = bits & ((1u << kBits) - 1);
    add(pair % kBase);
    add(pair / kBase);
    bits >>= kBits;
    held -= kBits;
  }
  if (held > 0) add(bits % kBase);
  if (held > kBitsOfOne) add(bits / kBase);
  return text;
}

std::string packed_text(std::span<const std::byte> bytes) {
  const auto size = static_cast<uLong>(bytes.size());
  uLongf length = compressBound(size);
  std::vector<std::byte> packed(length);
  const int result = compress2(reinterpret_cast<Bytef*>(packed.data()), &length,
                               reinterpret_cast<const Bytef*>(bytes.data()), size, 9);
  check(result == Z_OK, "zlib's own bound is enough for its result");
  return base91_text(std::span(packed).first(length));
}

}  // namespace zonal
