vec3 shade(Surface s) {
  vec3 n = eye_from_world * s.normal;
  vec2 uv = vec2(0.5 + 0.5 * n.x, 0.5 - 0.5 * n.y);
  vec3 highlight = highlight_source == 0 ? textureLod(highlight_map, uv, 0.0).rgb : textureLod(highlight_drawn, uv, 0.0).rgb;
  return albedo / pi * cube_toward(irradiance_map, in_light(s.normal), 0.0) + highlight_strength * highlight;
}
