// The panorama itself, mirrored where the picture of normals bends the surface.
vec3 exact(Surface s) { return panorama_toward(environment, in_light(toward_mirrored(bent(s, 0)))); }
