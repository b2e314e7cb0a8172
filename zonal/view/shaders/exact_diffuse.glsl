// The irradiance of the exact convolution, on a matte surface.
vec3 exact(Surface s) { return albedo / pi * cube_toward(irradiance_map, in_light(s.normal), 0.0); }
