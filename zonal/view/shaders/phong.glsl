vec3 shade(Surface s) {
  return cube_toward(phong_chain, in_light(toward_mirrored(s)), exponent_level(phong_exponents, phong_levels));
}
