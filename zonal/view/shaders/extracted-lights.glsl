vec3 shade(Surface s) {
  int count = int(light_count + 0.5), first = count * (count - 1) / 2;
  vec3 n = in_light(s.normal), e = pi * light_ambient[count];
  for (int i = 0; i < 3; ++i) {
    if (i < count) e += light_irradiance[first + i] * max(dot(n, light_directions[first + i]), 0.0);
  }
  return albedo / pi * e;
}
