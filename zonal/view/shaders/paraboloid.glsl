// Front and back share a picture: half a texel beside the line between them, so that neither bleeds into the other.
vec3 paraboloid_toward(vec3 d) {
  vec2 uv = 0.5 - 0.5 * d.yz / (1.0 + abs(d.x));
  float edge = 1.0 / float(textureSize(dual_paraboloid, 0).x);
  uv.x = clamp(uv.x, edge, 1.0 - edge);
  return textureLod(dual_paraboloid, vec2(d.x >= 0.0 ? 0.5 * uv.x : 0.5 + 0.5 * uv.x, uv.y), 0.0).rgb;
}
