// Linear light to what a screen wants: the library's tone curve (image/tonemap.h), or the light cut off at white.

vec3 srgb(vec3 c) { return mix(12.92 * c, 1.055 * pow(max(c, vec3(0.0)), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }

// Moves a colour toward the grey of its luminance until no channel exceeds 1, so that hues stay.
vec3 fit_display(vec3 c) {
  float grey = min(1.0, luminance(c)), highest = max(c.r, max(c.g, c.b));
  if (highest <= 1.0) return c;
  float keep = highest > grey ? (1.0 - grey) / (highest - grey) : 0.0;
  return vec3(grey) + keep * (c - grey);
}

vec3 displayed(vec3 radiance) {
  vec3 c = exp2(exposure_ev) * max(radiance, vec3(0.0));
  float light = luminance(c);
  if (tone_curve == 0 && light > 0.0) {
    c *= min(1.0, light * (1.0 + light / (tone_white * tone_white)) / (1.0 + light)) / light;
  }
  return srgb(fit_display(c));
}

// A line of two pixels where the picture turns from the technique to the exact answer. A small picture is a coarse one, to
// be shown enlarged: there it would be a bar.
vec3 marked_split(vec3 color) {
  if (compare != 3 || split_px < 75.0) return color;
  float away = abs(gl_FragCoord.x - split_px);
  return away < 1.0 ? vec3(1.0) : away < 2.0 ? vec3(0.0) : color;
}
