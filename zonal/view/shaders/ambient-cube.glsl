vec3 shade(Surface s) {
  vec3 n = in_light(s.normal), w = n * n;
  return albedo * (w.x * cube_sides[n.x < 0.0 ? 1 : 0] + w.y * cube_sides[n.y < 0.0 ? 3 : 2] +
                   w.z * cube_sides[n.z < 0.0 ? 5 : 4]);
}
