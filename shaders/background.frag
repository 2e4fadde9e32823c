uniform vec3 bottom;
uniform vec3 top;

in float height;
out vec4 colour;

void main() {
    colour = vec4(mix(bottom, top, smoothstep(0.0, 1.0, height)), 1.0);
}
