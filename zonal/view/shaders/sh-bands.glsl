// Up to six bands, each scaled by the clamped cosine and by a window against ringing.
vec3 shade(Surface s) {
  float y[36];
  sh_basis(in_light(s.normal), y);
  vec3 sum = vec3(0.0);
  for (int l = 0; l < 6; ++l) {
    if (l >= int(bands + 0.5)) break;
    int column = 2 * (window_kind - 1) + l / 3;
    float factor = cosine_factors[l];
    if (window_kind > 0) {
      float row = window_strength * float(textureSize(window_table, 0).y - 1);
      factor *= texelFetch(window_table, ivec2(column, int(row + 0.5)), 0)[l % 3];
    }
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) sum += factor * y[i] * sh[i];
  }
  if (tint_negative != 0 && min(sum.r, min(sum.g, sum.b)) < 0.0) return negative_tint;
  return albedo * sum;
}
