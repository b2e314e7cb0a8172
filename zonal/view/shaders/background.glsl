in vec2 on_screen;  // -1 to 1
out vec4 pixel;

void main() {
  vec4 far = world_from_clip * vec4(on_screen, 1.0, 1.0);
  vec3 toward = normalize(far.xyz / far.w - eye);
  vec3 radiance = panorama_toward(environment, in_light(toward));
  if (measure == 0) {  // a ring of three degrees around each light the technique shades by, in its own colour
    int first = marked_lights * (marked_lights - 1) / 2;
    for (int i = 0; i < 3; ++i) {
      if (i >= marked_lights) break;
      float away = distance(in_light(toward), light_directions[first + i]);
      if (away < 0.07) radiance = light_irradiance[first + i];
      if (away >= 0.045 && away < 0.07) radiance = vec3(0.0);
    }
  }
  pixel = vec4(measure == 0 ? marked_split(displayed(radiance)) : radiance, 1.0);
}
