// The font's texture also has a white place, for what is no letter.
uniform sampler2D font;

in Corner {
    vec2 uv;
    vec4 tint;
} corner;
out vec4 colour;

void main() { colour = corner.tint * texture(font, corner.uv); }
