vec3 shade(Surface s) { return paraboloid_toward(in_light(toward_mirrored(s))); }
