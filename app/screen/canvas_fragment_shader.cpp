#include "screen/canvas_shader.hpp"

namespace pastoso::screen {

// The names are those of shade/shading_model.hpp and shade/sampling.hpp. The pages carry a border of
// two cells, so that no fetch has to look where the canvas or its page ends.
namespace {

const char* const kSurface = R"(
uniform sampler2DArray surface_layers;  // spline coefficients of h, the shadow's height, the sky's share
uniform sampler2DArray colour_and_wetness;
uniform vec2 pages;                    // columns and rows
uniform vec2 page_cells;               // of one, without its border
uniform vec2 canvas_cells;
uniform float cell_mm;
uniform vec2 origin_px;                // of the canvas, device pixels
uniform mat2 canvas_from_screen;       // turns directions
uniform float px_per_cell;
uniform float pixel_size;              // side of a fragment, device pixels
uniform int samples_per_side;          // of a fragment
uniform float colour_sharpness;        // 1: Mitchell and Netravali with B = C = 1/3, 0: B-spline

uniform vec3 to_light;
uniform vec3 half_vector;
uniform float direct;
uniform float ambient;
uniform float gloss;
uniform float dry_roughness;
uniform float wet_roughness;
uniform float inverse_softness_per_mm;
uniform vec3 luminance_weights;        // of the working space
uniform vec3 ground;                   // around the canvas, as the screen takes it

out vec4 screen_colour;

const int kBorder = 2;

vec4 spline_weights(float t) {
    float s = 1.0 - t;
    return vec4(s * s * s, 4.0 - 3.0 * t * t * (2.0 - t), 4.0 - 3.0 * s * s * (2.0 - s), t * t * t) / 6.0;
}

vec4 spline_slopes(float t) {
    float s = 1.0 - t;
    return vec4(-0.5 * s * s, t * (1.5 * t - 2.0), s * (2.0 - 1.5 * s), 0.5 * t * t);
}

vec4 spline_bends(float t) {
    return vec4(1.0 - t, 3.0 * t - 2.0, 1.0 - 3.0 * t, t);
}

vec4 colour_weights(float t, vec4 spline) {
    vec2 near = vec2(t, 1.0 - t);
    vec2 far = 1.0 + near;
    vec2 inner = ((7.0 * near - 12.0) * near * near + 16.0 / 3.0) / 6.0;
    vec2 outer = (((-7.0 / 3.0 * far + 12.0) * far - 20.0) * far + 32.0 / 3.0) / 6.0;
    return mix(spline, vec4(outer.x, inner.x, inner.y, outer.y), colour_sharpness);
}

// Where a cell lies; the canvas's edges belong to the pages beside them.
ivec3 texel_of(ivec2 cell) {
    ivec2 side = ivec2(page_cells), count = ivec2(pages);
    ivec2 page = clamp(max(cell, 0) / side, ivec2(0), count - 1);
    return ivec3(cell - page * side + kBorder, page.y * count.x + page.x);
}

struct SurfacePoint {
    float height_mm;
    vec2 slope;
    vec3 bend;  // xx, xy, yy over a cell
    float shadow_mm;
    float sky;
    vec3 colour;
    float wetness;
};

SurfacePoint surface_at(vec2 cell) {
    vec2 centred = cell - 0.5;
    vec2 whole = floor(centred);
    vec2 t = centred - whole;
    ivec3 first = texel_of(ivec2(whole)) - ivec3(1, 1, 0);
    vec4 spline_x = spline_weights(t.x), spline_y = spline_weights(t.y);
    vec4 slope_x = spline_slopes(t.x), slope_y = spline_slopes(t.y);
    vec4 bend_x = spline_bends(t.x), bend_y = spline_bends(t.y);
    vec4 colour_x = colour_weights(t.x, spline_x), colour_y = colour_weights(t.y, spline_y);
    vec3 layers = vec3(0.0);
    vec2 slope = vec2(0.0);
    vec3 bend = vec3(0.0);
    vec4 colour = vec4(0.0);
    for (int j = 0; j < 4; ++j) {
        vec3 layers_row = vec3(0.0);
        float slope_row = 0.0, bend_row = 0.0;
        vec4 colour_row = vec4(0.0);
        for (int i = 0; i < 4; ++i) {
            ivec3 texel = first + ivec3(i, j, 0);
            vec3 here = texelFetch(surface_layers, texel, 0).rgb;
            layers_row += spline_x[i] * here;
            slope_row += slope_x[i] * here.r;
            bend_row += bend_x[i] * here.r;
            colour_row += colour_x[i] * texelFetch(colour_and_wetness, texel, 0);
        }
        layers += spline_y[j] * layers_row;
        slope += vec2(spline_y[j] * slope_row, slope_y[j] * layers_row.r);
        bend += vec3(spline_y[j] * bend_row, slope_y[j] * slope_row, bend_y[j] * layers_row.r);
        colour += colour_y[j] * colour_row;
    }
    return SurfacePoint(layers.r, slope / cell_mm, bend / cell_mm, layers.g, layers.b, colour.rgb, colour.a);
}

float visibility(float depth_mm) {
    float t = clamp(depth_mm * inverse_softness_per_mm, 0.0, 1.0);
    return 1.0 - t * t * (3.0 - 2.0 * t);
}

float ggx(float a2, float light, float eye, float half_cosine) {
    float spread = half_cosine * half_cosine * (a2 - 1.0) + 1.0;
    float masking = light * sqrt(eye * eye * (1.0 - a2) + a2) + eye * sqrt(light * light * (1.0 - a2) + a2);
    return 0.318309886 * a2 / (spread * spread) * 0.5 / masking;
}

vec3 shoulder(vec3 value) {
    const float kKnee = 0.85;
    vec3 above = max(value - kKnee, 0.0);
    return value - above + above / (1.0 + above / (1.0 - kKnee));
}

vec3 shade(SurfacePoint point) {
    float eye = inversesqrt(1.0 + dot(point.slope, point.slope));
    float towards = (to_light.z - dot(point.slope, to_light.xy)) * eye;
    vec2 varying_light = eye * vec2(dot(point.bend.xy, to_light.xy), dot(point.bend.yz, to_light.xy));
    float lit = 0.5 * (towards + sqrt(towards * towards + 0.212206591 * dot(varying_light, varying_light)));
    float half_cosine = (half_vector.z - dot(point.slope, half_vector.xy)) * eye;
    float arriving = lit * visibility(point.shadow_mm - point.height_mm);
    float roughness = mix(dry_roughness, wet_roughness, clamp(point.wetness, 0.0, 1.0));
    float diffuse = direct * arriving + ambient * point.sky;
    float variance = dot(point.bend * point.bend, vec3(1.0, 2.0, 1.0)) / 3.0;
    float a2 = min(1.0, roughness * roughness + variance);
    float highlight = gloss * arriving * ggx(a2, lit, eye, half_cosine);
    return shoulder(point.colour * diffuse + highlight);
}

)";

/// What shows the points: after that which knows of outlines.
const char* const kPicture = R"(
vec3 lit_at(vec2 cell) {
    SurfacePoint point = surface_at(cell);
    vec3 seen = shade(point);
#if OUTLINED
    if (outline_near(cell)) {
        Sides sides = sides_at(cell, point);
        seen = mix(seen, mix(shade(sides.dry), shade(sides.paint), sides.within), sides.strength);
    }
#endif
    return seen;
}

vec3 flat_at(vec2 cell) {
    SurfacePoint point = surface_at(cell);
    vec3 seen = point.colour;
#if OUTLINED
    if (outline_near(cell)) {
        Sides sides = sides_at(cell, point);
        seen = mix(seen, mix(sides.dry.colour, sides.paint.colour, sides.within), sides.strength);
    }
#endif
    return seen;
}

// pigment/colour.hpp: half clipped, half moved towards the grey of the same luminance.
vec3 into_gamut(vec3 colour) {
    float grey = clamp(dot(luminance_weights, colour), 0.0, 1.0);
    vec3 excess = max(max(colour - 1.0, -colour), 0.0);
    vec3 reach = max(abs(colour - grey), 1e-6);
    vec3 shares = excess / reach;
    float share = clamp(max(shares.r, max(shares.g, shares.b)), 0.0, 1.0);
    return 0.5 * (clamp(colour, 0.0, 1.0) + clamp(mix(colour, vec3(grey), share), 0.0, 1.0));
}

vec3 encode_srgb(vec3 linear) {
    vec3 low = 12.92 * linear;
    vec3 high = 1.055 * pow(max(linear, 1e-6), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, lessThanEqual(linear, vec3(0.0031308)));
}

#if LOOK == 0
vec3 sample_at(vec2 cell) { return lit_at(cell); }
vec3 on_screen(vec3 mean) { return encode_srgb(into_gamut(mean)); }
#else
uniform sampler2DArray look_thickness;  // mm
uniform float scale_top_mm;
uniform vec3 height_colours[10];       // encoded, as all that follows
uniform vec2 wet_range_mm;
uniform vec3 wet_tint;
uniform float full_tint;
uniform float grey_share;

float look_thickness_at(vec2 cell) {
    vec2 centred = cell - 0.5;
    vec2 whole = floor(centred);
    vec2 t = centred - whole;
    ivec3 first = texel_of(ivec2(whole));
    vec2 near = vec2(texelFetch(look_thickness, first, 0).r,
                     texelFetch(look_thickness, first + ivec3(1, 0, 0), 0).r);
    vec2 far = vec2(texelFetch(look_thickness, first + ivec3(0, 1, 0), 0).r,
                    texelFetch(look_thickness, first + ivec3(1, 1, 0), 0).r);
    vec2 rows = mix(near, far, t.y);
    return mix(rows.x, rows.y, t.x);
}

vec3 wet_over(vec3 lit, float wet_mm) {
    vec3 grey = vec3(grey_share * encode_srgb(vec3(clamp(dot(luminance_weights, lit), 0.0, 1.0))).r);
    float share = log(max(wet_mm, wet_range_mm.x) / wet_range_mm.x) / log(wet_range_mm.y / wet_range_mm.x);
    return mix(grey, wet_tint, full_tint * min(share, 1.0));
}

// Encoded.
vec3 sample_at(vec2 cell) {
#if LOOK == 1
    return wet_over(lit_at(cell), look_thickness_at(cell));
#elif LOOK == 2
    float share = look_thickness_at(cell) / scale_top_mm;
    return height_colours[int(clamp(floor(10.0 * share), 0.0, 9.0))];
#elif LOOK == 3
    vec2 slope = surface_at(cell).slope;
    vec3 normal = normalize(vec3(-slope.x, slope.y, 1.0));
    return 0.5 + 0.5 * normal;
#else
    return encode_srgb(into_gamut(flat_at(cell)));
#endif
}

vec3 on_screen(vec3 mean) { return mean; }
#endif

// The ground with the soft shadow of the canvas's edge.
vec3 ground_at(vec2 cell) {
    vec2 outside_px = max(max(-cell, cell - canvas_cells), 0.0) * px_per_cell;
    float shadow = exp(-length(outside_px) / 9.0);
    return ground * (1.0 - 0.45 * shadow);
}

void main() {
    vec2 corner_px = (gl_FragCoord.xy - 0.5) * pixel_size;
    vec2 corner_cell = canvas_from_screen * (corner_px - origin_px) / px_per_cell;
    float step_cells = pixel_size / (px_per_cell * float(samples_per_side));
    vec3 sum = vec3(0.0);
    float covered = 0.0;
    for (int j = 0; j < samples_per_side; ++j) {
        for (int i = 0; i < samples_per_side; ++i) {
            vec2 cell = corner_cell + canvas_from_screen * (step_cells * (vec2(i, j) + 0.5));
            if (any(lessThan(cell, vec2(0.0))) || any(greaterThanEqual(cell, canvas_cells))) continue;
            sum += sample_at(cell);
            covered += 1.0;
        }
    }
    vec3 around = ground_at(corner_cell + canvas_from_screen * vec2(0.5 * pixel_size / px_per_cell));
    float share = covered / float(samples_per_side * samples_per_side);
    vec3 mean = sum / max(covered, 1.0);
    vec3 canvas = on_screen(mean);
    screen_colour = vec4(mix(around, canvas, share), share);
}
)";

}  // namespace

std::string canvas_fragment_shader(Look look, bool outlined) {
    return "#version 330 core\n#define LOOK " + std::to_string(static_cast<int>(look)) +
           "\n#define OUTLINED " + (outlined ? "1" : "0") + kSurface + (outlined ? kOutlineShader : "") +
           kPicture;
}

}  // namespace pastoso::screen
