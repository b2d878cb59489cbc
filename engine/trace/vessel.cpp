#include "trace/vessel.hpp"

namespace pastoso::trace {
namespace {

/// Glass has no sharp edges: over so much of its outer wall the foot is round, ...
constexpr float kFootRound_m = 0.003F;
/// ... and at the edges of lip and foot the normal has turned by an angle of this tangent.
constexpr float kRoundness = 0.8F;

}  // namespace

/// The wall is r = R + slope (z - floor); along the ray that is a t^2 + 2 b t + c = 0. In double
/// precision, as grazing rays at the glass' edge lose most of the digits.
void CupSurfaces::meet_wall(const Ray& ray, bool inner, SurfaceHit& hit) const {
    const double slope = cup_.slope, bottom = inner ? cup_.floor_m : cup_.foot_m;
    const double radius0 =
        static_cast<double>(cup_.floor_radius_m) + (inner ? 0.0 : static_cast<double>(cup_.wall_m));
    const double ox = static_cast<double>(ray.origin.x) - cup_.axis_m.x;
    const double oy = static_cast<double>(ray.origin.y) - cup_.axis_m.y;
    const double dx = ray.direction.x, dy = ray.direction.y, dz = ray.direction.z, oz = ray.origin.z;
    const double radius = radius0 + slope * (oz - cup_.floor_m);
    const double a = dx * dx + dy * dy - slope * slope * dz * dz;
    const double b = ox * dx + oy * dy - slope * radius * dz;
    const double c = ox * ox + oy * oy - radius * radius;
    const double inside_root = b * b - a * c;
    if (inside_root < 0.0) return;
    const double root = std::sqrt(inside_root);
    // Without a cancelling difference; a = 0 gives an infinity, which is no hit.
    const double q = -b - std::copysign(root, b);
    const double first = std::min(q / a, c / q), second = std::max(q / a, c / q);
    for (const double t : {first, second}) {
        if (!(t > kNearest_m && t < hit.distance)) continue;
        const double z = oz + t * dz, there = radius0 + slope * (z - cup_.floor_m);
        if (z < bottom || z > cup_.rim_m || there <= 0.0) continue;
        const double scale = 1.0 / (there * std::sqrt(1.0 + slope * slope));
        const glm::vec3 out((ox + t * dx) * scale, (oy + t * dy) * scale, -slope * there * scale);
        hit.distance = static_cast<float>(t);
        hit.kind = SurfaceKind::Clear;
        hit.decided = kGlass | kLiquid;
        hit.normal = inner ? -out : out;
        hit.shading = inner ? hit.normal : rounded_foot(out, static_cast<float>(z));
        hit.inner = kGlass;
        hit.outer = inner && z < cup_.level_m ? kLiquid : kAir;
        return;
    }
}

/// Towards the underside the outer wall turns down as if its edge were round: that is where light
/// gathers.
glm::vec3 CupSurfaces::rounded_foot(const glm::vec3& out, float z_m) const {
    const float up = (z_m - cup_.foot_m) / kFootRound_m;
    if (up >= 1.0F) return out;
    return glm::normalize(out - glm::vec3(0.0F, 0.0F, kRoundness * (1.0F - up)));
}

/// From the inner edge of the lip to the outer, its normal turns from the axis outwards.
glm::vec3 CupSurfaces::rounded_lip(const glm::vec2& place_m) const {
    const float radius = glm::length(place_m);
    const float across = 2.0F * (radius - cup_.inner_radius_m(cup_.rim_m)) / cup_.wall_m - 1.0F;
    return glm::normalize(glm::vec3(place_m * (kRoundness * across / radius), 1.0F));
}

void CupSurfaces::meet_disc(const Ray& ray, float height_m, float from_m, float to_m, unsigned below,
                            unsigned above, SurfaceHit& hit) const {
    const float t = (height_m - ray.origin.z) / ray.direction.z;
    if (!(t > kNearest_m && t < hit.distance)) return;
    const glm::vec2 place = glm::vec2(ray.origin) + glm::vec2(ray.direction) * t - cup_.axis_m;
    const float r2 = glm::dot(place, place);
    if (r2 < from_m * from_m || r2 > to_m * to_m) return;
    hit.distance = t;
    hit.kind = SurfaceKind::Clear;
    hit.decided = kGlass | kLiquid;
    hit.normal = hit.shading = {0.0F, 0.0F, 1.0F};
    hit.inner = below;
    hit.outer = above;
}

/// The height of the level at a place, and how it rises there.
float CupSurfaces::level_m(const glm::vec2& place_m, glm::vec2& slope) const {
    float height_m = cup_.level_m;
    slope = glm::vec2(0.0F);
    for (const LevelDent& dent : dents_) {
        const glm::vec2 from = (place_m - dent.at_m) / dent.radius_m;
        const float deep_m = dent.depth_m * fast_exp(-glm::dot(from, from));
        height_m -= deep_m;
        slope += from * (2.0F * deep_m / dent.radius_m);
    }
    return height_m;
}

/// From where the ray meets the level at rest by Newton's method: slopes are gentle, so that it ends
/// within a micrometre, and a ray so level that it does not has missed.
void CupSurfaces::meet_level(const Ray& ray, SurfaceHit& hit) const {
    constexpr int kRounds = 8;
    constexpr float kMet_m = 1e-6F;
    float t = (cup_.level_m - ray.origin.z) / ray.direction.z, above_m = 0.0F;
    glm::vec2 slope(0.0F);
    for (int round = 0; round < kRounds; ++round) {
        const glm::vec3 at = ray.origin + ray.direction * t;
        above_m = at.z - level_m(glm::vec2(at), slope);
        if (std::abs(above_m) < kMet_m) break;
        t -= above_m / (ray.direction.z - glm::dot(slope, glm::vec2(ray.direction)));
    }
    if (!(std::abs(above_m) < kMet_m && t > kNearest_m && t < hit.distance)) return;
    const glm::vec2 place = glm::vec2(ray.origin) + glm::vec2(ray.direction) * t - cup_.axis_m;
    const float radius = cup_.inner_radius_m(cup_.level_m);
    if (glm::dot(place, place) > radius * radius) return;
    hit.distance = t;
    hit.kind = SurfaceKind::Clear;
    hit.decided = kGlass | kLiquid;
    hit.normal = hit.shading = glm::normalize(glm::vec3(-slope, 1.0F));
    hit.inner = kLiquid;
    hit.outer = kAir;
}

CupSurfaces::CupSurfaces(const liquid::Cup& cup, std::vector<LevelDent> dents)
    : cup_(cup), dents_(std::move(dents)), lowest_(cup) {
    for (const LevelDent& dent : dents_)
        lowest_.level_m -= dent.depth_m;
    const float half = 0.5F * (cup_.rim_m - cup_.foot_m);
    const float widest = std::max(rim_radius_m(), foot_radius_m());
    ball_ = {{cup_.axis_m, cup_.foot_m + half}, std::sqrt(widest * widest + half * half)};
}

float CupSurfaces::side_area_m2() const {
    const float height = cup_.rim_m - cup_.foot_m, slant = std::sqrt(1.0F + cup_.slope * cup_.slope);
    return kPi * (rim_radius_m() + foot_radius_m()) * height * slant;
}

float CupSurfaces::hull_area_m2() const {
    const float rim = rim_radius_m(), foot = foot_radius_m();
    return side_area_m2() + kPi * (rim * rim + foot * foot);
}

CupSurfaces::HullPlace CupSurfaces::hull_place(float which, const glm::vec2& uniform) const {
    const float rim = rim_radius_m(), foot = foot_radius_m();
    const glm::vec2 turn = cos_sin_of_turns(uniform.y);
    const auto on_disc = [&](float radius, float height_m, float up) {
        const glm::vec2 place = cup_.axis_m + turn * (radius * std::sqrt(uniform.x));
        return HullPlace{{place, height_m}, {0.0F, 0.0F, up}};
    };
    const float area = which * hull_area_m2();
    if (area < kPi * rim * rim) return on_disc(rim, cup_.rim_m, 1.0F);
    if (area < kPi * (rim * rim + foot * foot)) return on_disc(foot, cup_.foot_m, -1.0F);
    // The wider a ring of the wall is, the more of its area it has.
    const float radius = std::sqrt(foot * foot + (rim * rim - foot * foot) * uniform.x);
    const bool is_upright = std::abs(rim - foot) < 1e-4F * rim;
    const float up = is_upright ? uniform.x : (radius - foot) / (rim - foot);
    const float height_m = cup_.foot_m + (cup_.rim_m - cup_.foot_m) * up;
    return {{cup_.axis_m + turn * radius, height_m}, glm::normalize(glm::vec3(turn, -cup_.slope))};
}

bool CupSurfaces::passes_by(const Ray& ray) const {
    const glm::vec3 way = ball_.middle_m - ray.origin;
    const float along = glm::dot(way, ray.direction);
    const float radius2 = 1.0001F * ball_.radius_m * ball_.radius_m;
    return glm::dot(way, way) > radius2 &&
           (along < 0.0F || glm::dot(way, way) - along * along > radius2);
}

void CupSurfaces::meet(const Ray& ray, unsigned here, SurfaceHit& hit) const {
    const bool in_tea = (here & kLiquid) != 0 && (here & kGlass) == 0;
    if (!in_tea && passes_by(ray)) return;
    const float level_radius = cup_.inner_radius_m(cup_.level_m);
    const float rim_radius = cup_.inner_radius_m(cup_.rim_m);
    const float foot_radius = cup_.inner_radius_m(cup_.foot_m) + cup_.wall_m;
    // What is round about the tea is found from within it by these three alone.
    meet_wall(ray, true, hit);
    meet_disc(ray, cup_.floor_m, 0.0F, cup_.floor_radius_m, kGlass, kLiquid, hit);
    if ((here & kGlass) == 0)
        dents_.empty() ? meet_disc(ray, cup_.level_m, 0.0F, level_radius, kLiquid, kAir, hit)
                       : meet_level(ray, hit);
    if (in_tea) return;
    meet_wall(ray, false, hit);
    float before = hit.distance;
    meet_disc(ray, cup_.rim_m, rim_radius, rim_radius + cup_.wall_m, kGlass, kAir, hit);
    if (hit.distance < before)
        hit.shading = rounded_lip(glm::vec2(ray.origin + ray.direction * hit.distance) - cup_.axis_m);
    before = hit.distance;
    meet_disc(ray, cup_.foot_m, 0.0F, foot_radius, kGlass, kAir, hit);
    if (hit.distance < before) {  // the underside looks down
        hit.normal = hit.shading = {0.0F, 0.0F, -1.0F};
    }
}

TankSurfaces::TankSurfaces(const Tank& tank) : tank_(tank) {
    const glm::vec3 low = tank.inner_low_m, high = tank.inner_high_m;
    const glm::vec3 outer_low = low - tank.wall_m;
    const glm::vec3 outer_high(high.x + tank.wall_m, high.y + tank.wall_m, high.z);
    std::size_t count = 0;
    for (const int axis : {0, 1}) {
        faces_[count++] = {axis, outer_low[axis], -1.0F, outer_low, outer_high, false};
        faces_[count++] = {axis, outer_high[axis], 1.0F, outer_low, outer_high, false};
        faces_[count++] = {axis, low[axis], 1.0F, low, high, false};
        faces_[count++] = {axis, high[axis], -1.0F, low, high, false};
    }
    faces_[count++] = {2, outer_low.z, -1.0F, outer_low, outer_high, false};
    faces_[count++] = {2, low.z, 1.0F, low, high, false};
    faces_[count++] = {2, high.z, 1.0F, outer_low, outer_high, true};
}

Ball TankSurfaces::ball() const {
    const glm::vec3 half = 0.5F * (tank_.inner_high_m - tank_.inner_low_m) + tank_.wall_m;
    return {0.5F * (tank_.inner_high_m + tank_.inner_low_m), glm::length(half)};
}

void TankSurfaces::meet(const Ray& ray, SurfaceHit& hit) const {
    for (const Face& face : faces_) {
        const float t = (face.place_m - ray.origin[face.axis]) / ray.direction[face.axis];
        if (!(t > kNearest_m && t < hit.distance)) continue;
        const glm::vec3 place = ray.origin + ray.direction * t;
        bool within = true, in_hole = face.has_hole;
        for (int axis = 0; axis < 3; ++axis) {
            if (axis == face.axis) continue;
            within = within && place[axis] >= face.low_m[axis] && place[axis] <= face.high_m[axis];
            in_hole = in_hole && place[axis] > tank_.inner_low_m[axis] &&
                      place[axis] < tank_.inner_high_m[axis];
        }
        if (!within || in_hole) continue;
        hit.distance = t;
        hit.kind = SurfaceKind::Clear;
        hit.decided = kGlass;
        hit.normal = glm::vec3(0.0F);
        hit.normal[face.axis] = face.outward;
        hit.shading = hit.normal;
        hit.inner = kGlass;
        hit.outer = kAir;
    }
}

}  // namespace pastoso::trace
