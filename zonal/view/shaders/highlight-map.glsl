vec3 shade(Surface s) {
  vec3 n = eye_from_world * s.normal;
  vec2 uv = vec2(0.5 + 0.5 * n.x, 0.5 - 0.5 * n.y);
  vec3 highlight;
  if (highlight_source == 0) highlight = textureLod(highlight_map, uv, 0.0).rgb;
  else if (highlight_source == 1) highlight = textureLod(highlight_drawn, uv, 0.0).rgb;
  else highlight = highlight_unit * textureLod(highlight_own, uv, 0.0).rgb;
  return albedo / pi * cube_toward(irradiance_map, in_light(s.normal), 0.0) + highlight_strength * highlight;
}
