uniform mat4 to_camera;  // from coordinates relative to the object's centre
uniform mat4 to_clip;

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 level_and_deformed;

out Surface {
    vec3 position;  // in camera space, like the normal
    vec3 normal;
    float level;
    float deformed;
} surface;

void main() {
    surface.position = (to_camera * vec4(position, 1.0)).xyz;
    surface.normal = mat3(to_camera) * normal;
    surface.level = level_and_deformed.x;
    surface.deformed = level_and_deformed.y;
    gl_Position = to_clip * vec4(position, 1.0);
}
