// Tests of the viewer's window in one process with one window. Exit code 77 (skipped) where none can be opened.
// Usage: viewer_window_test [--gtest...] [FOLDER for pictures of the window]
#include <cstdio>

#include "tests/viewer/window_fixture_test.h"
#include "zonal/base/error.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (argc > 1) zonal::picture_folder = argv[1];
  try {
    // A picture of 1280 x 720 beside the panels.
    zonal::ViewerOptions options;
    options.light = zonal::small_sky;
    options.light_name = "sky";
    options.run.threads = zonal::kThreads;
    zonal::the_window = std::make_unique<zonal::ViewerWindow>(std::move(options), zonal::ImageSize{1620, 720});
  } catch (const zonal::Error& e) {
    std::printf("skipped: %s\n", e.what());
    return 77;
  }
  std::printf("drawn by %s\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  const int result = RUN_ALL_TESTS();
  zonal::the_window.reset();
  return result;
}
