vec3 shade(Surface s) {
  vec3 direct = albedo / pi * light_irradiance[0] * max(dot(in_light(s.normal), light_directions[0]), 0.0);
  vec3 reflectance = vec3(albedo);
  if (ambient_light == 0) reflectance = vec3(0.0);
  if (ambient_light == 2) {  // a rough GGX surface: its reflectance depends on where the eye is
    vec2 dfg = textureLod(dfg_table, vec2(max(dot(s.normal, s.toward_eye), 0.0), roughness), 0.0).rg;
    reflectance = vec3(f0 * dfg.r + dfg.g);
  }
  return direct + reflectance * light_ambient[1];
}
