// The light gathered into one vector for each channel: E(n) - E(-n) = n.e, taken as E(n) where it is positive.
vec3 shade(Surface s) {
  vec3 n = in_light(s.normal);
  vec3 e = vec3(dot(n, vector_irradiance[0]), dot(n, vector_irradiance[1]), dot(n, vector_irradiance[2]));
  return albedo / pi * max(e, vec3(0.0));
}
