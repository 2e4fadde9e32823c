// Gives mesh.frag the level of the face, which is the highest level of its corners, and the
// barycentric coordinates of each corner. mesh.frag draws the edges into the surface with them, so
// that edges and faces do not compete for the same depth.
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
