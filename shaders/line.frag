uniform float strength;

in vec4 line_colour;
in float across;
in float half_width;
out vec4 colour;

void main() {
    float cover = clamp(half_width + 0.5 - abs(across), 0.0, 1.0);
    colour = vec4(line_colour.rgb, line_colour.a * cover * strength);
}
