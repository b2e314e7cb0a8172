// The map is a photograph of a mirrored ball by a camera that looks along +X. Its normal there is half way between the
// mirrored direction and the direction to the camera.
vec3 ball_with_normal(vec3 n) { return textureLod(sphere_map, vec2(0.5 - 0.5 * n.y, 0.5 - 0.5 * n.z), 0.0).rgb; }
vec3 ball_toward(vec3 d) {
  vec3 half_way = d + vec3(-1.0, 0.0, 0.0);
  return ball_with_normal(half_way / max(length(half_way), 1e-6));
}
