// The texture of the font also has a white pixel, which is used for everything except text.
uniform sampler2D font;

in Corner {
    vec2 uv;
    vec4 tint;
} corner;
out vec4 colour;

void main() { colour = corner.tint * texture(font, corner.uv); }
