#include "glass/tea_shader.hpp"

namespace pastoso::glass {

const char* const kCupShader = R"(
uniform vec2 axis_m;
uniform float floor_m, floor_radius_m, slope, level_m, wall_m, foot_m, rim_m;
uniform float box_m;

const int AIR = 0, GLASS = 1, TEA = 2, NOTHING = 3;
const float IOR[3] = float[3](1.0, 1.5, 1.335);
const vec3 TEA_PER_M = vec3(4.5, 17.0, 48.0);
const float NEAR_M = 2e-5, FAR = 1e9;

struct Meeting {
    float way;     // along the ray
    vec3 normal;   // out of `below`
    int below, above;
};

float radius_at(float z) { return floor_radius_m + slope * (z - floor_m); }

void meet_wall(vec3 from, vec3 way, bool inner, inout Meeting first) {
    float radius0 = floor_radius_m + (inner ? 0.0 : wall_m), bottom = inner ? floor_m : foot_m;
    vec2 o = from.xy - axis_m;
    float radius = radius0 + slope * (from.z - floor_m);
    float a = dot(way.xy, way.xy) - slope * slope * way.z * way.z;
    float b = dot(o, way.xy) - slope * radius * way.z;
    float c = dot(o, o) - radius * radius;
    float in_root = b * b - a * c;
    if (in_root < 0.0) return;
    float q = -b - (b < 0.0 ? -1.0 : 1.0) * sqrt(in_root);
    float t0 = q / a, t1 = c / q;
    vec2 both = vec2(min(t0, t1), max(t0, t1));
    for (int i = 0; i < 2; ++i) {
        float t = both[i];
        if (!(t > NEAR_M && t < first.way)) continue;
        float z = from.z + t * way.z;
        if (z < bottom || z > rim_m) continue;
        float there = radius0 + slope * (z - floor_m);
        vec3 out_normal = normalize(vec3((o + t * way.xy) / there, -slope));
        first = Meeting(t, inner ? -out_normal : out_normal, GLASS, inner && z < level_m ? TEA : AIR);
        return;
    }
}
)";

const char* const kTeaLightShader = R"(
uniform float layer;                      // of the volume, in units of place
uniform sampler3D to_lamp_m, to_level_m;

const float LAMP_SHARE = 1.6, SKY_SHARE = 1.4;  // so that view and traced picture are as bright

/// How far it is through tea towards the lamp.
float tea_to_lamp(vec3 at) {
    Meeting end = Meeting((level_m - at.z) / LAMP_WAY.z, vec3(0.0), NOTHING, NOTHING);
    meet_wall(at, LAMP_WAY, true, end);
    return clamp(end.way, 0.0, 0.2);
}

/// What a sheet of so much milk lets through, none of which it absorbs.
float through_milk(sampler3D depth_m, vec3 at) {
    return 1.0 / (1.0 + 0.75 * MILK_PER_M * texture(depth_m, at / box_m).r);
}

/// The light that arrives at a place in the tea, from the lamp and from all around.
vec3 light_at(vec3 at) {
    float wall = max(radius_at(at.z) - distance(at.xy, axis_m), 0.0);
    float near_m = min(min(wall, level_m - at.z) + 0.002, 0.02);
    vec3 lamp = LAMP * exp(-TEA_PER_M * tea_to_lamp(at)) * through_milk(to_lamp_m, at);
    vec3 sky = SKY * exp(-TEA_PER_M * near_m) * (0.5 + 0.5 * through_milk(to_level_m, at));
    return LAMP_SHARE * lamp + SKY_SHARE * sky;
}

void main() {
    vec3 at = box_m * vec3(place, layer);
    // What lies beyond the wall is as bright as what lies at it: it is between them that one looks.
    vec2 from = at.xy - axis_m;
    at.xy = axis_m + from * min(1.0, 0.998 * radius_at(at.z) / max(length(from), 1e-6));
    colour = vec4(light_at(at), 1.0);
}
)";

// What is simplified: a ray does not split but for the first reflections, light in the tea comes
// straight from the lamp, and milk scatters what milk in the way of lamp and sky has left, as if it were
// a plane sheet.
const char* const kTeaShader = R"(
uniform float table_m;
uniform int march_steps;                  // across the tea at its level
uniform vec3 milk_low_m, milk_high_m;     // there is none but between these
uniform sampler3D milk_share, light_in_tea;  // the light as kTeaLightShader finds it
// Of the stream in the air (liquid/tea/milk_stream.hpp). Its high is below its low where there is none.
uniform vec2 stream_at_m;
uniform float stream_lip_m, stream_high_m, stream_low_m, stream_lip_m_s, stream_lip_radius_m;
uniform float stream_end_height;          // of its round ends, of their radius
uniform float gravity_m_s2;
uniform float dent_m, dent_radius_m;      // how deep it dents the level, and how far around
// The jug (liquid/tea/jug_shape.hpp); of its profile radius, height, normal. No points: none is held.
const int MOST_POINTS = 16;
uniform int jug_points;
uniform vec4 jug_profile[MOST_POINTS];
uniform vec3 jug_mouth_m, jug_axis, jug_colour;
uniform vec2 jug_milk;                    // radius, depth
uniform vec4 pour_ball;                   // around all of them, its radius 0 where there are none

// ---- light

// The share of lamplight that the glass leaves on the table, tinted by the tea.
vec3 under_glass(vec2 at) {
    vec2 from = at - axis_m;
    vec2 away = -LAMP_WAY.xy / LAMP_WAY.z;
    float high = level_m - table_m;
    float along = clamp(dot(from, away) / dot(away, away), 0.0, high);
    float radius = radius_at(min(along + table_m, level_m)) + wall_m;
    float edge = 0.003 + 0.12 * along;
    float inside = 1.0 - smoothstep(radius - edge, radius + edge, length(from - away * along));
    vec3 through = mix(vec3(0.60, 0.42, 0.28), vec3(0.42, 0.38, 0.35), smoothstep(0.0, high, along));
    return mix(vec3(1.0), through, 0.85 * inside);
}

vec3 table(vec3 at) {
    vec2 from = at.xy - axis_m;
    float foot = radius_at(foot_m) + wall_m;
    float contact = 1.0 - 0.45 * exp(-max(length(from) - foot, 0.0) / 0.008);
    return table_at(from, 9.0) * (LAMP * LAMP_WAY.z * 0.95 * under_glass(at.xy) + SKY * contact) * 0.98;
}

vec3 surroundings(vec3 from, vec3 way) {
    float along = (table_m - from.z) / way.z;
    vec3 at = from + way * along;
    return along > 0.0 && distance(at.xy, axis_m) < 1.2 ? table(at) : sky(way);
}

// ---- what is met

void meet_disc(vec3 from, vec3 way, float z, float least, float most, float looks, int below, int above,
               inout Meeting first) {
    float t = (z - from.z) / way.z;
    if (!(t > NEAR_M && t < first.way)) return;
    float r = distance(from.xy + way.xy * t, axis_m);
    if (r < least || r > most) return;
    first = Meeting(t, vec3(0.0, 0.0, looks), below, above);
}

/// As if the level were dented (trace/scene.hpp): it shows by its normal.
vec3 level_normal(vec3 at) {
    vec2 out_of = (at.xy - stream_at_m) / dent_radius_m;
    return normalize(vec3(-out_of * (2.0 * dent_m / dent_radius_m * exp(-dot(out_of, out_of))), 1.0));
}

Meeting meet(vec3 from, vec3 way, int here) {
    Meeting first = Meeting(FAR, vec3(0.0), NOTHING, NOTHING);
    meet_wall(from, way, true, first);
    meet_disc(from, way, floor_m, 0.0, floor_radius_m, 1.0, GLASS, TEA, first);
    if (here != GLASS) meet_disc(from, way, level_m, 0.0, radius_at(level_m), 1.0, TEA, AIR, first);
    if (first.below == TEA && first.above == AIR) first.normal = level_normal(from + way * first.way);
    if (here == TEA) return first;
    meet_wall(from, way, false, first);
    float rim = radius_at(rim_m);
    meet_disc(from, way, rim_m, rim, rim + wall_m, 1.0, GLASS, AIR, first);
    meet_disc(from, way, foot_m, 0.0, radius_at(foot_m) + wall_m, -1.0, GLASS, AIR, first);
    return first;
}

// ---- milk

float share(vec3 at) { return clamp(texture(milk_share, at / box_m).r, 0.0, 1.0); }

/// What thick tea of that much milk gives back (Kubelka and Munk, scattering 3/4 of the reduced one).
vec3 cloud(float part) {
    vec3 x = 2.0 * (1.0 - part) * TEA_PER_M / (0.75 * MILK_PER_M * max(part, 1e-5));
    return MILK * (1.0 + x - sqrt(x * x + 2.0 * x));
}

/// A thin veil gives back what it scatters once, a quarter of what it does where it is thick.
float scattered_again(float part) { return 1.0 - 0.35 * exp(-MILK_PER_M * 0.006 * part); }

void through_tea(vec3 from, vec3 way, float length_m, float grain_here, inout vec3 weight, inout vec3 light) {
    // Clear tea before and behind the milk takes one step each.
    vec3 to_low = (milk_low_m - from) / way, to_high = (milk_high_m - from) / way;
    vec3 near = min(to_low, to_high), far = max(to_low, to_high);
    float begin = clamp(max(near.x, max(near.y, near.z)), 0.0, length_m);
    float end = clamp(min(far.x, min(far.y, far.z)), begin, length_m);
    weight *= exp(-TEA_PER_M * begin);
    int steps = int(ceil((end - begin) * float(march_steps) / (2.0 * radius_at(level_m))));
    float part_m = (end - begin) / float(max(steps, 1));
    vec3 clear = exp(-TEA_PER_M * part_m);
    for (int i = 0; i < steps; ++i) {
        vec3 at = from + way * (begin + part_m * (float(i) + grain_here));
        float milk = share(at);
        if (milk < 2e-5) {
            weight *= clear;
            continue;
        }
        vec3 left = exp(-(TEA_PER_M * (1.0 - milk) + MILK_PER_M * milk) * part_m);
        light += weight * (1.0 - left) * cloud(milk) * scattered_again(milk) * texture(light_in_tea, at / box_m).rgb;
        weight *= left;
        if (weight.r < 0.004) return;
    }
    weight *= exp(-TEA_PER_M * (length_m - end));
}

float stream_radius(float z) {
    float fallen = max(stream_lip_m - z, 0.0);
    return stream_lip_radius_m * sqrt(stream_lip_m_s / sqrt(stream_lip_m_s * stream_lip_m_s + 2.0 * gravity_m_s2 * fallen));
}

/// What stands in the air outside of the glass.
struct Body {
    float way;
    vec3 normal, colour;
};

/// Upright cylinders that come near the stream's radius at the height where the ray meets it.
void meet_stream(vec3 from, vec3 way, inout Body first) {
    vec2 o = from.xy - stream_at_m;
    float a = dot(way.xy, way.xy), b = dot(o, way.xy), o2 = dot(o, o), t = 0.0;
    if (stream_high_m <= stream_low_m || a < 1e-9) return;
    vec3 at = from - way * (b / a);
    for (int i = 0; i < 3; ++i) {
        float radius = stream_radius(at.z), in_root = b * b - a * (o2 - radius * radius);
        if (in_root < 0.0) return;
        t = (-b - sqrt(in_root)) / a;
        at = from + way * t;
    }
    if (t < NEAR_M || t > first.way || at.z < stream_low_m || at.z > stream_high_m) return;
    first = Body(t, vec3(normalize(at.xy - stream_at_m), 0.0), MILK);
}

/// The round head of milk above the lip.
void meet_head(vec3 from, vec3 way, inout Body first) {
    if (stream_high_m <= stream_low_m) return;
    vec3 scale = vec3(1.0, 1.0, 1.0 / stream_end_height) / stream_radius(stream_high_m);
    vec3 o = (from - vec3(stream_at_m, stream_high_m)) * scale, d = way * scale;
    float a = dot(d, d), b = dot(o, d), in_root = b * b - a * (dot(o, o) - 1.0);
    if (in_root < 0.0) return;
    float t = (-b - sqrt(in_root)) / a;
    vec3 at = o + d * t;
    if (t > NEAR_M && t < first.way && at.z > 0.0) first = Body(t, normalize(at * scale), MILK);
}

void meet_jug(vec3 from, vec3 way, inout Body first) {
    if (jug_points == 0) return;
    vec3 o = from - jug_mouth_m;
    float oz = dot(o, jug_axis), dz = dot(way, jug_axis);
    float milk_way = (jug_milk.y - oz) / dz;
    vec3 out_of = o + way * milk_way - jug_axis * jug_milk.y;
    if (milk_way > NEAR_M && milk_way < first.way && dot(out_of, out_of) < jug_milk.x * jug_milk.x)
        first = Body(milk_way, -jug_axis, MILK);
    vec3 across = o - jug_axis * oz, along = way - jug_axis * dz;
    float dd = dot(along, along), od = dot(across, along), oo = dot(across, across);
    for (int n = 0; n + 1 < jug_points; ++n) {
        vec4 low = jug_profile[n], high = jug_profile[n + 1];
        float widens = (high.x - low.x) / (high.y - low.y), radius = low.x + widens * (oz - low.y);
        float a = dd - widens * widens * dz * dz, b = od - widens * radius * dz;
        float in_root = b * b - a * (oo - radius * radius);
        if (in_root < 0.0) continue;
        float t = (-b - sqrt(in_root)) / a, up = (oz + t * dz - low.y) / (high.y - low.y);
        if (!(t > NEAR_M && t < first.way && up >= 0.0 && up <= 1.0)) continue;
        vec2 normal = mix(low.zw, high.zw, up);
        first = Body(t, normalize(normalize(across + along * t) * normal.x + jug_axis * normal.y), jug_colour);
    }
}

vec3 body_light(Body body) {
    return body.colour * (LAMP * max(0.0, (dot(body.normal, LAMP_WAY) + 0.3) / 1.3) + SKY);
}

bool misses(vec3 from, vec3 way, vec3 middle, float radius) {
    vec3 to_middle = middle - from;
    float along = dot(to_middle, way);
    return dot(to_middle, to_middle) - along * along > 1.001 * radius * radius;
}

/// Most pixels show the table alone.
bool misses_glass(vec3 from, vec3 way) {
    float half_height = 0.5 * (rim_m - foot_m);
    float widest = max(radius_at(rim_m), radius_at(foot_m)) + wall_m;
    return misses(from, way, vec3(axis_m, foot_m + half_height), length(vec2(widest, half_height)));
}

vec3 trace(vec3 from, vec3 way, float grain_here) {
    vec3 light = vec3(0.0), weight = vec3(1.0), normal;
    Body body;
    bool no_pour = pour_ball.w == 0.0 || misses(from, way, pour_ball.xyz, pour_ball.w);
    int here = AIR, end = no_pour && misses_glass(from, way) ? AROUND : NOWHERE;
    for (int event = 0; event < 9 && end == NOWHERE; ++event) {
        Meeting next = meet(from, way, here);
        if (here == AIR && pour_ball.w > 0.0) {
            body = Body(next.way, vec3(0.0), vec3(0.0));
            meet_stream(from, way, body);
            meet_head(from, way, body);
            meet_jug(from, way, body);
            if (body.way < next.way) {
                end = SOLID_BODY;
                break;
            }
        }
        if (next.way == FAR) {
            end = AROUND;
            break;
        }
        if (here == TEA) through_tea(from, way, next.way, grain_here, weight, light);
        if (here == GLASS) weight *= exp(-GLASS_PER_M * next.way);
        if (is_dark(weight)) end = DARK;
        from += way * next.way;
        bool inwards = dot(way, next.normal) < 0.0;
        int there = inwards ? next.below : next.above;
        here = inwards ? next.above : next.below;
        normal = inwards ? next.normal : -next.normal;
        float cosine = min(-dot(way, normal), 1.0), back = fresnel(cosine, IOR[here], IOR[there]);
        if (back > 0.999) {
            way = reflect(way, normal);
        } else {
            if (event < 3 && here != TEA) light += weight * back * sky(reflect(way, normal));
            weight *= 1.0 - back;
            way = normalize(refract(way, normal, IOR[here] / IOR[there]));
            here = there;
        }
        from += way * 2e-6;
    }
    // Once, and not at each event: software that draws goes through all that stands in a loop, for every ray.
    if (end == AROUND) light += weight * surroundings(from, way);
    if (end == SOLID_BODY) light += weight * body_light(body);
    if (end == NOWHERE) light += weight * SKY * vec3(0.8, 0.55, 0.3);
    return light;
}
)";

}  // namespace pastoso::glass
