#include "zonal/view/control.h"

#include <array>
#include <string_view>

#include "zonal/base/check.h"

namespace zonal {
namespace {

constexpr std::array<std::string_view, 2> kToneCurves = {"Reinhard", "cut off at white"};
constexpr std::array<std::string_view, 4> kComparisons = {"the technique", "the exact answer", "the difference",
                                                          "left and right"};
constexpr std::array<std::string_view, 3> kAmbient = {"off", "albedo, from everywhere alike",
                                                      "reflectance toward the eye, R_A(v)"};
constexpr std::array<std::string_view, 4> kAmbientBrdfs = {"Lambert", "Phong", "Blinn-Phong", "GGX"};
constexpr std::array<std::string_view, 2> kViewpoints = {"the eye's (as in the lecture)", "the mirrored direction"};
constexpr std::array<std::string_view, 4> kWindows = {"none", "Hann", "Lanczos", "Laplacian"};

constexpr std::array<std::string_view, 2> kBumps = {"a picture of normals", "a picture of heights"};
constexpr std::array<std::string_view, 4> kLookups = {"panorama", "cube map", "dual paraboloid map", "sphere map"};
constexpr std::array<std::string_view, 3> kHighlights = {"computed, (n·h)^40", "drawn", "your own"};
constexpr std::array<std::string_view, 2> kBacks = {"gets nothing (as published)", "shares the mean (two bands)"};
constexpr std::array<std::string_view, 2> kTurns = {"the normal, the other way", "the coefficients"};
constexpr std::array<std::string_view, 2> kLampShapes = {"ball", "square"};
constexpr std::array<std::string_view, 3> kReflections = {"four maps, blended", "the nearest map",
                                                          "split sum (n = v = r)"};
constexpr std::array<std::string_view, 11> kLightSets = {"each for a second", "Old Town Square",      "Grace Cathedral",
                                                         "Eucalyptus Grove",  "St. Peter's Basilica", "Uffizi Gallery",
                                                         "Galileo's tomb",    "Vine Street kitchen",  "Breezeway",
                                                         "Campus Sunset",     "Funston Beach Sunset"};

constexpr std::array<std::string_view, 2> kSkyMaps = {"irradiance", "blurred reflection"};
constexpr std::array<std::string_view, 2> kSkyWeights = {"as published", "corrected"};
constexpr std::array<std::string_view, 3> kSkyOutsides = {"the ground (as published)",
                                                          "extended (the author's footnote)", "two paraboloids"};
constexpr std::array<std::string_view, 3> kSkyForms = {"paraboloid", "panorama", "cube map"};
constexpr std::array<std::string_view, 3> kSkyGrounds = {"mean of the lower half", "black", "grey"};

constexpr std::size_t kCommon = 8;
constexpr Control kControls[] = {
    {.name = "exposure_ev", .label = "exposure, EV", .least = -12, .greatest = 12, .step = 0.25},
    {.name = "tone_curve", .label = "tone curve", .kind = ControlKind::kChoice, .greatest = 1, .choices = kToneCurves},
    {.name = "light_yaw_deg", .label = "light turned, degrees", .least = -180, .greatest = 180, .step = 1},
    {.name = "light_pitch_deg", .label = "light tilted up, degrees", .least = -90, .greatest = 90, .step = 1},
    {.name = "light_roll_deg", .label = "light rolled, degrees", .least = -180, .greatest = 180, .step = 1},
    {.name = "compare", .label = "show", .kind = ControlKind::kChoice, .greatest = 3, .choices = kComparisons},
    {.name = "difference_gain", .label = "difference times", .least = 1, .greatest = 32, .initial = 4, .step = 1},
    {.name = "albedo", .label = "albedo", .initial = 0.8, .step = 0.05},
    // of single techniques
    {.name = "ambient_light",
     .label = "ambient light",
     .kind = ControlKind::kChoice,
     .greatest = 2,
     .initial = 1,
     .choices = kAmbient},
    {.name = "ambient_brdf",
     .label = "R_A of",
     .kind = ControlKind::kChoice,
     .greatest = 3,
     .initial = 3,
     .choices = kAmbientBrdfs},
    {.name = "viewpoint", .label = "looked up by", .kind = ControlKind::kChoice, .greatest = 1, .choices = kViewpoints},
    {.name = "bump_depth", .label = "bump depth", .greatest = 2, .initial = 1, .step = 0.05},
    {.name = "highlight_strength", .label = "highlight strength", .greatest = 2, .initial = 1, .step = 0.05},
    {.name = "blur_level", .label = "blur, halvings of the picture", .greatest = 8, .initial = 4, .step = 0.1},
    {.name = "shininess", .label = "shininess", .least = 1, .greatest = 512, .initial = 20, .step = 1},
    {.name = "roughness", .label = "roughness", .initial = 0.5, .step = 0.01},
    {.name = "f0", .label = "reflectance at normal incidence", .initial = 1, .step = 0.01},
    {.name = "bands", .label = "bands", .least = 1, .greatest = 6, .initial = 3, .step = 1},
    {.name = "window_kind", .label = "window", .kind = ControlKind::kChoice, .greatest = 3, .choices = kWindows},
    {.name = "window_strength", .label = "window strength", .initial = 0.5, .step = 0.02},
    {.name = "tint_negative",
     .label = "tint negative light",
     .kind = ControlKind::kToggle,
     .greatest = 1,
     .initial = 1},
    {.name = "bump_source", .label = "bumps from", .kind = ControlKind::kChoice, .greatest = 1, .choices = kBumps},
    {.name = "bump_lookup", .label = "looked up in", .kind = ControlKind::kChoice, .greatest = 3, .choices = kLookups},
    {.name = "highlight_source",
     .label = "highlight",
     .kind = ControlKind::kChoice,
     .greatest = 2,
     .choices = kHighlights},
    {.name = "vector_back",
     .label = "the back of a surface",
     .kind = ControlKind::kChoice,
     .greatest = 1,
     .choices = kBacks},
    {.name = "turn_by",
     .label = "light turned by turning",
     .kind = ControlKind::kChoice,
     .greatest = 1,
     .choices = kTurns},
    {.name = "lamp_shape", .label = "lamp", .kind = ControlKind::kChoice, .greatest = 1, .choices = kLampShapes},
    {.name = "lamp_distance",
     .label = "distance of the lamp",
     .least = 2.2,
     .greatest = 8,
     .initial = 2.4,
     .step = 0.1},
    {.name = "lamp_radius", .label = "radius of the lamp", .least = 0.1, .greatest = 1.2, .initial = 1, .step = 0.05},
    {.name = "reflection_by",
     .label = "reflected by",
     .kind = ControlKind::kChoice,
     .greatest = 2,
     .choices = kReflections},
    {.name = "light_set", .label = "light set", .kind = ControlKind::kChoice, .greatest = 10, .choices = kLightSets},
    {.name = "sky_map", .label = "map", .kind = ControlKind::kChoice, .greatest = 1, .choices = kSkyMaps},
    {.name = "sky_weights", .label = "weights", .kind = ControlKind::kChoice, .greatest = 1, .choices = kSkyWeights},
    {.name = "sky_outside",
     .label = "outside of the circle",
     .kind = ControlKind::kChoice,
     .greatest = 2,
     .choices = kSkyOutsides},
    {.name = "sky_form", .label = "read from a", .kind = ControlKind::kChoice, .greatest = 2, .choices = kSkyForms},
    {.name = "sky_ground", .label = "ground", .kind = ControlKind::kChoice, .greatest = 2, .choices = kSkyGrounds},
    {.name = "sky_grey", .label = "grey ground, of the sky's mean", .greatest = 2, .initial = 0.2, .step = 0.05},
    {.name = "light_count", .label = "lights", .least = 0, .greatest = 3, .initial = 3, .step = 1},
};

}  // namespace

std::span<const Control> all_controls() { return kControls; }
std::span<const Control> common_controls() { return all_controls().first(kCommon); }

const Control& control_named(std::string_view name) {
  for (const Control& control : kControls) {
    if (control.name == name) return control;
  }
  check(false, "there is no control of this name");
  return kControls[0];
}

}  // namespace zonal
