#include "screen/canvas_shader.hpp"

namespace pastoso::screen {

// The names are those of shade/outline_kernel.cpp.
const char* const kOutlineShader = R"(
uniform sampler2DArray outline_layers;  // cover, share, coefficients of what is dry, 1 where outlines are near
uniform sampler2DArray dry_colours;     // and the sharpness of edges, times share
uniform float outline_strength;

// Both sides of an outline, and how much of the paint's is seen.
struct Sides {
    SurfacePoint paint, dry;
    float within;
    float strength;
};

bool outline_near(vec2 cell) {
    return texelFetch(outline_layers, texel_of(ivec2(floor(cell - 0.5))) - ivec3(1, 1, 0), 0).a > 0.5;
}

float share_within(float cover, vec2 slope) {
    float width_cells = pixel_size / (px_per_cell * float(samples_per_side));
    return clamp(0.5 + cover / (max(length(slope), 0.1) * width_cells), 0.0, 1.0);
}

float sharpness(float share, float sharp) {
    return share > 1e-5 ? min(sharp / share, 1.0) : 1.0;
}

// shade/outline_kernel.cpp; `whole` is what is there without an outline.
Sides sides_at(vec2 cell, SurfacePoint whole) {
    vec2 centred = cell - 0.5;
    vec2 corner = floor(centred);
    vec2 t = centred - corner;
    ivec3 first = texel_of(ivec2(corner)) - ivec3(1, 1, 0);
    vec4 spline_x = spline_weights(t.x), spline_y = spline_weights(t.y);
    vec4 slope_x = spline_slopes(t.x), slope_y = spline_slopes(t.y);
    vec4 bend_x = spline_bends(t.x), bend_y = spline_bends(t.y);
    vec4 colour_x = colour_weights(t.x, spline_x), colour_y = colour_weights(t.y, spline_y);
    float cover = 0.0, share = 0.0, smooth_share = 0.0, smooth_sharp = 0.0;
    vec2 cover_slope = vec2(0.0), slope = vec2(0.0);
    vec3 bend = vec3(0.0), dry_colour = vec3(0.0);
    vec4 covered = vec4(0.0);
    for (int j = 0; j < 4; ++j) {
        vec2 value_row = vec2(0.0), slope_row = vec2(0.0);
        float bend_row = 0.0, share_row = 0.0, smooth_share_row = 0.0, smooth_sharp_row = 0.0;
        vec4 covered_row = vec4(0.0);
        vec3 dry_row = vec3(0.0);
        for (int i = 0; i < 4; ++i) {
            ivec3 texel = first + ivec3(i, j, 0);
            vec3 here = texelFetch(outline_layers, texel, 0).rgb;
            value_row += spline_x[i] * here.rb;
            slope_row += slope_x[i] * here.rb;
            bend_row += bend_x[i] * here.b;
            share_row += colour_x[i] * here.g;
            covered_row += colour_x[i] * here.g * texelFetch(colour_and_wetness, texel, 0);
            vec4 dry_here = texelFetch(dry_colours, texel, 0);
            dry_row += colour_x[i] * dry_here.rgb;
            smooth_share_row += spline_x[i] * here.g;
            smooth_sharp_row += spline_x[i] * dry_here.a;
        }
        cover += spline_y[j] * value_row.x;
        cover_slope += vec2(spline_y[j] * slope_row.x, slope_y[j] * value_row.x);
        slope += vec2(spline_y[j] * slope_row.y, slope_y[j] * value_row.y);
        bend += vec3(spline_y[j] * bend_row, slope_y[j] * slope_row.y, bend_y[j] * value_row.y);
        share += colour_y[j] * share_row;
        smooth_share += spline_y[j] * smooth_share_row;
        smooth_sharp += spline_y[j] * smooth_sharp_row;
        covered += colour_y[j] * covered_row;
        dry_colour += colour_y[j] * dry_row;
    }
    covered /= max(share, 1e-3);
    SurfacePoint paint = whole, dry = whole;
    paint.colour = covered.rgb;
    paint.wetness = covered.a;
    dry.height_mm += cell_mm * 0.25 * clamp(1.0 + 2.0 * cover, 0.0, 1.0);
    dry.slope = slope / cell_mm;
    dry.bend = bend / cell_mm;
    dry.colour = dry_colour;
    dry.wetness = 0.0;
    return Sides(paint, dry, share_within(cover, cover_slope),
                 outline_strength * sharpness(smooth_share, smooth_sharp));
}
)";

}  // namespace pastoso::screen
