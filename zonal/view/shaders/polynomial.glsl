// Ramamoorthi and Hanrahan 2001, eq. 13.
vec3 polynomial_irradiance(vec3 c00, vec3 c1m1, vec3 c10, vec3 c11, vec3 c2m2, vec3 c2m1, vec3 c20, vec3 c21, vec3 c22, vec3 n) {
  float k1 = lecture_constants[0], k2 = lecture_constants[1], k3 = lecture_constants[2], k4 = lecture_constants[3],
        k5 = lecture_constants[4];
  return k1 * c22 * (n.x * n.x - n.y * n.y) + k3 * c20 * n.z * n.z + k4 * c00 - k5 * c20 +
         2.0 * k1 * (c2m2 * n.x * n.y + c21 * n.x * n.z + c2m1 * n.y * n.z) +
         2.0 * k2 * (c11 * n.x + c1m1 * n.y + c10 * n.z);
}
