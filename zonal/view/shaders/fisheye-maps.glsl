vec3 ground_radiance() {
  return sky_ground == 0 ? ground_mean : sky_ground == 1 ? vec3(0.0) : vec3(sky_grey * luminance(sky_mean));
}

// Texel t of a paraboloid map, with the ground beside the map and, if so published, outside of its circle. Of two maps,
// which meet at the circles, the edges go on. The published map's outermost texels were computed as if their centres lay
// on its edge: its circle is a texel smaller.
vec3 sky_texel(ivec2 t, int size, bool lower, int level, vec3 ground) {
  if (sky_outside == 2) t = clamp(t, ivec2(0), ivec2(size - 1));
  if (min(t.x, t.y) < 0 || max(t.x, t.y) >= size) return ground;
  ivec2 from_center = 2 * t - (size - 1);
  int diameter = sky_weights == 0 ? size - 1 : size, square = from_center.x * from_center.x + from_center.y * from_center.y;
  if (sky_outside == 0 && square >= diameter * diameter) return ground;
  ivec2 quarter = min(t, size - 1 - t) + ivec2(lower ? size / 2 : 0, level * size / 2);
  vec2 shares = texelFetch(sky_shares, quarter, 0).rg;
  vec3 sky = texelFetch(sky_maps, t + ivec2(lower ? size : 0, (2 * level + sky_weights) * size), 0).rgb;
  return sky + (sky_weights == 0 ? shares.r : shares.g) * ground;
}

// As the program reads its map: linear between texels, the ground as the colour of the border.
vec3 sky_paraboloid(vec3 d, int size, int level, vec3 ground) {
  bool lower = sky_outside == 2 && d.z < 0.0;
  float scale = 2.0 * (1.0 + (lower ? -d.z : d.z));
  if (scale < 1e-6) return ground;  // the nadir lies infinitely far outside
  float edge = float(size);
  vec2 place = clamp(vec2(d.y, -d.x) / scale * edge + 0.5 * edge - 0.5, vec2(-2.0), vec2(edge + 1.0)), part = fract(place);
  ivec2 t = ivec2(floor(place));
  return mix(mix(sky_texel(t, size, lower, level, ground), sky_texel(t + ivec2(1, 0), size, lower, level, ground), part.x),
             mix(sky_texel(t + ivec2(0, 1), size, lower, level, ground),
                 sky_texel(t + ivec2(1, 1), size, lower, level, ground), part.x), part.y);
}

vec3 toward_on_panorama(vec2 uv) {
  float theta = pi * uv.y, phi = pi - 2.0 * pi * uv.x;
  return vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
}

// A cube's face by its axis: the other two components over the one of the axis.
int cube_axis(vec3 d) {
  vec3 a = abs(d);
  return a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
}
vec2 on_face(vec3 d, int axis) {
  return axis == 0 ? d.yz / abs(d.x) : axis == 1 ? d.zx / abs(d.y) : d.xy / abs(d.z);
}
vec3 toward_on_face(vec2 p, int axis, float side) {
  return axis == 0 ? vec3(side, p) : axis == 1 ? vec3(p.y, side, p.x) : vec3(p, side);
}

// The centre of the texel of a cube map that holds a direction.
vec3 toward_cube_texel(vec3 d, float edge) {
  int axis = cube_axis(d);
  vec2 texel = clamp(floor(0.5 * edge * (on_face(d, axis) + 1.0)), 0.0, edge - 1.0);
  return normalize(toward_on_face(2.0 * (texel + 0.5) / edge - 1.0, axis, d[axis] < 0.0 ? -1.0 : 1.0));
}

// The map itself, or one that was read out of it: a panorama of as many rows, a cube with faces of half as many texels.
// Software renderers work on both sides of a branch and once more on a loop that tests first: these test last.
vec3 sky_mean_toward(vec3 d, int size, int level, vec3 ground) {
  int axis = cube_axis(d), reads = sky_form == 0 ? 1 : 4, i = 0;
  float edge = 0.5 * float(size);
  vec2 texels = sky_form == 1 ? vec2(2 * size, size) : vec2(edge);
  vec2 place = (sky_form == 1 ? equirect_uv(d) : 0.5 + 0.5 * on_face(d, axis)) * texels - 0.5, part = fract(place);
  vec3 sum = vec3(0.0);
  do {
    vec2 corner = vec2(i & 1, i >> 1), uv = (floor(place) + corner + 0.5) / texels, weights = mix(1.0 - part, part, corner);
    vec3 toward = sky_form == 0 ? d : sky_form == 1 ? toward_on_panorama(uv)
                                : toward_cube_texel(toward_on_face(2.0 * uv - 1.0, axis, d[axis] < 0.0 ? -1.0 : 1.0), edge);
    sum += (sky_form == 0 ? 1.0 : weights.x * weights.y) * sky_paraboloid(toward, size, level, ground);
  } while (++i < reads);
  return sum;
}

vec3 shade(Surface s) {
  vec3 d = in_light(sky_map == 0 ? s.normal : toward_mirrored(s)), ground = ground_radiance(), sum = vec3(0.0);
  int size = textureSize(sky_maps, 0).x / 2;
  float level = sky_map == 0 ? sky_levels - 1.0 : exponent_level(sky_exponents, sky_levels);
  int i = int(level), last = level > float(i) ? i + 1 : i;
  do sum += (1.0 - abs(level - float(i))) * sky_mean_toward(d, size, i, ground); while (++i <= last);
  return (sky_map == 0 ? albedo : 1.0) * sum;
}
