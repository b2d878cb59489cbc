#include "graphics/finish_shader.hpp"

namespace pastoso::graphics {

const char* const kCoveringVertexShader = R"(#version 330 core
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

// The names are those of pigment/colour_cube.hpp and appearance/dither.hpp. The picture's first row is
// the window's top, OpenGL's is the bottom.
const char* const kFinishShader = R"(#version 330 core
uniform sampler2D picture;   // alpha: share that the cube is for, the rest is as it is to be seen
uniform sampler3D cube;      // alpha: outside
uniform int cube_last;       // node along a side; 0 without a cube
uniform vec3 gamut_mark;
uniform int window_height;
uniform float levels;        // of the window, less one
out vec4 colour;

vec3 shown_by_cube(vec3 encoded) {
    vec3 along = float(cube_last) * sqrt(clamp(encoded, 0.0, 1.0));
    ivec3 first = min(ivec3(along), cube_last - 1);
    vec3 share = along - vec3(first);
    ivec3 top = share.r >= share.g ? (share.r >= share.b ? ivec3(1, 0, 0) : ivec3(0, 0, 1))
                                   : (share.g >= share.b ? ivec3(0, 1, 0) : ivec3(0, 0, 1));
    ivec3 low = share.r < share.g ? (share.r < share.b ? ivec3(1, 0, 0) : ivec3(0, 0, 1))
                                  : (share.g < share.b ? ivec3(0, 1, 0) : ivec3(0, 0, 1));
    float most = max(share.r, max(share.g, share.b));
    float least = min(share.r, min(share.g, share.b));
    float between = max(min(share.r, share.g), min(max(share.r, share.g), share.b));
    vec4 found = (1.0 - most) * texelFetch(cube, first, 0) + (most - between) * texelFetch(cube, first + top, 0) +
                 (between - least) * texelFetch(cube, first + 1 - low, 0) + least * texelFetch(cube, first + 1, 0);
    return found.a > 0.0 ? gamut_mark : found.rgb;
}

float dither_threshold(ivec2 px) {
    int order = 0;
    for (int bit = 0; bit < 3; ++bit)
        order = order << 2 | ((px.x ^ px.y) >> bit & 1) << 1 | (px.y >> bit & 1);
    return (float(order) + 0.5) / 64.0;
}

void main() {
    ivec2 px = ivec2(gl_FragCoord.x, float(window_height) - gl_FragCoord.y);
    vec4 here = texelFetch(picture, px, 0);
    vec3 seen = here.rgb;
    if (cube_last > 0 && here.a > 0.0) seen = mix(seen, shown_by_cube(seen), here.a);
    colour = vec4(floor(levels * seen + dither_threshold(px)) / levels, 1.0);
}
)";

}  // namespace pastoso::graphics
