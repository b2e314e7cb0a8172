in vec3 arrow_normal;
in vec3 arrow_position;
flat in vec3 arrow_light;
out vec4 pixel;

// A sign and not a surface of the scene: in the light's hue whatever the exposure, darker where it turns from the eye.
void main() {
  float facing = max(dot(normalize(arrow_normal), normalize(eye - arrow_position)), 0.0);
  vec3 hue = arrow_light / max(max(arrow_light.r, max(arrow_light.g, arrow_light.b)), 1e-30);
  pixel = vec4(marked_split(srgb(hue * (0.15 + 0.85 * facing))), 1.0);
}
