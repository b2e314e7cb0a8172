// What every technique is given, and the lookups that they share. World: right-handed, +Z up. Texture coordinates (0, 0)
// are the top left corner of a picture, as its first texel in memory.

struct Surface {
  vec3 position;
  vec3 normal;      // unit
  vec3 toward_eye;  // unit
  vec2 uv;
};

const float pi = 3.14159265358979;

float luminance(vec3 c) { return dot(c, luminance_weights); }

vec3 toward_mirrored(Surface s) { return reflect(-s.toward_eye, s.normal); }

// Directions of the world as the environment's pictures know them: the light can be turned.
vec3 in_light(vec3 d) { return light_from_world * d; }

// The cube sampler is left-handed with +Y up; its +Z is the centre of a panorama.
vec3 sampler_from_world(vec3 d) { return vec3(-d.y, d.z, d.x); }

vec2 equirect_uv(vec3 d) {
  float turn = d.x == 0.0 && d.y == 0.0 ? 0.0 : atan(d.y, d.x) / (2.0 * pi);
  return vec2(0.5 - turn, acos(clamp(d.z, -1.0, 1.0)) / pi);
}

// A lookup of one level: no derivative is taken, so there is no seam where u jumps from 1 to 0.
vec3 panorama_toward(sampler2D picture, vec3 d) { return textureLod(picture, equirect_uv(d), 0.0).rgb; }

vec3 cube_toward(samplerCube picture, vec3 d, float level) { return textureLod(picture, sampler_from_world(d), level).rgb; }

// Matte light of a few bands may be below zero; measured, it is what it is.
vec3 tinted(vec3 light) {
  return tint_negative != 0 && measure == 0 && min(light.r, min(light.g, light.b)) < 0.0 ? negative_tint : light;
}

// A tangent frame that turns with the surface's texture coordinates.
mat3 tangent_frame(vec3 position, vec3 normal, vec2 uv) {
  vec3 px = dFdx(position), py = dFdy(position);
  vec2 tx = dFdx(uv), ty = dFdy(uv);
  vec3 across = cross(py, normal), along = cross(normal, px);
  vec3 tangent = across * tx.x + along * ty.x, bitangent = across * tx.y + along * ty.y;
  float size = max(dot(tangent, tangent), dot(bitangent, bitangent));
  float scale = size > 0.0 ? inversesqrt(size) : 0.0;
  return mat3(tangent * scale, bitangent * scale, normal);
}
