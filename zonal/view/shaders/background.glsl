in vec2 on_screen;  // -1 to 1
out vec4 pixel;

void main() {
  vec4 far = world_from_clip * vec4(on_screen, 1.0, 1.0);
  vec3 toward = normalize(far.xyz / far.w - eye);
  vec3 radiance = panorama_toward(environment, in_light(toward));
  if (measure == 0) {  // a ring of three degrees around each light the technique shades by, in its own colour
    int first = marked_lights * (marked_lights - 1) / 2, end = first + marked_lights;
    for (int i = first; i < end; ++i) {
      float away = distance(in_light(toward), light_directions[i]);
      if (away < 0.07) radiance = away < 0.045 ? light_irradiance[i] : vec3(0.0);
    }
  }
  pixel = vec4(measure == 0 ? marked_split(displayed(radiance)) : radiance, 1.0);
}
