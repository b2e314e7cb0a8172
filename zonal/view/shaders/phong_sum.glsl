// The sum over a small panorama's texels: a Phong lobe about the mirrored direction.
vec3 phong_sum(Surface s) {
  vec3 r = in_light(toward_mirrored(s));
  ivec2 size = textureSize(environment_small, 0);
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int y = 0; y < size.y; ++y) {
    float top = pi * float(y) / float(size.y), bottom = pi * float(y + 1) / float(size.y);
    float area = cos(top) - cos(bottom), theta = 0.5 * (top + bottom);
    for (int x = 0; x < size.x; ++x) {
      float phi = pi - 2.0 * pi * (float(x) + 0.5) / float(size.x);
      vec3 l = vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
      float weight = area * pow(max(dot(l, r), 0.0), shininess);
      sum += weight * texelFetch(environment_small, ivec2(x, y), 0).rgb;
      weights += weight;
    }
  }
  return sum / weights;
}
