// The place of the shininess among those of a chain of maps, from sharp to soft. The two lobes around it are blended so
// that their sum is as high as the lobe itself: by the exponent and not by its logarithm.
float exponent_level(float exponents[8], float levels) {
  float level = 0.0;
  for (int i = 0; i + 1 < int(levels); ++i) {
    level += clamp((exponents[i] - shininess) / (exponents[i] - exponents[i + 1]), 0.0, 1.0);
  }
  return level;
}
