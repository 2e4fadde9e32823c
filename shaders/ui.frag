// The font texture also contains white texels, which shapes without text use.
uniform sampler2D font;

in Corner {
    vec2 uv;
    vec4 tint;
} corner;
out vec4 colour;

void main() { colour = corner.tint * texture(font, corner.uv); }
