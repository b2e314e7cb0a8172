// What a white surface of the chosen kind reflects of light from everywhere, toward the eye: albedo, or f0 for a glossy one.
vec3 ambient_reflectance(Surface s) {
  vec2 size = vec2(textureSize(ambient_table, 0));
  float rows = size.y / ambient_bands;
  float parameter = ambient_brdf == 3 ? roughness : ambient_brdf == 0 ? 0.0 : log(shininess) / log(greatest_shininess);
  float row = float(ambient_brdf) * rows + 0.5 + clamp(parameter, 0.0, 1.0) * (rows - 1.0);
  vec2 share = textureLod(ambient_table, vec2(max(dot(s.normal, s.toward_eye), 0.0), row / size.y), 0.0).rg;
  return vec3((ambient_brdf == 0 ? albedo : f0) * share.r + share.g);
}

vec3 shade(Surface s) {
  vec3 direct = albedo / pi * light_irradiance[0] * max(dot(in_light(s.normal), light_directions[0]), 0.0);
  vec3 reflectance = ambient_light == 0 ? vec3(0.0) : ambient_light == 1 ? vec3(albedo) : ambient_reflectance(s);
  return direct + reflectance * light_ambient[1];
}
