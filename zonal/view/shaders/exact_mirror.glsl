// The panorama itself.
vec3 exact(Surface s) { return panorama_toward(environment, in_light(toward_mirrored(s))); }
