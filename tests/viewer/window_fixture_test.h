#pragma once

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "apps/viewer/viewer_window.h"
#include "zonal/base/error.h"
#include "zonal/io/file.h"
#include "zonal/io/picture.h"
#include "zonal/io/png.h"
#include "zonal/light/synthetic.h"

namespace zonal {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

/// One window for all tests.
inline std::unique_ptr<ViewerWindow> the_window;
/// Where pictures of the window are kept for a person to look at; empty: nowhere.
inline std::filesystem::path picture_folder;

inline Environment small_sky(const Run& run) {
  return daylight_sky({Layout::kEquirect}, image_size(Layout::kEquirect, 128), {}, run);
}

/// What the window was asked to run its work on.
inline constexpr int kThreads = 2;

/// Works until it is stopped.
inline Environment endless_light(const Run& run) {
  for (double done = 0; !run.stop.stop_requested(); done = std::min(0.9, done + 0.01)) {
    run.progress("waiting", done);
    std::this_thread::sleep_for(2ms);
  }
  throw Error(ErrorKind::kCancelled, "cancelled");
}

class ViewerWindowTest : public testing::Test {
 protected:
  ViewerWindowTest() {
    folder_ = std::filesystem::temp_directory_path() / fmt::format("zonal_window_{}", static_cast<const void*>(this));
    std::filesystem::create_directories(folder_);
    EXPECT_TRUE(frames_until([&] { return viewer().idle(); })) << "the window does not come to rest";
    viewer().dismiss_messages();
  }
  ~ViewerWindowTest() override {
    viewer().dismiss_messages();
    std::filesystem::remove_all(folder_);
  }

  static ViewerWindow& window() { return *the_window; }
  static Viewer& viewer() { return the_window->viewer(); }

  /// Draws frames, as the window's own loop does; false when it takes more than a minute, and more than the frames of
  /// a machine that others use as well.
  template <class Condition>
  static bool frames_until(Condition reached) {
    const auto patience = Clock::now() + 60s;
    for (int frames = 0; !reached(); ++frames) {
      if (Clock::now() > patience && frames > 100) return false;
      window().window().wait(0.005);
      window().frame();
    }
    return true;
  }
  static Image<Rgb8> rest() {
    EXPECT_TRUE(frames_until([&] { return viewer().idle(); }));
    return viewer().picture().read();
  }
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }
  /// Whether a message with this in it came.
  static bool is_told(const std::string& part) {
    for (const ViewerMessage& message : viewer().messages()) {
      if (message.text.find(part) != std::string::npos) return true;
    }
    return false;
  }
  /// The share of pixels that differ.
  static double changed(const Image<Rgb8>& a, const Image<Rgb8>& b) {
    EXPECT_EQ(a.size(), b.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += !(a.values()[i] == b.values()[i]);
    return static_cast<double>(count) / static_cast<double>(a.size());
  }
  /// Of 8-bit channels.
  static double mean_difference(const Image<Rgb8>& a, const Image<Rgb8>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Rgb8 &p = a.values()[i], &q = b.values()[i];
      sum += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b);
    }
    return sum / (3.0 * static_cast<double>(a.size()));
  }
  /// What is on the screen, panels and all, for a person to look at.
  static void keep_window(const std::string& name) {
    if (picture_folder.empty()) return;
    for (int i = 0; i < 3; ++i) window().frame();  // panels settle
    window().draw_frame();
    const ImageSize size = window().window().framebuffer_size();
    Image<Rgb8> screen(size.width, size.height), upright(size.width, size.height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.width, size.height, GL_RGB, GL_UNSIGNED_BYTE, screen.values().data());
    for (int y = 0; y < size.height; ++y) std::ranges::copy(screen.row(size.height - 1 - y), upright.row(y).begin());
    write_file(picture_folder / (name + ".png"), encode_png(upright));
  }

  std::filesystem::path folder_;
};

}  // namespace zonal
