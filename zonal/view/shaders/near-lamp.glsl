// A lamp nearby as if all its light came from its middle.
vec3 shade(Surface s) {
  vec3 to_lamp = lamp_center() - in_light(s.position);
  float square = dot(to_lamp, to_lamp), cosine = max(dot(in_light(s.normal), to_lamp), 0.0) * inversesqrt(square);
  float size = pi * lamp_radius * lamp_radius;  // of the ball's disc, the same for the square
  if (lamp_shape == 1) size *= max(dot(light_directions[0], to_lamp) * inversesqrt(square), 0.0);
  return albedo / pi * lamp_radiance() * size / square * cosine;
}
