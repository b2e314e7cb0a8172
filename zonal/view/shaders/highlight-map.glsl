vec3 shade(Surface s) {
  vec3 n = eye_from_world * s.normal;
  vec3 highlight = textureLod(highlight_map, vec2(0.5 + 0.5 * n.x, 0.5 - 0.5 * n.y), 0.0).rgb;
  return albedo / pi * cube_toward(irradiance_map, in_light(s.normal), 0.0) + highlight_strength * highlight;
}
