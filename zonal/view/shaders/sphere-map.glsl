vec3 shade(Surface s) {
  if (viewpoint == 1) return ball_toward(in_light(toward_mirrored(s)));
  vec3 n = eye_from_world * s.normal;  // the lecture's: the map moves with the eye and is wrong from everywhere else
  return ball_with_normal(vec3(-n.z, -n.x, n.y));
}
