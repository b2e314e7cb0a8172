vec3 shade(Surface s) {
  vec3 n = in_light(s.normal);
  vec4 n1 = vec4(n, 1.0), quadratic = vec4(n.x * n.y, n.y * n.z, n.z * n.z, n.z * n.x);
  vec3 over_pi = (n.x * n.x - n.y * n.y) * shading_constants[6].rgb;
  for (int c = 0; c < 3; ++c) over_pi[c] += dot(shading_constants[c], n1) + dot(shading_constants[3 + c], quadratic);
  return albedo * tinted(over_pi);
}
