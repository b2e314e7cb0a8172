#version 410
// A matte surface lit by its whole surroundings, which are known by nine coefficients of spherical harmonics.
layout(location = 0) in vec4 pv;  // position of the vertex
layout(location = 1) in vec4 nv;  // its normal; w is ignored
uniform mat4 mc;                  // to clip coordinates
uniform mat4 mg;                  // turns normals into the axes of the coefficients
uniform vec3 sh[9];               // radiance: c00, c1-1, c10, c11, c2-2, c2-1, c20, c21, c22
out vec3 idiff;                   // diffuse light of the vertex

const float pi = 3.14159265;
const vec3 kdiff = vec3(0.8) / pi;  // albedo over pi
const float fscale = 1.0;           // for a screen that cannot show how bright E is

// Irradiance on a surface with unit normal n (Ramamoorthi & Hanrahan 2001, eq. 13).
vec3 irradiance(vec3 n) {
  const float k1 = 0.42904277, k2 = 0.51166335, k3 = 0.74312387, k4 = 0.88622693, k5 = 0.24770796;
  return k1 * sh[8] * (n.x * n.x - n.y * n.y) + k3 * sh[6] * n.z * n.z + k4 * sh[0] - k5 * sh[6]
       + 2.0 * k1 * (sh[4] * n.x * n.y + sh[7] * n.x * n.z + sh[5] * n.y * n.z)
       + 2.0 * k2 * (sh[3] * n.x + sh[1] * n.y + sh[2] * n.z);
}

void main() {
  vec3 n = normalize((mg * vec4(nv.xyz, 0.0)).xyz);
  idiff = kdiff * irradiance(n) * fscale;
  gl_Position = mc * pv;
}
