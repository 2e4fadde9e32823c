// Passes to mesh.frag what it needs of a face: its level, which is the highest of its corners, and the
// barycentric coordinates of each corner. With these the edges are drawn as part of the surface, so
// that there are no depth conflicts.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in Surface {
    vec3 position;
    vec3 normal;
    float level;
    float deformed;
} corners[];

out Surface {
    vec3 position;
    vec3 normal;
    float level;
    float deformed;
} surface;
out vec3 barycentric;

void main() {
    float level = max(corners[0].level, max(corners[1].level, corners[2].level));
    for (int i = 0; i < 3; ++i) {
        surface.position = corners[i].position;
        surface.normal = corners[i].normal;
        surface.level = level;
        surface.deformed = corners[i].deformed;
        barycentric = vec3(i == 0, i == 1, i == 2);
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
