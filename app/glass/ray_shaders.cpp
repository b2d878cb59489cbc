#include "glass/ray_shaders.hpp"

namespace pastoso::glass {

const char* const kRayVertexShader = R"(#version 330 core
out vec2 place;
void main() {
    place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(2.0 * place - 1.0, 0.0, 1.0);
}
)";

// Optics, light and tone are those of the tracer (trace/scene.hpp, trace/picture.hpp): a picture that is
// traced looks like what was seen before, only better.
const char* const kLightShader = R"(#version 330 core
in vec2 place;
out vec4 colour;

uniform vec3 eye_m, forward, right, up;   // right and up: to the edges of the picture, at distance 1
uniform vec2 shift;                       // within the pixel, in units of place
uniform float grain;                      // of this pass, 0 to 1

const vec3 GLASS_PER_M = vec3(2.2, 0.9, 1.4);
const float MILK_PER_M = 3000.0;
const vec3 MILK = vec3(0.97, 0.94, 0.86);
const vec3 LAMP_WAY = normalize(vec3(-0.55, -0.5, 0.85));
const vec3 LAMP = vec3(1.35, 1.28, 1.17);  // what white, facing it, gives back
const vec3 SKY = vec3(0.62, 0.64, 0.68);   // the same of all the sky
const vec3 TABLE = vec3(0.50, 0.40, 0.30);

vec3 sky(vec3 way) {
    float height = 0.5 * (way.z + 1.0);
    vec3 light = mix(vec3(0.44, 0.456, 0.496), vec3(0.76, 0.784, 0.84), height);
    float window = clamp((dot(way, normalize(vec3(0.9, -0.3, 0.25))) - 0.9003) / (0.9436 - 0.9003), 0.0, 1.0);
    return light + 1.28 * window * window * (3.0 - 2.0 * window);
}

uint scrambled(uint x) {
    x = (x ^ (x >> 16)) * 0x7feb352dU;
    x = (x ^ (x >> 15)) * 0x846ca68bU;
    return x ^ (x >> 16);
}

float uniform_noise(uint index, uint stream) {
    return float(scrambled((index * 0x9E3779B9U) ^ scrambled(stream)) >> 8) / 16777216.0;
}

float wave(float turns) { return sin(6.2831853 * fract(turns)); }

/// The grain of a table of boards (trace/wood.hpp), place in metres from the vessel's middle.
float wood_grain(vec2 at) {
    float board = floor(at.y / 0.085), across = at.y - board * 0.085;
    if (across < 0.0007) return 0.55;
    float shift = uniform_noise(uint(int(board)), 2U);
    float tone = 0.93 + 0.14 * uniform_noise(uint(int(board)), 1U);
    float along = at.x + 5.0 * shift;
    float bend = 0.006 * wave(1.9 * along) + 0.002 * wave(7.3 * along + shift);
    float late = fract(150.0 * (across + bend) + 1.3 * wave(21.0 * across + shift));
    float fibres = wave(1100.0 * across + 3.0 * wave(11.0 * along)) * wave(23.0 * along + 40.0 * across);
    return tone * (1.05 - 0.2 * late * late * late + 0.025 * fibres);
}

/// What the table gives back, place in metres from the vessel's middle: its colour fades as lamplight does.
vec3 table_at(vec2 at, float fading_per_m2) {
    return TABLE * wood_grain(at) * (0.55 + 0.45 * exp(-fading_per_m2 * dot(at, at)));
}

/// Where a ray has ended: nowhere yet, in what is around, at something solid, or what it has left is not seen.
const int NOWHERE = 0, AROUND = 1, SOLID_BODY = 2, DARK = 3;

bool is_dark(vec3 weight) { return max(weight.r, max(weight.g, weight.b)) < 0.004; }

float fresnel(float cosine, float from, float to) {
    float ratio = from / to, sine2 = ratio * ratio * max(0.0, 1.0 - cosine * cosine);
    if (sine2 >= 1.0) return 1.0;
    float beyond = sqrt(1.0 - sine2);
    float s = (from * cosine - to * beyond) / (from * cosine + to * beyond);
    float p = (to * cosine - from * beyond) / (to * cosine + from * beyond);
    return 0.5 * (s * s + p * p);
}

vec3 toned(vec3 light) {
    vec3 v = 0.95 * max(light, 0.0);
    v = min(1.25 * v * (1.0 + 0.12 * v) / (1.0 + 0.55 * v), 1.0);
    return mix(1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055, 12.92 * v, lessThan(v, vec3(0.0031308)));
}
)";

const char* const kMainShader = R"(
void main() {
    vec2 at = 2.0 * (place + shift) - 1.0;
    vec3 way = normalize(forward + right * at.x + up * at.y);
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))) + grain);
    colour = vec4(toned(trace(eye_m, way, noise)), 1.0);
}
)";

}  // namespace pastoso::glass
