// The lecture's: E from nine radiance coefficients, order and sign as in its uniform array.
vec3 shade(Surface s) {
  return albedo / pi * tinted(polynomial_irradiance(sh[0], sh[1], sh[2], sh[3], sh[4], sh[5], sh[6], sh[7], sh[8], in_light(s.normal)));
}
