in float height;
out vec4 colour;

const vec3 kBottom = vec3(0.170, 0.178, 0.192);
const vec3 kTop = vec3(0.335, 0.352, 0.378);

void main() {
    colour = vec4(mix(kBottom, kTop, smoothstep(0.0, 1.0, height)), 1.0);
}
