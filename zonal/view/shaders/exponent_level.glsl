// The place of the shininess among those of a chain of maps, from sharp to soft, by its logarithm: between blending for
// the lobe's height (by the exponent) and for its width (by the exponent's inverse), and nearer to it than either.
float exponent_level(float exponents[8], float levels) {
  float level = 0.0;
  for (int i = 0; i + 1 < int(levels); ++i) {
    level += clamp(log(exponents[i] / shininess) / log(exponents[i] / exponents[i + 1]), 0.0, 1.0);
  }
  return level;
}
