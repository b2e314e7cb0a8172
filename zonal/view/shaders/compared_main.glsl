// Too bright is red, too dark is blue, over the exact answer in grey.
vec3 difference_color(vec3 value, vec3 truth) {
  float error = (luminance(value) - luminance(truth)) * exp2(exposure_ev) * difference_gain;
  vec3 grey = vec3(0.35 * luminance(displayed(truth)));
  return mix(grey, error > 0.0 ? vec3(0.9, 0.15, 0.1) : vec3(0.1, 0.35, 0.95), clamp(abs(error), 0.0, 1.0));
}

void main() {
  Surface s = surface_of_pixel();
  // By uniforms alone where the technique takes derivatives: neighbours must go the same way.
  bool truth_side = compare == 3 && gl_FragCoord.x > split_px;
  vec3 value = vec3(0.0), truth = vec3(0.0);
  if (measure == 0 ? compare != 1 : measure < 3) value = shade(s);
  if (measure == 0 ? compare == 1 || compare == 2 || truth_side : measure == 1 || measure == 3) truth = exact(s);
  if (measure == 1) {
    vec3 error = value - truth;
    pixel = vec4(dot(error, error), dot(truth, truth), 0.0, 1.0);
  } else if (measure > 1) {
    pixel = vec4(measure == 2 ? value : measure == 3 ? truth : measure == 4 ? s.normal : measure == 5 ? s.position
                                                                                                      : vec3(s.uv, 0.0), 1.0);
  } else if (compare == 2) {
    pixel = vec4(difference_color(value, truth), 1.0);
  } else {
    pixel = vec4(marked_split(displayed(compare == 1 || truth_side ? truth : value)), 1.0);
  }
}
