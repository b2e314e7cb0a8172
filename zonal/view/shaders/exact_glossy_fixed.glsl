vec3 exact(Surface s) { return glossy_sum(s, reflection_roughness); }
