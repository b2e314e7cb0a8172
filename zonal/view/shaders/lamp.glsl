// A lamp in the direction of the brightest light, as bright at the object's middle as that is however large it is.
vec3 lamp_center() { return lamp_distance * light_directions[0]; }
vec3 lamp_radiance() {
  return light_irradiance[0] * lamp_distance * lamp_distance / (pi * lamp_radius * lamp_radius);
}
