#pragma once

// What TinyEXR asks of zlib. Nothing is written in a page, so nothing is packed.
using Bytef = unsigned char;
using uLong = unsigned long;
constexpr int Z_OK = 0, Z_STREAM_ERROR = -2;

/// In apps/web/exr_library.cpp.
int uncompress(Bytef* to, uLong* to_size, const Bytef* from, uLong from_size);

inline uLong compressBound(uLong size) { return size; }
inline int compress(Bytef*, uLong*, const Bytef*, uLong) { return Z_STREAM_ERROR; }
