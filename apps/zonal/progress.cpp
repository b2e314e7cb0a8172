#include "apps/zonal/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace zonal {

bool ProgressBar::possible() { return ::isatty(STDERR_FILENO) == 1; }

void ProgressBar::show(std::string_view stage, double fraction) {
  constexpr int kCells = 32;
  constexpr auto kInterval = std::chrono::milliseconds(80);
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < kInterval) return;
  last_ = now;
  const double done = std::clamp(fraction, 0.0, 1.0);
  const auto cells = static_cast<std::size_t>(std::lround(done * kCells));
  const std::string bar = std::string(cells, '#') + std::string(kCells - cells, '.');
  // Back to the start of the line, and erase what is longer than the new text.
  std::fprintf(stderr, "\r[%s] %3.0f %% %.*s\x1b[K", bar.c_str(), 100 * done, static_cast<int>(stage.size()),
               stage.data());
  std::fflush(stderr);
  drawn_ = true;
}

void ProgressBar::clear() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
  drawn_ = false;
}

}  // namespace zonal
