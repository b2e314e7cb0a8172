// A ball cut by the horizon (Snyder 1996), over its radiance. `away` is the angle between its middle and the normal.
float ball_irradiance(float half_angle, float away) {
  float sine = sin(half_angle), cosine = cos(half_angle), height = cos(away);
  if (away + half_angle <= 0.5 * pi) return pi * height * sine * sine;
  if (away >= 0.5 * pi + half_angle) return 0.0;
  float g = asin(clamp(cosine / sin(away), -1.0, 1.0)), cg = cos(g);
  float a = 0.5 * pi - g + cg * (sin(g) - 2.0 * sin(away) * cosine);
  float b = height * (cg * sqrt(max(sine * sine - cg * cg, 0.0)) + sine * sine * asin(clamp(cg / sine, -1.0, 1.0)));
  return max(away <= 0.5 * pi ? pi * height * sine * sine + a - b : a + b, 0.0);
}

float edge_of(vec3 from, vec3 to, vec3 n) {
  vec3 across = cross(from, to);
  float size = length(across);
  return size > 0.0 ? atan(size, dot(from, to)) * dot(across, n) / size : 0.0;
}

// A square that faces the object's middle, cut by the horizon: the sum over its edges (Lambert 1760), over its radiance.
float square_irradiance(vec3 center, vec3 n) {
  vec3 axis = normalize(light_directions[0]);
  vec3 side = normalize(cross(abs(axis.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0), axis));
  float half_width = 0.5 * sqrt(pi) * lamp_radius;
  vec3 across = half_width * side, along = half_width * cross(axis, side);
  vec3 rising = vec3(0.0), falling = vec3(0.0);
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec3 a = center + (i == 0 || i == 3 ? -1.0 : 1.0) * across + (i < 2 ? -1.0 : 1.0) * along;
    vec3 b = center + (i < 2 ? 1.0 : -1.0) * across + (i == 0 || i == 3 ? -1.0 : 1.0) * along;
    float above_a = dot(a, n), above_b = dot(b, n);
    if (above_a <= 0.0 && above_b <= 0.0) continue;
    vec3 horizon = mix(a, b, clamp(above_a / (above_a - above_b), 0.0, 1.0));
    if (above_a <= 0.0) rising = horizon;
    if (above_b <= 0.0) falling = horizon;
    sum += edge_of(above_a <= 0.0 ? horizon : a, above_b <= 0.0 ? horizon : b, n);
  }
  return 0.5 * abs(sum + edge_of(falling, rising, n));
}

vec3 exact(Surface s) {
  vec3 n = in_light(s.normal), to_lamp = lamp_center() - in_light(s.position);
  float away = length(to_lamp);
  float e = lamp_shape == 0 ? ball_irradiance(asin(min(lamp_radius / away, 1.0)), acos(clamp(dot(n, to_lamp) / away, -1.0, 1.0)))
                            : square_irradiance(to_lamp, n);
  return albedo / pi * lamp_radiance() * e;
}
