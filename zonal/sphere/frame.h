#pragma once

#include "zonal/math/vec.h"

namespace zonal {

// How each picture lies in the world (right-handed, +Z up). "Inside": as seen by an eye at the centre of the sphere;
// "mirrored": the other way round, because the format is defined so.
//
// | picture                          | centre | right | up | seen     |
// |----------------------------------|--------|-------|----|----------|
// | equirect                         | +X     | -Y    | +Z | inside   |
// | cube, face +Z of the sampler     | +X     | -Y    | +Z | inside   |
// | octahedral, both                 | +Z     | +X    | -Y | inside   |
// | mirror ball, sphere map          | -X     | -Y    | +Z | mirrored |
// | angular map                      | +X     | -Y    | +Z | inside   |
// | dual paraboloid, left            | +X     | -Y    | +Z | inside   |
// | dual paraboloid, right           | -X     | -Y    | +Z | mirrored |
// | fisheye (camera on its back)     | +Z     | +Y    | +X | inside   |
// | dual fisheye, left               | +X     | -Y    | +Z | inside   |
// | dual fisheye, right              | -X     | +Y    | +Z | inside   |
//
// The ball is what a camera sees that looks along +X: its centre reflects the light that comes from the camera's side
// (-X), its rim shows +X, and its right half shows what lies to the camera's right. The right image of a dual
// paraboloid keeps the right and up of the left one (Heidrich & Seidel 1998), which is why it is mirrored.

/// The world directions of a picture's centre, right and up: orthonormal. Inside pictures have right == cross(centre,
/// up).
struct PictureAxes {
  Vec3 center, right, up;
};
inline constexpr PictureAxes kForward = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
inline constexpr PictureAxes kBackward = {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline constexpr PictureAxes kBackwardMirrored = {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
inline constexpr PictureAxes kZenith = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};

/// The cube sampler that OpenGL, Vulkan and Direct3D share is left-handed with +Y up. Looked up this way, its face +Z
/// is the centre of a panorama, +X is the face to its right, and a horizontal cross reads as an unmirrored, continuous
/// panorama.
constexpr Vec3 sampler_from_world(Vec3 d) { return {-d.y, d.z, d.x}; }
constexpr Vec3 world_from_sampler(Vec3 d) { return {d.z, -d.x, d.y}; }

}  // namespace zonal
