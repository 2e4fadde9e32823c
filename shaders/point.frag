uniform float strength;

in vec4 point_colour;
flat in float radius;
flat in int point_shape;
out vec4 colour;

const int kDisc = 0, kRing = 1, kDiamond = 2;
const vec3 kOutline = vec3(0.06, 0.07, 0.09);

void main() {
    vec2 p = (gl_PointCoord - 0.5) * 2.0 * (radius + 1.0);
    float from_middle = point_shape == kDiamond ? abs(p.x) + abs(p.y) : length(p);
    float cover = clamp(radius + 0.5 - from_middle, 0.0, 1.0);
    // A dark border of about one pixel separates the point from the background.
    float border = clamp(from_middle - (radius - 1.6), 0.0, 1.0) * step(3.0, radius);
    vec3 rgb = mix(point_colour.rgb, kOutline, border);
    if (point_shape == kRing) {
        cover *= clamp(from_middle - (radius - 3.0), 0.0, 1.0);
        rgb = point_colour.rgb;
    }
    if (cover <= 0.0) discard;
    colour = vec4(rgb, point_colour.a * cover * strength);
}
