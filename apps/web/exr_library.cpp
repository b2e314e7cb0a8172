// TinyEXR, with the inflate of stb_image in place of zlib's.
#include <limits>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#include <stb/stb_image.h>
#define TINYEXR_IMPLEMENTATION
#include <tinyexr.h>

int uncompress(Bytef* to, uLong* to_size, const Bytef* from, uLong from_size) {
  constexpr uLong kMost = std::numeric_limits<int>::max();
  if (*to_size > kMost || from_size > kMost) return Z_STREAM_ERROR;
  const int size = stbi_zlib_decode_buffer(reinterpret_cast<char*>(to), static_cast<int>(*to_size),
                                           reinterpret_cast<const char*>(from), static_cast<int>(from_size));
  if (size < 0) return Z_STREAM_ERROR;
  *to_size = static_cast<uLong>(size);
  return Z_OK;
}
