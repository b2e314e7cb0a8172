// The window itself, driven through what its events call.
#include <cstdio>
#include <limits>
#include <thread>

#include "tests/viewer/window_fixture_test.h"
#include "zonal/base/error.h"
#include "zonal/io/picture.h"

namespace zonal {
namespace {

constexpr int kLeft = 0, kRight = 1;
constexpr int kRightArrow = 262;  // as GLFW numbers keys

Image<Rgb> painted_card() { return testcard({Layout::kEquirect}, image_size(Layout::kEquirect, 64)).radiance; }

TEST_F(ViewerWindowTest, ShowsAnObjectAndItsDifference) {
  const Image<Rgb8> picture = rest();
  EXPECT_GT(picture.width(), 500);
  ASSERT_TRUE(viewer().difference());
  EXPECT_GT(viewer().difference()->pixels, 300) << "the least there is, on a slow machine";
  EXPECT_GT(viewer().difference()->rms, 0);
  EXPECT_TRUE(viewer().messages().empty());
  Image<Rgb8> plain(picture.width(), picture.height(), picture(0, 0));
  EXPECT_GT(changed(picture, plain), 0.5);
  keep_window("window");
}

TEST_F(ViewerWindowTest, OpensWhatIsDropped) {
  const Image<Rgb8> before = rest();
  const Environment card = testcard({Layout::kEquirect}, image_size(Layout::kEquirect, 64));
  save_picture(card.radiance, folder_ / "card.hdr");
  window().dropped({folder_ / "card.hdr"});
  ASSERT_TRUE(frames_until([&] { return viewer().light_name() == "card.hdr"; }));
  const Image<Rgb8> lit = rest();
  EXPECT_GT(changed(before, lit), 0.5);

  window().dropped({write("tent.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 1 0\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")});
  ASSERT_TRUE(frames_until([&] { return viewer().mesh_name() == "tent.obj, 4 triangles"; }));
  EXPECT_GT(changed(lit, rest()), 0.02);
  EXPECT_TRUE(is_told("Y axis")) << "what was assumed is said";

  viewer().open_mesh("sphere");
  viewer().open_light("sky", small_sky);
  EXPECT_TRUE(
      frames_until([&] { return viewer().light_name() == "sky" && viewer().mesh_name().starts_with("sphere"); }));
}

TEST_F(ViewerWindowTest, SeveralFilesAreDroppedAtOnce) {
  const auto tent = [&](const std::string& name) {
    return write(name, "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 1 0\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  };
  const Environment stack = testcard({Layout::kCubeStack}, image_size(Layout::kCubeStack, 32));
  std::vector<std::filesystem::path> files = {tent("one.obj"), tent("two.obj")};
  for (int i = 0; i < 6; ++i) {
    constexpr std::array kFaces = {"px", "nx", "py", "ny", "pz", "nz"};
    Image<Rgb> face(32, 32);
    for (int y = 0; y < 32; ++y) std::ranges::copy(stack.radiance.row(32 * i + y), face.row(y).begin());
    files.push_back(folder_ / fmt::format("{}.pfm", kFaces[static_cast<std::size_t>(i)]));
    save_picture(face, files.back());
  }
  window().dropped(files);
  EXPECT_TRUE(frames_until([&] { return viewer().mesh_name() == "two.obj, 4 triangles"; }));
  EXPECT_TRUE(frames_until([&] { return viewer().light_name() == "px.pfm and 5 more"; }));
  EXPECT_TRUE(is_told("2 meshes"));
  rest();
  keep_window("six_faces");
  window().dropped({files[2], files[3], files[4]});
  EXPECT_TRUE(frames_until([&] { return is_told("and 2 more"); })) << "three are no cube";
  viewer().open_mesh("sphere");
  viewer().open_light("sky", small_sky);
  EXPECT_TRUE(frames_until([&] { return viewer().light_name() == "sky" && viewer().state().mesh == "sphere"; }));
}

TEST_F(ViewerWindowTest, WhatIsBrokenIsAMessage) {
  const Image<Rgb8> before = rest();
  window().dropped(
      {write("broken.ply", "ply\nformat ascii 1.0\nelement vertex 9999999999\nproperty float x\nend_header\n")});
  EXPECT_TRUE(frames_until([&] { return is_told("broken.ply: it ends early"); }));
  keep_window("broken_mesh");
  Environment bad = small_sky({});
  bad.radiance(5, 5).g = std::numeric_limits<float>::quiet_NaN();
  save_picture(bad.radiance, folder_ / "bad.pfm");
  window().dropped({folder_ / "bad.pfm"});
  EXPECT_TRUE(frames_until([&] { return is_told("bad.pfm"); }));
  window().dropped({write("text.hdr", "no picture")});
  EXPECT_TRUE(frames_until([&] { return is_told("text.hdr"); }));
  window().dropped({folder_ / "nothing.glb"});
  EXPECT_TRUE(frames_until([&] { return is_told("nothing.glb"); }));
  viewer().set_settings("roughness=7");
  EXPECT_TRUE(is_told("roughness is 7"));
  viewer().set_settings("shiny=1");
  EXPECT_TRUE(is_told("shiny"));
  EXPECT_EQ(changed(before, rest()), 0) << "and what was there is still there";
}

TEST_F(ViewerWindowTest, HandAndKeysMoveTheEye) {
  const Image<Rgb8> before = rest();
  const OrbitCamera camera = viewer().state().camera;
  window().pointer_moved(800, 400);
  window().button(kLeft, true);
  window().pointer_moved(900, 440);
  window().button(kLeft, false);
  window().pointer_moved(300, 300);  // not held any more
  EXPECT_LT(viewer().state().camera.yaw_deg, camera.yaw_deg);
  EXPECT_GT(viewer().state().camera.pitch_deg, camera.pitch_deg);
  const Image<Rgb8> turned = rest();
  EXPECT_GT(changed(before, turned), 0.2);
  window().scrolled(3);
  EXPECT_LT(viewer().state().camera.distance, camera.distance);
  const Image<Rgb8> nearer = rest();
  EXPECT_GT(changed(turned, nearer), 0.1);
  window().key(kRightArrow, true);
  EXPECT_GT(changed(nearer, rest()), 0.02) << "an eye that is near sees few texels of the sky";
  viewer().set_camera(camera);
  EXPECT_EQ(changed(before, rest()), 0);
}

TEST_F(ViewerWindowTest, TheLightTurnsWhileItIsDragged) {
  for (const char* id : {"split-sum", "sh-bands"}) {
    viewer().set_technique(*technique_named(id));
    const Image<Rgb8> before = rest();
    const int turns = viewer().live_turns();
    const auto start = Clock::now();
    window().pointer_moved(800, 400);
    window().button(kRight, true);
    double x = 800, y = 400;
    int frames = 0;
    EXPECT_TRUE(frames_until([&] {
      window().pointer_moved(x += 2, y += 0.5);
      ++frames;
      return viewer().live_turns() >= turns + 10;
    }));
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    ASSERT_TRUE(viewer().live_times());
    const LiveTimes times = *viewer().live_times();
    EXPECT_GT(times.turn, 0);
    EXPECT_GT(times.project, 0);
    EXPECT_GT(times.filter, 0);
    fmt::print("{}: turned anew in {:.1f} ms (pixels {:.1f}, harmonics {:.1f}, lights {:.1f}, maps {:.1f}); ", id,
               times.all(), times.turn, times.project, times.derive, times.filter);
    fmt::print("{:.1f} turns and {:.1f} frames a second\n", 10 / seconds, frames / seconds);
    keep_window(std::string("dragged_") + id);
    EXPECT_TRUE(viewer().is_live_possible());
    const int last = viewer().live_turns();
    window().pointer_moved(x += 2, y);
    EXPECT_TRUE(frames_until([&] { return viewer().live_turns() > last + 1 || !viewer().is_turning(); }));
    EXPECT_TRUE(frames_until([&] { return viewer().picture().done(); }));
    const Image<Rgb8> anew = viewer().picture().read();
    window().button(kRight, false);
    EXPECT_NE(viewer().state().value("light_yaw_deg"), 0);
    EXPECT_NE(viewer().state().value("light_pitch_deg"), 0);
    const Image<Rgb8> looked_up = rest();
    EXPECT_GT(changed(before, looked_up), 0.3);
    // Maps of another size, sampled at other places; a sun's edge moves within its texel. But the same picture.
    EXPECT_LT(mean_difference(anew, looked_up), 2);
    EXPECT_GT(mean_difference(before, looked_up), 0.02) << "or nothing would have been compared";
    for (const char* angle : {"light_yaw_deg", "light_pitch_deg", "light_roll_deg"}) viewer().set_control(angle, 0);
    EXPECT_EQ(changed(before, rest()), 0);
  }
}

TEST_F(ViewerWindowTest, AScreenshotIsThePicture) {
  const Image<Rgb8> shown = rest();
  viewer().save_screenshot(folder_ / "shot.png");
  ASSERT_TRUE(frames_until([&] { return is_told("shot.png"); }));
  const Picture written = load_picture(folder_ / "shot.png", {.encoding = Encoding::kLinear});
  ASSERT_EQ(written.pixels.width(), shown.width());
  ASSERT_EQ(written.pixels.height(), shown.height());
  std::size_t same = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Rgb w = written.pixels.values()[i];
    const Rgb8 s = shown.values()[i];
    same += std::lround(255 * w.r) == s.r && std::lround(255 * w.g) == s.g && std::lround(255 * w.b) == s.b;
  }
  EXPECT_EQ(same, shown.size());
  viewer().save_screenshot(folder_ / "no folder" / "shot.png");
  EXPECT_TRUE(frames_until([&] { return is_told("no folder"); })) << "a failure is a message";
}

TEST_F(ViewerWindowTest, AHighlightIsPaintedAndTheObjectFollows) {
  viewer().set_technique(*technique_named("highlight-map"));
  viewer().set_control("highlight_source", 2);
  const Image<Rgb8> plain = rest();
  double longest_ms = 0;
  for (int i = 0; i <= 20; ++i) {  // a frame for every point, as the panel does it
    const auto start = Clock::now();
    viewer().paint_highlight(0.25 + 0.02 * i, 0.35, {.radius = 0.1, .light = {3, 2, 1}});
    longest_ms = std::max(longest_ms, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    window().window().poll();
    window().frame();
  }
  std::printf("the longest of 21 dabs took %.1f ms\n", longest_ms);
  viewer().end_highlight_stroke();
  const Image<Rgb8> painted = rest();
  EXPECT_GT(changed(plain, painted), 0.02);
  keep_window("painted");
  viewer().open_light("sky", small_sky);
  EXPECT_EQ(changed(painted, rest()), 0) << "it outlives the light";
  viewer().replace_highlight(Image<Rgb>(kOwnHighlightPx, kOwnHighlightPx));
  EXPECT_EQ(changed(plain, rest()), 0);

  viewer().set_control("highlight_source", 0);
  save_picture(painted_card(), folder_ / "card.png");
  viewer().open_highlight(folder_ / "card.png");
  EXPECT_TRUE(frames_until([&] { return viewer().state().value("highlight_source") == 2; }));
  EXPECT_GT(changed(plain, rest()), 0.02);
  viewer().open_highlight(write("text.png", "no picture"));
  EXPECT_TRUE(frames_until([&] { return is_told("text.png"); }));
  viewer().set_control("highlight_source", 0);
  viewer().set_technique(all_techniques()[0]);
}

TEST_F(ViewerWindowTest, LongWorkCanBeWatchedCancelledAndReplaced) {
  const Image<Rgb8> before = rest();
  viewer().open_light("endless", endless_light);
  int frames = 0;
  EXPECT_TRUE(frames_until([&] {
    ++frames;
    return frames > 10 && !viewer().progress().empty() && viewer().progress()[0].fraction > 0.2;
  })) << "the window lives meanwhile";
  keep_window("progress");
  viewer().cancel();
  EXPECT_TRUE(frames_until([&] { return is_told("endless: cancelled"); }));
  EXPECT_EQ(changed(before, rest()), 0);

  viewer().open_light("endless", endless_light);
  EXPECT_TRUE(frames_until([&] { return !viewer().progress().empty(); }));
  viewer().open_light("newer", small_sky);
  EXPECT_TRUE(frames_until([&] { return viewer().light_name() == "newer"; }));
}

TEST_F(ViewerWindowTest, WorkRunsOnTheThreadsThatWereAskedFor) {
  int threads = -1;
  viewer().open_light("counted", [&](const zonal::Run& run) {
    threads = run.threads;
    return small_sky(run);
  });
  EXPECT_TRUE(frames_until([&] { return viewer().light_name() == "counted"; }));
  EXPECT_EQ(threads, kThreads);
}

TEST_F(ViewerWindowTest, AShaderThatTheDriverRefusesIsAMessage) {
  viewer().set_technique(all_techniques()[0]);
  const Image<Rgb8> before = rest();
  // With the background's body it has two main functions.
  static const Technique kBroken = {
      .id = "background", .title = "Broken", .group = "", .explanation = "", .formula = "", .source = ""};
  viewer().set_technique(kBroken);
  EXPECT_TRUE(frames_until([&] { return is_told("refuses the shaders of 'Broken'"); }));
  EXPECT_EQ(viewer().state().technique, &all_techniques()[0]) << "back to the last one that could be drawn";
  EXPECT_EQ(changed(before, rest()), 0);
}

TEST_F(ViewerWindowTest, EveryTechniqueIsDrawnAndMeasured) {
  int drawn = 0;
  for (const Technique& technique : all_techniques()) {
    viewer().set_technique(technique);
    rest();
    viewer().set_camera(viewer().state().camera);  // once more: the driver has its program now
    rest();
    EXPECT_TRUE(viewer().difference()) << technique.id;
    EXPECT_TRUE(viewer().messages().empty()) << technique.id << ": " << viewer().messages().front().text;
    const ImageSize size = viewer().picture().size();
    std::printf("%-20s %7.1f ms at %dx%d, difference %.3g\n", std::string(technique.id).c_str(),
                viewer().picture().full_ms(), size.width, size.height, viewer().difference()->rms);
    ++drawn;
  }
  EXPECT_EQ(drawn, static_cast<int>(all_techniques().size()));
}

TEST_F(ViewerWindowTest, ASlowAnswerDoesNotHoldTheWindowUp) {
  viewer().set_technique(*technique_named("split-sum"));
  viewer().set_control("compare", 1);
  double longest_ms = 0;
  int frames = 0;
  EXPECT_TRUE(frames_until([&] {
    const auto start = Clock::now();
    window().frame();
    longest_ms = std::max(longest_ms, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    ++frames;
    return viewer().picture().done() || frames >= 12;
  }));
  EXPECT_GT(frames, 3) << "it is drawn in parts";
  std::printf("the exact answer of split-sum: the longest of %d frames took %.0f ms\n", frames, longest_ms);
  keep_window("exact_glossy");
  viewer().set_control("compare", 0);
  viewer().set_technique(all_techniques()[0]);
}

}  // namespace
}  // namespace zonal
