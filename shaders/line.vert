uniform mat4 to_camera;
uniform bool orthographic;
uniform float pixel;  // height of a pixel: at distance 1, or everywhere if it is orthographic

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 colour;
layout(location = 2) in float width;  // pixels

out End {
    vec4 colour;
    float width;
} end;

void main() {
    end.colour = colour;
    end.width = width;
    // Moves the line towards the eye by its width, so that a line on the surface is fully visible.
    vec3 p = (to_camera * vec4(position, 1.0)).xyz;
    p = orthographic ? p + vec3(0.0, 0.0, width * pixel) : p * (1.0 - width * pixel);
    gl_Position = vec4(p, 1.0);
}
