// One arrow for each light that the technique shades by, along the light's way to the object. An arrow on the axis of a
// light that is behind the object or behind the eye would be hidden or seen end-on: as the light nears the line of
// sight its arrow moves beside the object, keeping its direction, to the side the light is on.
layout(location = 0) in vec3 position;  // the tip at the origin, the tail at +Z 1
layout(location = 1) in vec3 normal;
uniform mat4 clip_from_world;
out vec3 arrow_normal;
out vec3 arrow_position;
flat out vec3 arrow_light;

const float around = 1.15;        // distance of the tip from the middle of an object of radius 1
const float longest = 1.3;        // of a light that is all there is
const float quarter = 1.5707963;  // of a turn

void main() {
  int light = marked_lights * (marked_lights - 1) / 2 + gl_InstanceID;
  vec3 toward_light = light_directions[light] * light_from_world;
  float size = longest * sqrt(light_shares[light]);  // so that its area is in proportion to the light's irradiance

  vec3 toward_eye = vec3(eye_from_world[0].z, eye_from_world[1].z, eye_from_world[2].z);
  vec3 right = vec3(eye_from_world[0].x, eye_from_world[1].x, eye_from_world[2].x);
  vec3 beside = dot(toward_light, right) < 0.0 ? -right : right;
  beside -= dot(beside, toward_light) * toward_light;
  float before = dot(toward_light, toward_eye), aside = smoothstep(0.5, 0.9, abs(before)), turn = quarter * aside;
  float away = around * (before < 0.0 ? 1.0 + 0.3 * aside : 1.0);  // further behind the object, or it would hide the tail
  vec3 tip = away * (cos(turn) * toward_light + sin(turn) * beside / max(length(beside), 1e-6));

  vec3 across = normalize(cross(abs(toward_light.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0), toward_light));
  mat3 world_from_arrow = mat3(across, cross(toward_light, across), toward_light);
  arrow_position = tip + size * (world_from_arrow * position);
  arrow_normal = world_from_arrow * normal;
  arrow_light = light_irradiance[light];
  gl_Position = clip_from_world * vec4(arrow_position, 1.0);
}
