// The lecture's: E from nine radiance coefficients, order and sign as in its uniform array.
vec3 shade(Surface s) {
  vec3 n = in_light(s.normal);
  float x = n.x, y = n.y, z = n.z;
  float k1 = lecture_constants[0], k2 = lecture_constants[1], k3 = lecture_constants[2], k4 = lecture_constants[3],
        k5 = lecture_constants[4];
  vec3 e = k1 * sh[8] * (x * x - y * y) + k3 * sh[6] * z * z + k4 * sh[0] - k5 * sh[6] +
           2.0 * k1 * (sh[4] * x * y + sh[7] * x * z + sh[5] * y * z) + 2.0 * k2 * (sh[3] * x + sh[1] * y + sh[2] * z);
  return albedo / pi * e;
}
