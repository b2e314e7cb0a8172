// Between the two levels whose exponents enclose the shininess, by its logarithm.
vec3 shade(Surface s) {
  float level = 0.0;
  for (int i = 0; i + 1 < int(phong_levels); ++i) {
    float sharp = log(phong_exponents[i]), soft = log(phong_exponents[i + 1]);
    level += clamp((sharp - log(shininess)) / (sharp - soft), 0.0, 1.0);
  }
  return cube_toward(phong_chain, in_light(toward_mirrored(s)), level);
}
