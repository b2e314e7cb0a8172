#version 410
in vec3 idiff;
layout(location = 0) out vec4 fc;

void main() { fc = vec4(max(idiff, vec3(0.0)), 1.0); }
