#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace zonal {

/// What a technique tries to be: the function of the shaders that computes it from the whole environment.
enum class Exact {
  kDiffuse,     ///< a matte surface: the irradiance map of the exact convolution
  kMirror,      ///< a mirror: the panorama, one lookup a pixel
  kGlossy,      ///< a GGX surface seen from where the eye is: the sum over the panorama's texels (slow)
  kBentMirror,  ///< a mirror bent by a picture of normals
  kLamp,        ///< a lamp nearby, whatever of it is above the horizon, in closed form
  kNine,        ///< nine coefficients as a sum over the basis: light that is known no better
  kSkyMap,      ///< kDiffuse or kPhong, as the control sky_map says
  kPhong,       ///< a Phong lobe about the mirrored direction: the same sum (slow)
};

/// One way to light a surface by an environment: a shader body that defines `vec3 shade(Surface s)`, and the words
/// that go with it.
struct Technique {
  std::string_view id;           ///< on the command line, in a page's address; the stem of its shader body
  std::string_view title;        ///< as a person would call it
  std::string_view group;        ///< the chapter it belongs to
  std::string_view explanation;  ///< one paragraph
  std::string_view formula;      ///< plain text
  std::string_view source;       ///< author, year
  Exact exact = Exact::kDiffuse;
  std::vector<std::string_view> controls = {};  ///< its own, beyond common_controls()
  bool moves = false;                           ///< the picture changes by itself: the uniform time_s is in it
};

std::span<const Technique> all_techniques();
/// nullptr: no such id.
const Technique* technique_named(std::string_view id);

}  // namespace zonal
