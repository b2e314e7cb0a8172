// The map is a photograph of a mirrored ball by a camera that looks along +X. Its normal there is half way between the
// mirrored direction and the direction to the camera.
vec3 shade(Surface s) {
  vec3 n;
  if (viewpoint == 0) {
    n = eye_from_world * s.normal;  // the lecture's: the map moves with the eye and is wrong from everywhere else
    n = vec3(-n.z, -n.x, n.y);
  } else {
    n = normalize(in_light(toward_mirrored(s)) + vec3(-1.0, 0.0, 0.0));
  }
  return textureLod(sphere_map, vec2(0.5 - 0.5 * n.y, 0.5 - 0.5 * n.z), 0.0).rgb;
}
