vec3 shade(Surface s) {
  vec3 bump = 2.0 * texture(normal_map, 4.0 * s.uv).xyz - 1.0;
  bump.xy *= bump_depth;
  s.normal = normalize(tangent_frame(s.position, s.normal, s.uv) * bump);
  return panorama_toward(environment, in_light(toward_mirrored(s)));
}
