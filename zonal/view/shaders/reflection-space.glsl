// A place of an octahedral square, 0..1: +Z in its middle, +X right of it, +Y below.
vec2 octahedral_uv(vec3 d) {
  vec2 p = d.xy / (abs(d.x) + abs(d.y) + abs(d.z));
  if (d.z < 0.0) p = (1.0 - abs(p.yx)) * vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
  return 0.5 + 0.5 * p;
}

// The mean direction of the lobe as the eye sees it, between the mirrored direction and the normal.
vec3 toward_mean(Surface s) {
  vec2 size = vec2(textureSize(lean_table, 0)), place = vec2(clamp(dot(s.normal, s.toward_eye), 0.0, 1.0), roughness);
  float lean = textureLod(lean_table, (0.5 + place * (size - 1.0)) / size, 0.0).r;
  vec3 r = toward_mirrored(s), across = s.normal - dot(s.normal, r) * r;
  float away = length(across);
  return away > 1e-4 ? cos(lean) * r + sin(lean) / away * across : r;
}

vec3 map_toward(vec2 tile, vec2 place, float layer) {
  vec2 size = vec2(textureSize(reflection_space, 0));
  float px = size.x / reflection_views;
  vec2 texel = tile * px + 0.5 + place * (px - 1.0);
  return textureLod(reflection_space, vec2(texel.x, texel.y + layer * size.x) / size, 0.0).rgb;
}

// What the four maps of a layer whose eyes are around this one, blended, change of the split sum's map.
vec3 change_toward(vec2 eyes, vec2 place, float layer) {
  if (reflection_by == 1) return map_toward(floor(eyes + 0.5), place, layer);
  vec2 first = min(floor(eyes), reflection_views - 2.0), part = eyes - first;
  return mix(mix(map_toward(first, place, layer), map_toward(first + vec2(1.0, 0.0), place, layer), part.x),
             mix(map_toward(first + vec2(0.0, 1.0), place, layer), map_toward(first + vec2(1.0, 1.0), place, layer), part.x),
             part.y);
}

vec3 shade(Surface s) {
  float level = roughness * (chain_levels - 1.0);
  vec3 mean;
  if (reflection_by == 2) {
    mean = cube_toward(ggx_chain, in_light(toward_mirrored(s)), level);
  } else {
    vec3 m = in_light(toward_mean(s));
    vec2 eyes = octahedral_uv(in_light(s.toward_eye)) * (reflection_views - 1.0), place = octahedral_uv(m);
    int rougher = 0;  // the first layer that is as rough as the surface
    while (rougher < 3 && roughness > reflection_roughnesses[rougher]) ++rougher;
    float below = rougher == 0 ? 0.0 : reflection_roughnesses[rougher - 1];
    float part = (roughness - below) / (reflection_roughnesses[rougher] - below);
    vec3 change = change_toward(eyes, place, float(rougher));
    mean = change * cube_toward(reflection_chain, m, float(rougher));
    if (rougher > 0) {
      float before = float(rougher - 1);
      mean = mix(change_toward(eyes, place, before) * cube_toward(reflection_chain, m, before), mean, part);
    } else {  // toward a mirror, of which nothing is changed
      mean = mix(mix(vec3(1.0), change, part) * cube_toward(ggx_chain, m, level), mean, smoothstep(0.7, 1.0, part));
    }
  }
  vec2 dfg = textureLod(dfg_table, vec2(clamp(dot(s.normal, s.toward_eye), 0.0, 1.0), roughness), 0.0).rg;
  return (f0 * dfg.r + dfg.g) * mean;
}
