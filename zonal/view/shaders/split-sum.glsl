vec3 shade(Surface s) {
  float nv = clamp(dot(s.normal, s.toward_eye), 0.0, 1.0);
  vec2 dfg = textureLod(dfg_table, vec2(nv, roughness), 0.0).rg;
  return (f0 * dfg.r + dfg.g) * cube_toward(ggx_chain, in_light(toward_mirrored(s)), roughness * (chain_levels - 1.0));
}
