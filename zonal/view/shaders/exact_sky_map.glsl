// What the maps stand for: the irradiance of the whole panorama, or its mean through a Phong lobe.
vec3 exact(Surface s) {
  if (sky_map == 0) return albedo / pi * cube_toward(irradiance_map, in_light(s.normal), 0.0);
  return phong_sum(s);
}
