// Widens a line to a strip, because core OpenGL draws only lines that are one pixel wide.
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

uniform mat4 projection;
uniform vec2 picture_size;  // pixels
uniform float near;

in End {
    vec4 colour;
    float width;
} end[];

out vec4 line_colour;
out float across;  // distance from the centre line in pixels
out float half_width;

// Moves an end that is behind the near plane along the line to that plane.
vec4 clipped(vec4 p, vec4 other) {
    float behind = p.z + near;
    if (behind <= 0.0) return p;
    return mix(p, other, behind / (p.z - other.z));
}

// Divides by w here, which is possible because no part of the line is behind the eye any more. The
// interpolation is then linear on the screen, like the strip's width.
void emit(vec4 clip, vec2 side, float pixels, float width, vec4 colour) {
    line_colour = colour;
    half_width = 0.5 * width;
    across = pixels;
    gl_Position = vec4(clip.xyz / clip.w + vec3(side * pixels * 2.0 / picture_size, 0.0), 1.0);
    EmitVertex();
}

void main() {
    vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;
    if (a.z > -near && b.z > -near) return;
    vec4 p = projection * clipped(a, b), q = projection * clipped(b, a);
    vec2 along = (q.xy / q.w - p.xy / p.w) * picture_size;
    if (dot(along, along) < 1e-12) return;
    vec2 side = normalize(vec2(-along.y, along.x));
    float width = end[0].width;
    float reach = 0.5 * width + 1.0;  // includes the antialiased border
    emit(p, side, reach, width, end[0].colour);
    emit(p, side, -reach, width, end[0].colour);
    emit(q, side, reach, width, end[1].colour);
    emit(q, side, -reach, width, end[1].colour);
    EndPrimitive();
}
