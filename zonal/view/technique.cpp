#include "zonal/view/technique.h"

namespace zonal {
namespace {

constexpr std::string_view kConstant = "Light without direction";
constexpr std::string_view kMirrors = "Environment mapping";
constexpr std::string_view kFiltered = "Filtered environment maps";
constexpr std::string_view kMatte = "Irradiance";
constexpr std::string_view kHarmonics = "Spherical harmonics";

const std::vector<Technique>& techniques() {
  static const std::vector<Technique> list = {
      {.id = "lambert",
       .title = "One light and an ambient constant",
       .group = kConstant,
       .explanation =
           "Where lighting by the environment starts: the brightest light of the panorama as one "
           "directional light, and "
           "all the rest as a constant that comes from everywhere. Without the constant, what faces away "
           "from the light "
           "is black, as it never is in a real place. A matte surface sends the same part of the constant to "
           "every eye, its albedo; of other surfaces the part R_A(v) depends on where the eye is. It is "
           "known exactly for four BRDFs: a table over n·v and the exponent or roughness.",
       .formula = "L = albedo/π E_L max(n·l, 0) + R_A(v) L_A,  R_A(v) = ∫ f(l, v) n·l dω",
       .source = "Lambert 1760",
       .exact = Exact::kDiffuse,
       .controls = {"ambient_light", "ambient_brdf", "roughness", "shininess", "f0"}},
      {.id = "blinn-newell",
       .title = "Panorama (Blinn and Newell)",
       .group = kMirrors,
       .explanation =
           "The mirrored direction in polar coordinates is the place in a panorama. Looked up per pixel and without "
           "derivatives there is no seam where the longitude jumps; per vertex, as first published, triangles across "
           "the seam would show the whole picture backwards.",
       .formula = "r = 2(n·v)n − v,  u = ½ − atan2(r_y, r_x)/2π,  v = acos(r_z)/π",
       .source = "Blinn & Newell 1976",
       .exact = Exact::kMirror},
      {.id = "sphere-map",
       .title = "Sphere map",
       .group = kMirrors,
       .explanation =
           "A photograph of a mirrored ball. With the eye's normal as texture coordinates the picture sticks to the "
           "eye: it is right from one viewpoint only. Looked up by the half vector of the mirrored direction and the "
           "direction to the camera that took it, it is right from everywhere but for its rim, where a pixel is "
           "degrees wide.",
       .formula = "m = √(r_x² + r_y² + (r_z + 1)²),  u = r_x/2m + ½,  v = r_y/2m + ½",
       .source = "Miller & Hoffman 1984; GL_SPHERE_MAP",
       .exact = Exact::kMirror,
       .controls = {"viewpoint"}},
      {.id = "cube-map",
       .title = "Cube map",
       .group = kMirrors,
       .explanation =
           "Six pictures on the faces of a cube: the largest component of the mirrored direction chooses the "
           "face, the other two are the place on it. No pole, no seam, little distortion.",
       .formula = "face = argmax |r|,  (u, v) = ½ + ½ r⊥/|r_max|",
       .source = "Greene 1986",
       .exact = Exact::kMirror},
      {.id = "dual-paraboloid",
       .title = "Dual paraboloid map",
       .group = kMirrors,
       .explanation =
           "Two discs, each a hemisphere seen in a parabolic mirror. The lookup is one division, and the map "
           "does not depend on the viewpoint.",
       .formula = "(u, v) = ½ + ½ (r_x, r_y)/(1 + |r_z|)",
       .source = "Heidrich & Seidel 1998",
       .exact = Exact::kMirror},
      {.id = "bump",
       .title = "Environment-mapped bump mapping",
       .group = kMirrors,
       .explanation =
           "A picture bends the surface's normal before the light is mirrored at it: a picture of normals as "
           "they are, or of heights whose slope is taken per pixel. Any map can be looked up. The exact answer "
           "beside it has the normals and the panorama, so the difference is what the other choices lose.",
       .formula = "n' = T (2 texel − 1)  or  n' = T (−∂h/∂u, −∂h/∂v, 1),  r = 2(n'·v)n' − v",
       .source = "Blinn 1978",
       .exact = Exact::kBentMirror,
       .controls = {"bump_source", "bump_lookup", "bump_depth"}},
      {.id = "uniform-blur",
       .title = "Panorama blurred evenly",
       .group = kFiltered,
       .explanation = "The picture itself made smaller and smaller. The blur is even in the picture but not on the "
                      "sphere: too wide near the poles, and no shape of any surface. The eye forgives much of it.",
       .formula = "texel of level k = mean of 4^k texels",
       .source = "Williams 1983",
       .exact = Exact::kPhong,
       .controls = {"blur_level", "shininess"}},
      {.id = "phong",
       .title = "Glossy: Phong's lobe",
       .group = kFiltered,
       .explanation =
           "The panorama convolved with a power of the cosine about the mirrored direction, once for each of "
           "some shininesses. Between them the lookup interpolates.",
       .formula = "L = (s+1)/2π ∫ L_i max(l·r, 0)^s dω",
       .source = "Phong 1975; Miller & Hoffman 1984",
       .exact = Exact::kPhong,
       .controls = {"shininess"}},
      {.id = "split-sum",
       .title = "Glossy: GGX, split sum",
       .group = kFiltered,
       .explanation = "The lobe of a rough surface seen along its normal (n = v = r) filters the panorama; a small "
                      "table puts back how much the surface reflects at this angle. What it loses shows at grazing "
                      "angles, where a real highlight is stretched.",
       .formula = "L = (f0 A(n·v, α) + B(n·v, α)) ∫ L_i k_α(l·r) dω",
       .source = "Karis 2013",
       .exact = Exact::kGlossy,
       .controls = {"roughness", "f0"}},
      {.id = "reflection-space",
       .title = "Glossy: GGX, maps of reflection space",
       .group = kFiltered,
       .explanation =
           "The panorama filtered by the lobe as an eye sees it, leaning and stretched toward grazing angles, "
           "once for each of some directions of the eye and for each of four roughnesses. A pixel looks up the "
           "mean direction of its own lobe in the four maps whose eyes are around it, which warps them to its "
           "eye, and blends them. The maps hold only what they change of the split sum's, which takes every "
           "lobe as seen from above (n = v = r) and is here to compare with: so they can be small. For a sun on a "
           "smooth surface, below roughness 0.4, they are too small and gain nothing.",
       .formula = "L = (f0 A + B) M(m) Σ_k w_k(v) M_k(m)/M(m),  M_k = ∫ L_i D V n·l dω / ∫ D V n·l dω with mean "
                  "direction m for v_k",
       .source = "Cabral, Olano & Nemec 1999",
       .exact = Exact::kGlossy,
       .controls = {"reflection_by", "roughness", "f0"}},
      {.id = "irradiance-map",
       .title = "Irradiance map",
       .group = kMatte,
       .explanation = "For every normal the cosine-weighted sum over the whole panorama, by exact convolution. This is "
                      "the exact answer for matte surfaces; what is left is the interpolation between its texels.",
       .formula = "E(n) = ∫ L_i max(n·l, 0) dω",
       .source = "Miller & Hoffman 1984",
       .exact = Exact::kDiffuse},
      {.id = "fisheye-maps",
       .title = "Irradiance maps of a fisheye photograph",
       .group = kMatte,
       .explanation =
           "The upper half of the light as a fisheye photograph of the sky, the zenith in its middle, and the maps "
           "that a "
           "published program makes of it: for each direction the mean under a power of the cosine, over the square "
           "around the photograph's circle, whose corners have the colour of the ground. Two things differ from the "
           "integral: a pixel is weighed by the angle between it and the direction where its own zenith angle is "
           "meant, "
           "and the corners are a fifth of the lower half only. Outside of the map's circle the ground begins at once, "
           "unless the map goes on or a second one holds the rest. Corrected, what is left is that all of the ground "
           "has "
           "one colour.",
       .formula = "M(q) = Σ L max(p·q, 0)^s sinc(a) / Σ max(p·q, 0)^s sinc(a),  a = acos(p·q);  "
                  "corrected (s+1)/2π ∫ L max(p·q, 0)^s dω",
       .source = "Tokoi 2015, Irradiance mapping (2)",
       .exact = Exact::kSkyMap,
       .controls = {"sky_map", "sky_weights", "sky_outside", "sky_form", "shininess", "sky_ground", "sky_grey"}},
      {.id = "vector-irradiance",
       .title = "Vector irradiance",
       .group = kMatte,
       .explanation = "All light gathered into one vector for each colour. The difference of the irradiance on the two "
                      "sides of a surface is exactly its product with the normal; taken as the irradiance itself it "
                      "misses what reaches the back, most of the light of most places. With the mean of the light for "
                      "both sides it is the first two bands of spherical harmonics.",
       .formula = "e = ∫ L_i l dω,  E(n) − E(−n) = n·e;  E ≈ max(n·e, 0)  or  E ≈ π L̄ + n·e/2",
       .source = "Gershun 1939; Arvo 1994",
       .exact = Exact::kDiffuse,
       .controls = {"vector_back"}},
      {.id = "near-lamp",
       .title = "Area light nearby",
       .group = kMatte,
       .explanation =
           "A large lamp as if all its light came from its middle: exact for a ball as long as all of it is "
           "above the surface's horizon, a good guess for a small square. Where the horizon cuts the lamp the "
           "guess is too bright on one side of the edge of light and black on the other, where light still "
           "falls. The lamp stands where the brightest light of the panorama is and is as bright at the "
           "object's middle, however large; the exact answer cuts it at the horizon in closed form.",
       .formula = "E ≈ E_L max(n·l, 0),  E_L = π r²/d² L (ball),  A cos θ_L/d² L (square)",
       .source = "Lambert 1760; Snyder 1996",
       .exact = Exact::kLamp,
       .controls = {"lamp_shape", "lamp_distance", "lamp_radius"}},
      {.id = "highlight-map",
       .title = "Highlight map",
       .group = kMatte,
       .explanation =
           "A highlight of any shape, computed, drawn or your own, as a sphere map in the eye's frame, added to "
           "the matte light. It costs one lookup and can be anything, which is its charm and its flaw: paint "
           "one, and the object wears it wherever it turns.",
       .formula = "L = albedo/π E(n) + H(½ + ½ n_x, ½ + ½ n_y)",
       .source = "lecture, highlight mapping",
       .exact = Exact::kDiffuse,
       .controls = {"highlight_source", "highlight_strength"}},
      {.id = "sh-bands",
       .title = "Spherical harmonics, 1 to 6 bands",
       .group = kHarmonics,
       .explanation =
           "The light as 1, 4, 9, ... 36 coefficients, scaled by the cosine's factor in each band. Three "
           "bands keep 99 % of the irradiance of most places; a strong sun makes them ring below zero, which "
           "is tinted here, and a window takes the ringing out.",
       .formula = "E/π = Σ_l A_l w_l Σ_m L_lm y_lm(n)",
       .source = "Ramamoorthi & Hanrahan 2001; Sloan 2008",
       .exact = Exact::kDiffuse,
       .controls = {"bands", "window_kind", "window_strength", "tint_negative", "turn_by"}},
      {.id = "sh-polynomial",
       .title = "Nine coefficients as a polynomial (the homework)",
       .group = kHarmonics,
       .explanation =
           "Three bands written out as a polynomial of the normal with five constants: what the lecture asks "
           "its students to put into the vertex shader.",
       .formula = "E = k1 c22 (x² − y²) + k3 c20 z² + k4 c00 − k5 c20 + 2k1(...) + 2k2(...)",
       .source = "Ramamoorthi & Hanrahan 2001, eq. 13",
       .exact = Exact::kDiffuse,
       .controls = {"tint_negative"}},
      {.id = "homework",
       .title = "The homework's ten light sets",
       .group = kHarmonics,
       .explanation =
           "The published coefficients of ten places, a second each, by the polynomial that the students "
           "write. Of these places nothing is known but nine coefficients, so the exact answer is the sum over "
           "the basis: the polynomial is the same function. The panorama behind the object is not its light; "
           "the sets are scaled to be as bright.",
       .formula = "I = albedo/π E(n) f_scale",
       .source = "Tokoi, ggsample10; Rost 2006, chapter 12",
       .exact = Exact::kNine,
       .controls = {"light_set", "tint_negative"},
       .moves = true},
      {.id = "sh-constants",
       .title = "Nine coefficients as seven vectors",
       .group = kHarmonics,
       .explanation = "The same three bands, premultiplied so that a shader needs seven vectors of four and a few dot "
                      "products.",
       .formula = "E/π = cA·(n, 1) + cB·(xy, yz, zz, zx) + cC (x² − y²)",
       .source = "Sloan 2008, appendix A10",
       .exact = Exact::kDiffuse,
       .controls = {"tint_negative"}},
      {.id = "extracted-lights",
       .title = "Extracted lights",
       .group = kHarmonics,
       .explanation = "The probe taken apart into a constant and up to three directional lights by least squares, for "
                      "renderers that know only lights. An arrow in the light's hue shows where each comes from; its "
                      "area grows with the light's irradiance. Rings mark them in the sky.",
       .formula = "E = π a + Σ_i E_i max(n·l_i, 0)",
       .source = "Sloan 2008, appendix A5",
       .exact = Exact::kDiffuse,
       .controls = {"light_count"}},
      {.id = "ambient-cube",
       .title = "Ambient cube",
       .group = kHarmonics,
       .explanation =
           "Six colours, one for each side of the world, blended by the squares of the normal. Cheap, and "
           "never negative where they are not. It has no place for light that changes between two axes (xy, yz "
           "and zx): of a low sun there a seventh of the irradiance is wrong, and it wobbles when the light "
           "turns.",
       .formula = "E/π = Σ n_i² c_i,sign(n_i)",
       .source = "McTaggart 2004; Sloan 2008, appendix A9",
       .exact = Exact::kDiffuse},
  };
  return list;
}

}  // namespace

std::span<const Technique> all_techniques() { return techniques(); }

const Technique* technique_named(std::string_view id) {
  for (const Technique& technique : all_techniques()) {
    if (technique.id == id) return &technique;
  }
  return nullptr;
}

}  // namespace zonal
