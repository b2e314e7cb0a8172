vec3 shade(Surface s) {
  vec3 r = in_light(toward_mirrored(s));
  vec2 uv = 0.5 - 0.5 * r.yz / (1.0 + abs(r.x));
  return textureLod(dual_paraboloid, vec2(r.x >= 0.0 ? 0.5 * uv.x : 0.5 + 0.5 * uv.x, uv.y), 0.0).rgb;
}
