#include "glass/tank_shader.hpp"

namespace pastoso::glass {

// What is simplified: a ray does not split but for the first reflections, and light comes straight from
// the lamp, weakened by the liquid on its way as if that stood still.
const char* const kTankShader = R"(
uniform vec3 size_m;                // the box: from the origin
uniform float wall_m, cell_m, unit_m, rest_m;
uniform vec3 cells;
uniform vec3 liquid_per_m;
uniform int most_steps;
uniform bool has_milk, has_solids;
uniform sampler3D level, solids, milk_share;

const float FAR = 1e9;
const float MODEL_M = 0.3;  // trace::kTankModel_m
const int GLASS = 1, ROOM = 2;
const float GLASS_IOR = 1.5, LIQUID_IOR = 1.335;
const vec3 SOLID = vec3(0.70, 0.32, 0.20);  // as trace::Optics

float level_at(vec3 at) { return texture(level, (at / cell_m + 1.0) / (cells + 2.0)).r; }
float solid_at(vec3 at) { return has_solids ? texture(solids, (at / cell_m + 1.0) / (cells + 2.0)).r : FAR; }
float milk_at(vec3 at) { return has_milk ? clamp(texture(milk_share, at / size_m).r, 0.0, 1.0) : 0.0; }

vec3 level_normal(vec3 at) {
    const vec2 e = vec2(1.1, -1.1);  // wide: drops are not to be seen one by one
    return normalize(e.xyy * level_at(at + e.xyy * cell_m) + e.yyx * level_at(at + e.yyx * cell_m) +
                     e.yxy * level_at(at + e.yxy * cell_m) + e.xxx * level_at(at + e.xxx * cell_m) + 1e-9);
}

vec3 solid_normal(vec3 at) {
    const vec2 e = vec2(0.5, -0.5);
    return normalize(e.xyy * solid_at(at + e.xyy * cell_m) + e.yyx * solid_at(at + e.yyx * cell_m) +
                     e.yxy * solid_at(at + e.yxy * cell_m) + e.xxx * solid_at(at + e.xxx * cell_m) + 1e-9);
}

/// Where a ray comes into a box and leaves it; it misses where x > y.
vec2 slab(vec3 from, vec3 way, vec3 low, vec3 high, out vec3 in_normal, out vec3 out_normal) {
    vec3 at_low = (low - from) / way, at_high = (high - from) / way;
    vec3 near = min(at_low, at_high), far = max(at_low, at_high);
    float enters = max(near.x, max(near.y, near.z)), leaves = min(far.x, min(far.y, far.z));
    in_normal = -sign(way) * vec3(equal(near, vec3(enters)));
    out_normal = sign(way) * vec3(equal(far, vec3(leaves)));
    return vec2(enters, leaves);
}

float chord(vec3 from, vec3 way, vec3 low, vec3 high) {
    vec3 unused0, unused1;
    vec2 ends = slab(from, way, low, high, unused0, unused1);
    return max(0.0, ends.y - max(ends.x, 0.0));
}

// ---- light

/// What is left of lamplight at a place, after the tank and its liquid.
vec3 lamp_left(vec3 at) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 3; ++i) {
        float turn = 2.1 * float(i);
        vec3 way = normalize(LAMP_WAY + 0.13 * vec3(cos(turn), sin(turn), 0.0));
        float liquid = chord(at, way, vec3(0.0), vec3(size_m.xy, rest_m));
        float glass = min(chord(at, way, -vec3(wall_m), size_m + vec3(wall_m, wall_m, 0.0)), 4.0 * wall_m);
        sum += exp(-liquid_per_m * liquid) * (glass > 0.0 ? 0.80 : 1.0) * exp(-GLASS_PER_M * glass);
    }
    return sum / 3.0;
}

vec3 table(vec3 at) {
    vec3 stuff = table_at(MODEL_M / unit_m * (at.xy - 0.5 * size_m.xy), 2.0);
    vec2 beside = max(abs(at.xy - 0.5 * size_m.xy) - 0.5 * size_m.xy - wall_m, 0.0);
    float contact = 1.0 - 0.45 * exp(-length(beside) / (0.08 * unit_m));
    return stuff * (LAMP * LAMP_WAY.z * 0.95 * lamp_left(at) + SKY * contact) * 0.98;
}

vec3 surroundings(vec3 from, vec3 way) {
    float along = (-wall_m - from.z) / way.z;
    vec3 at = from + way * along;
    return along > 0.0 && distance(at.xy, 0.5 * size_m.xy) < 12.0 * unit_m ? table(at) : sky(way);
}

vec3 solid_light(vec3 at, vec3 normal) {
    float facing = max(dot(normal, LAMP_WAY), 0.0);
    float lit = 1.0;
    if (facing > 0.0)
        for (int i = 1; i <= 4; ++i)
            lit = min(lit, 0.25 + solid_at(at + LAMP_WAY * cell_m * float(i) * 1.5) / (cell_m * float(i)));
    float under = max(rest_m - at.z, 0.0);
    vec3 left = level_at(at + normal * cell_m) < 0.0 ? exp(-liquid_per_m * under) : vec3(1.0);
    return SOLID * left * (LAMP * facing * clamp(lit, 0.0, 1.0) + SKY * (0.66 + 0.34 * normal.z));
}

/// What thick liquid of that much milk gives back (Kubelka and Munk, scattering 3/4 of the reduced one).
vec3 cloud(float part) {
    vec3 x = 2.0 * (liquid_per_m + 8.0 * part * (1.0 - MILK)) / (0.75 * MILK_PER_M * max(part, 1e-5));
    return 1.0 + x - sqrt(x * x + 2.0 * x);
}

vec3 milk_light(vec3 normal) {
    float facing = dot(normal, LAMP_WAY);
    return LAMP * (0.85 * max(0.0, (facing + 0.3) / 1.3) + 0.10) + SKY * (0.60 + 0.40 * normal.z);
}

// ---- the box

struct Meeting {
    float way;
    vec3 normal;   // against the ray
    int what;      // 0: the end of the box, 1: the liquid's surface, 2: a solid
};

/// From a point of the box, in liquid or in air, at most `most` far. Milk on the way dims and lights.
Meeting march(vec3 from, vec3 way, float most, bool wet, vec3 from_normal, float grain_here, inout vec3 weight,
              inout vec3 light) {
    float side = wet ? -1.0 : 1.0;
    float at = 0.12 * cell_m, before = 0.0;
    bool met = false, solid = false;
    bool settled = false;  // the normal is smoother than the surface: a bent ray may begin just beyond it
    vec3 lit = milk_light(from_normal);
    for (int i = 0; i < most_steps && at < most; ++i) {
        vec3 here = from + way * at;
        float to_level = side * level_at(here), to_solid = solid_at(here);
        settled = settled || to_level > 0.0 || at > 0.8 * cell_m;
        if (!settled) to_level = 0.0;
        solid = to_solid < 0.0;
        met = solid || to_level < 0.0;
        if (met) break;
        float next = at + max(0.9 * min(to_level, to_solid), (0.30 + 0.10 * grain_here) * cell_m);
        if (wet && has_milk) next = min(next, at + 1.5 * cell_m);
        next = min(next, most);
        if (wet) {
            float milk = milk_at(here + way * 0.6 * cell_m);
            vec3 left = exp(-(liquid_per_m + MILK_PER_M * milk) * (next - before));
            if (milk > 2e-5) light += weight * (1.0 - left) * cloud(milk) * lit * MILK;
            weight *= left;
            if (is_dark(weight)) break;
        }
        before = next;
        at = next;
        if (next >= most) break;
    }
    if (!met) return Meeting(most, vec3(0.0), 0);
    float low = before, high = at;
    for (int k = 0; k < 5; ++k) {
        float middle = 0.5 * (low + high);
        vec3 there = from + way * middle;
        bool beyond = solid ? solid_at(there) < 0.0 : side * level_at(there) < 0.0;
        if (beyond) high = middle; else low = middle;
    }
    at = 0.5 * (low + high);
    vec3 there = from + way * at;
    vec3 normal = solid ? solid_normal(there) : level_normal(there);
    if (dot(normal, way) > 0.0) normal = -normal;
    return Meeting(at, normal, solid ? 2 : 1);
}

/// The ray goes where most of its light goes; true where that is through the surface. What is given back
/// is the sky's where the surface shines, and otherwise goes the same way, so that none is lost.
bool bend(inout vec3 way, vec3 normal, float here, float there, bool shines, inout vec3 weight,
          inout vec3 light) {
    float back = fresnel(clamp(-dot(way, normal), 0.0, 1.0), here, there);
    if (back > 0.5) {
        way = reflect(way, normal);
        return false;
    }
    if (shines) {
        light += weight * back * sky(reflect(way, normal));
        weight *= 1.0 - back;
    }
    way = normalize(refract(way, normal, here / there));
    return true;
}

vec3 trace(vec3 from, vec3 way, float grain_here) {
    vec3 light = vec3(0.0), weight = vec3(1.0), normal, other;
    vec3 low = -vec3(wall_m), high = vec3(size_m.xy + wall_m, size_m.z), up = vec3(0.0, 0.0, 1.0);
    int end = NOWHERE, region = GLASS;
    bool wet = false;
    vec2 whole = slab(from, way, low, high, normal, other);
    if (whole.x > whole.y || whole.x < 0.0) {
        end = AROUND;
    } else {
        from += way * whole.x;
        vec2 inside = abs(from.xy - 0.5 * size_m.xy) - 0.5 * size_m.xy;
        if (normal.z > 0.5 && max(inside.x, inside.y) < 0.0) region = ROOM;
        else if (!bend(way, normal, 1.0, GLASS_IOR, true, weight, light)) end = AROUND;
        normal = up;
    }
    for (int event = 0; event < 12 && end == NOWHERE; ++event) {
        if (region == GLASS) {
            vec3 out_normal, in_normal, unused;
            float leaves = slab(from, way, low, high, unused, out_normal).y;
            vec2 span = slab(from, way, vec3(0.0), vec3(size_m.xy, size_m.z + unit_m), in_normal, unused);
            bool enters = span.x < span.y && span.x > 1e-4 * wall_m && span.x < leaves;
            float along = enters ? span.x : leaves;
            from += way * max(along, 0.0);
            weight *= exp(-GLASS_PER_M * max(along, 0.0));
            if (enters) {
                vec3 within = from - in_normal * 0.35 * cell_m;
                wet = level_at(within) < 0.0 && from.z < size_m.z;
                if (solid_at(within) < 0.0 && from.z < size_m.z) {
                    from = within;
                    normal = in_normal;
                    end = SOLID_BODY;
                } else if (bend(way, in_normal, GLASS_IOR, wet ? LIQUID_IOR : 1.0, false, weight, light)) {
                    region = ROOM;
                    normal = in_normal;
                }
            } else if (bend(way, -out_normal, GLASS_IOR, 1.0, false, weight, light)) {
                from += way * 1e-5;
                end = AROUND;
            }
        } else {
            vec3 unused, out_normal;
            float leaves = max(slab(from, way, vec3(0.0), size_m, unused, out_normal).y, 0.0);
            Meeting next = march(from, way, leaves, wet, normal, grain_here, weight, light);
            from += way * next.way;
            float here = wet ? LIQUID_IOR : 1.0;
            if (next.what == 2) {
                normal = next.normal;
                end = SOLID_BODY;
            } else if (next.what == 1) {
                normal = next.normal;
                if (bend(way, normal, here, wet ? 1.0 : LIQUID_IOR, !wet && event < 4, weight, light)) wet = !wet;
            } else if (out_normal.z > 0.5) {
                end = AROUND;
            } else if (bend(way, -out_normal, here, GLASS_IOR, false, weight, light)) {
                region = GLASS;
            } else {
                normal = -out_normal;
            }
        }
        if (is_dark(weight)) end = DARK;
    }
    // Once, and not at each event: software that draws goes through all that stands in a loop, for every ray.
    if (end == AROUND) light += weight * surroundings(from, way);
    if (end == SOLID_BODY) light += weight * solid_light(from, normal);
    if (end == NOWHERE) light += weight * SKY * 0.7;
    return light;
}
)";

}  // namespace pastoso::glass
