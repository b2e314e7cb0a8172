#pragma once

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <string>

namespace zonal {

/// What went wrong inside libpng; plain memory, because it is filled just before a jump.
struct PngFailure {
  std::array<char, 128> message = {};
  bool ended_early = false;
};

[[noreturn]] inline void png_failed(png_structp png, png_const_charp message) {
  auto& text = static_cast<PngFailure*>(png_get_error_ptr(png))->message;
  std::fill(text.begin(), text.end(), '\0');
  std::copy_n(message, std::min(std::char_traits<char>::length(message), text.size() - 1), text.begin());
  png_longjmp(png, 1);
}

inline void png_warned(png_structp, png_const_charp) {}

/// Runs calls into libpng. Its errors jump back here over `work`, which must own nothing: false then.
template <class Work>
bool png_guarded(png_structp png, const Work& work) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  work();
  return true;
}

}  // namespace zonal
