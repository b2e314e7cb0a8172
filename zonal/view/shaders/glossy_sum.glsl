// The sum over a small panorama's texels: GGX with Smith's height-correlated masking and Schlick's Fresnel term, with
// the eye where it is.
vec3 glossy_sum(Surface s, float perceptual) {
  vec3 n = in_light(s.normal), v = in_light(s.toward_eye);
  float alpha = max(perceptual * perceptual, 0.05), a2 = alpha * alpha;
  float nv = max(dot(n, v), 1e-4);
  ivec2 size = textureSize(environment_small, 0);
  float step_phi = 2.0 * pi / float(size.x);
  vec3 sum = vec3(0.0);
  for (int y = 0; y < size.y; ++y) {
    float top = pi * float(y) / float(size.y), bottom = pi * float(y + 1) / float(size.y);
    float area = step_phi * (cos(top) - cos(bottom)), theta = 0.5 * (top + bottom);
    for (int x = 0; x < size.x; ++x) {
      float phi = pi - step_phi * (float(x) + 0.5);
      vec3 l = vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
      float nl = dot(n, l);
      if (nl <= 0.0) continue;
      vec3 h = normalize(l + v);
      float nh = dot(n, h), d = nh * nh * (a2 - 1.0) + 1.0;
      float visibility = 0.5 / (nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2));
      float fresnel = f0 + (1.0 - f0) * pow(clamp(1.0 - dot(v, h), 0.0, 1.0), 5.0);
      sum += a2 / (pi * d * d) * visibility * fresnel * nl * area * texelFetch(environment_small, ivec2(x, y), 0).rgb;
    }
  }
  return sum;
}
