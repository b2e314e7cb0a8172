vec3 shade(Surface s) { return cube_toward(environment_cube, in_light(toward_mirrored(s)), 0.0); }
