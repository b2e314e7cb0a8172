// Up to six bands, each scaled by the clamped cosine and by a window against ringing. The light is turned by turning the
// normal the other way, or by turning its coefficients: the same picture.
vec3 shade(Surface s) {
  int row = int(window_strength * float(textureSize(window_table, 0).y - 1) + 0.5), column = 2 * max(window_kind - 1, 0);
  vec3 low = texelFetch(window_table, ivec2(column, row), 0).rgb, high = texelFetch(window_table, ivec2(column + 1, row), 0).rgb;
  float weights[6];
  for (int l = 0; l < 6; ++l) {
    float window = window_kind == 0 ? 1.0 : l < 3 ? low[l] : high[l - 3];
    weights[l] = float(l) + 0.5 < bands ? cosine_factors[l] * window : 0.0;
  }
  return albedo * tinted(sh_sum(turn_by == 0 ? in_light(s.normal) : s.normal, weights));
}
