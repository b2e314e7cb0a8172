// The light gathered into one vector for each channel: E(n) - E(-n) = n.e, exactly. As published, nothing reaches the
// back and it is E(n); or both sides share what the mean of the light brings them, E(n) + E(-n) = 2 pi mean.
vec3 shade(Surface s) {
  vec3 n = in_light(s.normal);
  vec3 e = vec3(dot(n, vector_irradiance[0]), dot(n, vector_irradiance[1]), dot(n, vector_irradiance[2]));
  return albedo / pi * (vector_back == 0 ? max(e, vec3(0.0)) : pi * mean_radiance + 0.5 * e);
}
