vec3 shade(Surface s) { return textureLod(environment_mips, equirect_uv(in_light(toward_mirrored(s))), blur_level).rgb; }
