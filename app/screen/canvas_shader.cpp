#include "screen/canvas_shader.hpp"

namespace pastoso::screen {

const char* const kMovedFragmentShader = R"(#version 330 core
uniform sampler2D picture;
uniform vec2 size_px;
uniform vec2 origin_px;  // where the corner of this picture was in that
uniform mat2 per_px;
uniform vec3 ground;
out vec4 colour;
void main() {
    vec2 px = origin_px + per_px * gl_FragCoord.xy;
    bool inside = all(greaterThanEqual(px, vec2(0.0))) && all(lessThanEqual(px, size_px));
    colour = inside ? texture(picture, px / size_px) : vec4(ground, 0.0);
}
)";

const char* const kLineVertexShader = R"(#version 330 core
layout(location = 0) in vec2 place_mm;
uniform vec2 origin_px;
uniform mat2 px_from_mm;
uniform vec2 window_px;
void main() {
    vec2 share = (origin_px + px_from_mm * place_mm) / window_px;
    gl_Position = vec4(2.0 * share.x - 1.0, 1.0 - 2.0 * share.y, 0.0, 1.0);
}
)";

const char* const kLineFragmentShader = R"(#version 330 core
uniform vec4 line_colour;
uniform float dash_px;
uniform vec2 dash_way;  // y up, at half a right angle to the lines
out vec4 colour;
void main() {
    bool dark = dash_px > 0.0 && mod(dot(dash_way, gl_FragCoord.xy), 2.0 * dash_px) < dash_px;
    colour = dark ? vec4(0.0, 0.0, 0.0, line_colour.a) : line_colour;
}
)";

}  // namespace pastoso::screen
