in vec2 on_screen;  // -1 to 1
out vec4 pixel;

void main() {
  vec4 far = world_from_clip * vec4(on_screen, 1.0, 1.0);
  vec3 toward = normalize(far.xyz / far.w - eye);
  vec3 radiance = panorama_toward(environment, in_light(toward));
  pixel = vec4(measure == 0 ? marked_split(displayed(radiance)) : radiance, 1.0);
}
