uniform mat4 to_camera;
uniform mat4 projection;
uniform bool orthographic;
uniform float pixel;  // height of a pixel: at distance 1, or everywhere if it is orthographic

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 colour;
layout(location = 2) in float diameter;  // pixels
layout(location = 3) in float shape;

out vec4 point_colour;
flat out float radius;
flat out int point_shape;

void main() {
    point_colour = colour;
    radius = 0.5 * diameter;
    point_shape = int(shape);
    gl_PointSize = diameter + 2.0;  // includes the antialiased border
    vec3 p = (to_camera * vec4(position, 1.0)).xyz;
    p = orthographic ? p + vec3(0.0, 0.0, diameter * pixel) : p * (1.0 - diameter * pixel);
    gl_Position = projection * vec4(p, 1.0);
}
