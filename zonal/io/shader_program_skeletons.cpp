#include "zonal/io/shader_program_skeletons.h"

#include <cstddef>

namespace zonal {
namespace {

constexpr ProgramSkeleton kSkeletons[] = {
    {.vertex = R"(#version 410
$about
layout(location = 0) in vec4 pv;  // position of the vertex
layout(location = 1) in vec4 nv;  // its normal; w is ignored
uniform mat4 mc;  // to clip coordinates
uniform mat4 mg;  // turns normals into the axes of sh
out vec3 $varying;
$shade_vertex
void main() {
  $varying = $to_varying;
  gl_Position = mc * pv;
}
)",
     .fragment = R"(#version 410
$about
in vec3 $varying;
layout(location = 0) out vec4 fc;
$shade_fragment
void main() {
  fc = vec4($from_varying, 1.0);
}
)",
     .shade = R"(
uniform vec3 sh[9];

vec3 zonal_irradiance(vec3 n) {
  const float k1 = $k1, k2 = $k2, k3 = $k3, k4 = $k4, k5 = $k5;
  return k1 * (n.x * n.x - n.y * n.y) * sh[8] + (k3 * n.z * n.z - k5) * sh[6] + k4 * sh[0]
      + 2.0 * k1 * (n.x * n.y * sh[4] + n.x * n.z * sh[7] + n.y * n.z * sh[5])
      + 2.0 * k2 * (n.x * sh[3] + n.y * sh[1] + n.z * sh[2]);
}

vec3 zonal_reflected(vec3 normal) {
  const vec3 kdiff = vec3($kdiff);
  const float fscale = $fscale;
  return kdiff * zonal_irradiance(normalize(normal)) * fscale;
}
)",
     .normal = "(mg * vec4(nv.xyz, 0.0)).xyz",
     .sh_parameter = "",
     .sh_argument = "",
     .suffix = "",
     .floats_apart = 3},

    {.vertex = R"($about
struct Vertex {
  float4 pv : POSITION;  // position of the vertex
  float4 nv : NORMAL;    // its normal; w is ignored
};
struct Varying {
  float4 position : SV_Position;
  float3 $varying : TEXCOORD0;
};
cbuffer Transform : register(b0) {  // matrices column after column
  float4x4 mc;  // to clip coordinates
  float4x4 mg;  // turns normals into the axes of sh
};
$shade_vertex
Varying main(Vertex v) {
  Varying result;
  result.$varying = $to_varying;
  result.position = mul(mc, v.pv);
  return result;
}
)",
     .fragment = R"($about
struct Varying {
  float4 position : SV_Position;
  float3 $varying : TEXCOORD0;
};
$shade_fragment
float4 main(Varying v) : SV_Target {
  return float4($from_varying, 1.0);
}
)",
     .shade = R"(
cbuffer Light : register(b1) {
  float3 sh[9];
};

float3 zonal_irradiance(float3 n) {
  const float k1 = $k1, k2 = $k2, k3 = $k3, k4 = $k4, k5 = $k5;
  return k1 * (n.x * n.x - n.y * n.y) * sh[8] + (k3 * n.z * n.z - k5) * sh[6] + k4 * sh[0]
      + 2.0 * k1 * (n.x * n.y * sh[4] + n.x * n.z * sh[7] + n.y * n.z * sh[5])
      + 2.0 * k2 * (n.x * sh[3] + n.y * sh[1] + n.z * sh[2]);
}

float3 zonal_reflected(float3 normal) {
  const float3 kdiff = float3($kdiff);
  const float fscale = $fscale;
  return kdiff * zonal_irradiance(normalize(normal)) * fscale;
}
)",
     .normal = "mul(mg, float4(v.nv.xyz, 0.0)).xyz",
     .sh_parameter = "",
     .sh_argument = "",
     .suffix = ""},

    {.vertex = R"($about
#include <metal_stdlib>
using namespace metal;

struct Vertex {
  float4 pv [[attribute(0)]];  // position of the vertex
  float4 nv [[attribute(1)]];  // its normal; w is ignored
};
struct Varying {
  float4 position [[position]];
  float3 $varying;
};
struct Transform {
  float4x4 mc;  // to clip coordinates
  float4x4 mg;  // turns normals into the axes of sh
};
$shade_vertex
vertex Varying zonal_vertex(Vertex v [[stage_in]], constant Transform& transform [[buffer(1)]]$sh_vertex) {
  Varying result;
  result.$varying = $to_varying;
  result.position = transform.mc * v.pv;
  return result;
}
)",
     .fragment = R"($about
#include <metal_stdlib>
using namespace metal;

struct Varying {
  float4 position [[position]];
  float3 $varying;
};
$shade_fragment
fragment float4 zonal_fragment(Varying v [[stage_in]]$sh_fragment) {
  return float4($from_varying, 1.0f);
}
)",
     .shade = R"(
inline float3 zonal_irradiance(float3 n, constant float3* sh) {
  const float k1 = $k1, k2 = $k2, k3 = $k3, k4 = $k4, k5 = $k5;
  return k1 * (n.x * n.x - n.y * n.y) * sh[8] + (k3 * n.z * n.z - k5) * sh[6] + k4 * sh[0]
      + 2.0f * k1 * (n.x * n.y * sh[4] + n.x * n.z * sh[7] + n.y * n.z * sh[5])
      + 2.0f * k2 * (n.x * sh[3] + n.y * sh[1] + n.z * sh[2]);
}

inline float3 zonal_reflected(float3 normal, constant float3* sh) {
  const float3 kdiff = float3($kdiff);
  const float fscale = $fscale;
  return kdiff * zonal_irradiance(normalize(normal), sh) * fscale;
}
)",
     .normal = "(transform.mg * float4(v.nv.xyz, 0.0f)).xyz",
     .sh_parameter = ", constant float3* sh [[buffer(2)]]",
     .sh_argument = ", sh",
     .suffix = "f"},

    {.vertex = R"($about
struct Vertex {
  @location(0) pv: vec4<f32>,  // position of the vertex
  @location(1) nv: vec4<f32>,  // its normal; w is ignored
}
struct Varying {
  @builtin(position) position: vec4<f32>,
  @location(0) $varying: vec3<f32>,
}
struct Transform {
  mc: mat4x4<f32>,  // to clip coordinates
  mg: mat4x4<f32>,  // turns normals into the axes of sh
}
@group(0) @binding(0) var<uniform> transform: Transform;
$shade_vertex
@vertex fn main(v: Vertex) -> Varying {
  var result: Varying;
  result.$varying = $to_varying;
  result.position = transform.mc * v.pv;
  return result;
}
)",
     .fragment = R"($about
struct Varying {
  @builtin(position) position: vec4<f32>,
  @location(0) $varying: vec3<f32>,
}
$shade_fragment
@fragment fn main(v: Varying) -> @location(0) vec4<f32> {
  return vec4<f32>($from_varying, 1.0);
}
)",
     .shade = R"(
@group(0) @binding(1) var<uniform> sh: array<vec3<f32>, 9>;

fn zonal_irradiance(n: vec3<f32>) -> vec3<f32> {
  const k1 = $k1;
  const k2 = $k2;
  const k3 = $k3;
  const k4 = $k4;
  const k5 = $k5;
  return k1 * (n.x * n.x - n.y * n.y) * sh[8] + (k3 * n.z * n.z - k5) * sh[6] + k4 * sh[0]
      + 2.0 * k1 * (n.x * n.y * sh[4] + n.x * n.z * sh[7] + n.y * n.z * sh[5])
      + 2.0 * k2 * (n.x * sh[3] + n.y * sh[1] + n.z * sh[2]);
}

fn zonal_reflected(normal: vec3<f32>) -> vec3<f32> {
  const kdiff = vec3<f32>($kdiff);
  const fscale = $fscale;
  return kdiff * zonal_irradiance(normalize(normal)) * fscale;
}
)",
     .normal = "(transform.mg * vec4<f32>(v.nv.xyz, 0.0)).xyz",
     .sh_parameter = "",
     .sh_argument = "",
     .suffix = "f"},

    {.vertex = R"($about
#pragma once
#include <cmath>
$shade_vertex
template <class Vec3, class Vec4>
struct ZonalVarying {
  Vec4 position;
  Vec3 $varying;
};

// pv: position of the vertex; nv: its normal, w is ignored; mc: to clip coordinates; mg: turns normals into the axes of sh.
template <class Vec3, class Vec4, class Mat4>
ZonalVarying<Vec3, Vec4> zonal_vertex(const Vec4& pv, const Vec4& nv, const Mat4& mc, const Mat4& mg$sh_vertex) {
  const Vec4 turned = mg * Vec4(nv.x, nv.y, nv.z, 0.0f);
  return {mc * pv, $to_varying};
}
)",
     .fragment = R"($about
#pragma once
#include <cmath>
$shade_fragment
template <class Vec4, class Vec3>
Vec4 zonal_fragment(const Vec3& $varying$sh_fragment) {
  const Vec3 color = $from_varying;
  return Vec4(color.x, color.y, color.z, 1.0f);
}
)",
     .shade = R"(
template <class Vec3>
Vec3 zonal_irradiance(const Vec3& n, const Vec3 (&sh)[9]) {
  const float k1 = $k1, k2 = $k2, k3 = $k3, k4 = $k4, k5 = $k5;
  return k1 * (n.x * n.x - n.y * n.y) * sh[8] + (k3 * n.z * n.z - k5) * sh[6] + k4 * sh[0]
      + 2.0f * k1 * (n.x * n.y * sh[4] + n.x * n.z * sh[7] + n.y * n.z * sh[5])
      + 2.0f * k2 * (n.x * sh[3] + n.y * sh[1] + n.z * sh[2]);
}

template <class Vec3>
Vec3 zonal_reflected(const Vec3& normal, const Vec3 (&sh)[9]) {
  const float kdiff[3] = {$kdiff};
  const float fscale = $fscale;
  const float size = std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
  const Vec3 e = zonal_irradiance((1.0f / size) * normal, sh);
  return fscale * Vec3(kdiff[0] * e.x, kdiff[1] * e.y, kdiff[2] * e.z);
}
)",
     .normal = "Vec3(turned.x, turned.y, turned.z)",
     .sh_parameter = ", const Vec3 (&sh)[9]",
     .sh_argument = ", sh",
     .suffix = "f",
     .floats_apart = 3},
};

}  // namespace

const ProgramSkeleton& program_skeleton(ShaderLanguage language) {
  static_assert(std::size(kSkeletons) == static_cast<std::size_t>(ShaderLanguage::kCpp) + 1);
  return kSkeletons[static_cast<std::size_t>(language)];
}

}  // namespace zonal
