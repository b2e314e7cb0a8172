// The surface's normal bent by a picture of normals, or by a picture of heights whose slope is taken here.
Surface bent(Surface s, int source) {
  vec2 uv = 4.0 * s.uv;
  vec3 bump = textureLod(bump_map, uv, 0.0).xyz;
  if (source == 0) {
    bump.xy = 2.0 * bump.xy - 1.0;
    bump.z = sqrt(max(1.0 - dot(bump.xy, bump.xy), 0.0));
  } else {
    vec2 texel = 1.0 / vec2(textureSize(bump_map, 0));
    float across = textureLod(bump_map, uv + vec2(texel.x, 0.0), 0.0).z - textureLod(bump_map, uv - vec2(texel.x, 0.0), 0.0).z;
    float down = textureLod(bump_map, uv + vec2(0.0, texel.y), 0.0).z - textureLod(bump_map, uv - vec2(0.0, texel.y), 0.0).z;
    bump = vec3(-bump_height * vec2(across, down) / (2.0 * texel), 1.0);
  }
  bump.xy *= bump_depth;
  s.normal = normalize(tangent_frame(s.position, s.normal, s.uv) * bump);
  return s;
}

vec3 shade(Surface s) {
  vec3 r = in_light(toward_mirrored(bent(s, bump_source)));
  if (bump_lookup == 1) return cube_toward(environment_cube, r, 0.0);
  if (bump_lookup == 2) return paraboloid_toward(r);
  if (bump_lookup == 3) return ball_toward(r);
  return panorama_toward(environment, r);
}
