in vec3 world_position;
in vec3 world_normal;
in vec2 texture_position;
out vec4 pixel;

Surface surface_of_pixel() {
  Surface s;
  s.position = world_position;
  s.normal = normalize(world_normal);
  s.toward_eye = normalize(eye - world_position);
  // The inside of an open mesh, judged by the face: at the rim an interpolated normal may lean away from the eye.
  vec3 face = cross(dFdx(world_position), dFdy(world_position));
  if (dot(face, s.toward_eye) * dot(face, s.normal) < 0.0) s.normal = -s.normal;
  s.uv = texture_position;
  return s;
}
