// Draws the panels, which are two-dimensional triangles in window coordinates.
uniform mat4 to_clip;

layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 tint;

out Corner {
    vec2 uv;
    vec4 tint;
} corner;

void main() {
    corner.uv = uv;
    corner.tint = tint;
    gl_Position = to_clip * vec4(position, 0.0, 1.0);
}
