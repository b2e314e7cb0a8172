vec3 shade(Surface s) { return albedo / pi * cube_toward(irradiance_map, in_light(s.normal), 0.0); }
