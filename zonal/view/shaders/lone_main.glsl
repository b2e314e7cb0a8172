// The technique alone, in colours for a screen.
void main() { pixel = vec4(displayed(shade(surface_of_pixel())), 1.0); }
