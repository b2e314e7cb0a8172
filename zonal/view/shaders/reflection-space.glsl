// A place of an octahedral square, 0..1: +Z in its middle, +X right of it, +Y below.
vec2 octahedral_uv(vec3 d) {
  vec2 p = d.xy / (abs(d.x) + abs(d.y) + abs(d.z));
  if (d.z < 0.0) p = (1.0 - abs(p.yx)) * vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
  return 0.5 + 0.5 * p;
}

vec3 map_toward(vec2 tile, vec2 place) {
  float px = float(textureSize(reflection_space, 0).x) / reflection_views;
  return textureLod(reflection_space, (tile * px + 0.5 + place * (px - 1.0)) / (px * reflection_views), 0.0).rgb;
}

// The four maps whose eyes are around this one, each looked up by the mirrored direction and blended.
vec3 shade(Surface s) {
  vec3 r = in_light(toward_mirrored(s));
  vec3 mean;
  if (reflection_by == 2) {
    mean = cube_toward(ggx_chain, r, reflection_roughness * (chain_levels - 1.0));
  } else {
    vec2 eyes = octahedral_uv(in_light(s.toward_eye)) * (reflection_views - 1.0), place = octahedral_uv(r);
    if (reflection_by == 1) {
      mean = map_toward(floor(eyes + 0.5), place);
    } else {
      vec2 first = min(floor(eyes), reflection_views - 2.0), part = eyes - first;
      mean = mix(mix(map_toward(first, place), map_toward(first + vec2(1.0, 0.0), place), part.x),
                 mix(map_toward(first + vec2(0.0, 1.0), place), map_toward(first + vec2(1.0, 1.0), place), part.x),
                 part.y);
    }
  }
  vec2 dfg = textureLod(dfg_table, vec2(clamp(dot(s.normal, s.toward_eye), 0.0, 1.0), reflection_roughness), 0.0).rg;
  return (f0 * dfg.r + dfg.g) * mean;
}
