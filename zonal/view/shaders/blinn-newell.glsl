vec3 shade(Surface s) { return panorama_toward(environment, in_light(toward_mirrored(s))); }
