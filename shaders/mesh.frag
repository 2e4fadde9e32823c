// Phong shading of clay under three lights that move with the camera. With FACES, refinement levels
// and edges are also drawn into the surface, using the outputs of faces.geom.
uniform bool orthographic;
uniform bool show_levels;
uniform float line_width;  // pixels; 0: no edges
uniform float tint_radius;  // of the brush whose weights colour the surface; 0: none
uniform vec3 tint_centre;   // in camera space
uniform vec3 tint_image;    // the mirror image of the centre
uniform bool has_tint_image;
uniform mat3 tint_axes;     // from camera space to the axes of the lattice
uniform sampler3D falloff;  // weights from the centre to a radius beyond along each axis
uniform float falloff_size;

in Surface {
    vec3 position;
    vec3 normal;
    float level;
    float deformed;
} surface;
#ifdef FACES
in vec3 barycentric;
#endif
out vec4 colour;

// Albedos, as they appear on the screen.
const vec3 kClay = vec3(0.755, 0.625, 0.540);
const vec3 kInside = vec3(0.300, 0.520, 0.600);  // back faces; a cool colour makes folds visible
const vec3 kBase = vec3(0.800, 0.790, 0.770);    // levels: the base mesh
const vec3 kEdge = vec3(0.090, 0.070, 0.070);
const vec3 kTint = vec3(1.000, 0.560, 0.120);
const float kTintStrength = 0.85;

const vec3 kKeyDirection = normalize(vec3(-0.50, 0.70, 0.65));
const vec3 kFillDirection = normalize(vec3(0.80, 0.05, 0.50));
const vec3 kRimDirection = normalize(vec3(0.35, 0.55, -0.75));
const vec3 kKey = vec3(1.000, 0.955, 0.890) * 1.00;
const vec3 kFill = vec3(0.720, 0.820, 1.000) * 0.22;
const vec3 kRim = vec3(0.900, 0.940, 1.000) * 0.30;
const vec3 kSky = vec3(0.880, 0.930, 1.000) * 0.17;
const vec3 kGround = vec3(1.000, 0.860, 0.760) * 0.110;
const float kShininess = 22.0;
const float kGloss = 0.13;

vec3 to_linear(vec3 screen) { return pow(screen, vec3(2.2)); }
vec3 to_screen(vec3 linear) { return pow(min(linear, 1.0), vec3(1.0 / 2.2)); }

// Colours from pale to dark in equal steps of lightness, from the base mesh to level 10 and above.
vec3 level_colour(float level) {
    const vec3 kLevels[6] = vec3[6](kBase, vec3(0.925, 0.850, 0.470), vec3(0.560, 0.770, 0.420),
                                    vec3(0.200, 0.620, 0.560), vec3(0.180, 0.410, 0.640),
                                    vec3(0.290, 0.160, 0.480));
    float at = clamp(level / 2.0, 0.0, 5.0);
    int below = min(int(at), 4);
    return mix(kLevels[below], kLevels[below + 1], at - float(below));
}

// Diffuse light that reaches a little beyond the horizon, as on a soft material. It fades in
// smoothly, so that there is no visible line.
float wrapped(vec3 n, vec3 light, float wrap) {
    float x = max((dot(n, light) + wrap) / (1.0 + wrap), 0.0);
    return x * x * (1.5 - 0.5 * x);
}

vec3 lit(vec3 albedo, vec3 n, vec3 to_eye) {
    vec3 diffuse = mix(kGround, kSky, 0.5 * n.y + 0.5);
    diffuse += kKey * wrapped(n, kKeyDirection, 0.20);
    diffuse += kFill * wrapped(n, kFillDirection, 0.30);
    float grazing = 1.0 - max(dot(n, to_eye), 0.0);
    vec3 rim = kRim * wrapped(n, kRimDirection, 0.0) * grazing * grazing;
    // B. T. Phong. Illumination for computer generated pictures. Communications of the ACM 18(6)
    // (1975): the angle between the mirrored light direction and the direction to the eye.
    float mirrored = max(dot(reflect(-kKeyDirection, n), to_eye), 0.0);
    vec3 gloss = kKey * kGloss * pow(mirrored, kShininess);
    return albedo * (diffuse + rim) + gloss + 0.15 * rim;
}

vec3 shading_normal() {
    vec3 n = surface.normal;
    // An undefined normal is 0. The face's own normal replaces it.
    if (dot(n, n) < 1e-4) {
        n = cross(dFdx(surface.position), dFdy(surface.position));
        return normalize(n.z < 0.0 ? -n : n);
    }
    return normalize(gl_FrontFacing ? n : -n);
}

#ifdef FACES
// The part of the pixel that an edge covers. Edges of triangles of only a few pixels would cover
// everything, so they fade to a constant tone.
float edge_cover() {
    vec3 per_pixel = max(fwidth(barycentric), 1e-6);
    vec3 distances = barycentric / per_pixel;  // distance from each edge in pixels
    float nearest = min(distances.x, min(distances.y, distances.z));
    float height = 1.0 / max(per_pixel.x, max(per_pixel.y, per_pixel.z));
    float fade = mix(0.22, 1.0, smoothstep(0.8, 5.0, height));
    return fade * (1.0 - smoothstep(0.5 * line_width - 0.5, 0.5 * line_width + 0.5, nearest));
}
#endif

// The weight that a drag of this point has here. The samples are at the middles of the texels.
float weight_around(vec3 centre) {
    vec3 offset = abs(tint_axes * (surface.position - centre)) / tint_radius;
    if (any(greaterThanEqual(offset, vec3(1.0)))) return 0.0;
    return texture(falloff, (offset * (falloff_size - 1.0) + 0.5) / falloff_size).r;
}

// With a mirror image the motion of both sides adds up.
float tint() {
    if (tint_radius <= 0.0) return 0.0;
    float weight = weight_around(tint_centre);
    if (has_tint_image) weight += weight_around(tint_image);
    return min(weight, 1.0);
}

void main() {
    vec3 albedo = kClay;
#ifdef FACES
    if (show_levels) albedo = level_colour(surface.level) * mix(1.0, 0.94, surface.deformed);
#endif
    albedo = mix(albedo, kTint, kTintStrength * tint());
    if (!gl_FrontFacing) albedo = kInside;
    vec3 to_eye = orthographic ? vec3(0.0, 0.0, 1.0) : normalize(-surface.position);
    vec3 screen = to_screen(lit(to_linear(albedo), shading_normal(), to_eye));
#ifdef FACES
    if (line_width > 0.0) screen = mix(screen, kEdge, 0.62 * edge_cover());
#endif
    colour = vec4(screen, 1.0);
}
