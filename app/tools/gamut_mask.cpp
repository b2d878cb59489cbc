#include "tools/gamut_mask.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pastoso::tools {
namespace {

/// Sides of what stands for a circle.
constexpr int kCircleSides = 64;

glm::dvec2 at(double radius, double angle_deg) {
    const double angle = core::radians(angle_deg);
    return radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

/// From the middle of the disc to its rim, so that it is of one mood and ends in grey.
std::vector<glm::dvec2> circle(double turn_deg) {
    std::vector<glm::dvec2> corners;
    for (int i = 0; i < kCircleSides; ++i)
        corners.push_back(at(0.5, turn_deg) + at(0.5, turn_deg + 360.0 * i / kCircleSides));
    return corners;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

glm::dvec2 nearest_on(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& place) {
    const glm::dvec2 way = to - from;
    return from + std::clamp(glm::dot(place - from, way) / glm::dot(way, way), 0.0, 1.0) * way;
}

bool holds(const std::vector<glm::dvec2>& outline, const glm::dvec2& place) {
    constexpr double kOnTheLine = 1e-9;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2& from = outline[i];
        const glm::dvec2& to = outline[(i + 1) % outline.size()];
        if (cross(to - from, place - from) < -kOnTheLine) return false;
    }
    return true;
}

glm::dvec2 turned(const glm::dvec2& place, double turn_deg) {
    const glm::dvec2 way = at(1.0, turn_deg);
    return {way.x * place.x - way.y * place.y, way.y * place.x + way.x * place.y};
}

bool is_convex(const std::vector<glm::dvec2>& outline) {
    constexpr double kFlat = 1e-3;
    const std::size_t count = outline.size();
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2& corner = outline[(i + 1) % count];
        if (cross(corner - outline[i], outline[(i + 2) % count] - corner) < kFlat) return false;
    }
    return true;
}

std::vector<glm::dvec2> own_outline(MaskShape shape, double turn) {
    switch (shape) {
        case MaskShape::Triad:
            return {at(1.0, turn), at(1.0, turn + 120.0), at(1.0, turn + 240.0)};
        case MaskShape::AtmosphericTriad:
            return {at(1.0, turn), at(0.6, turn + 100.0), at(0.6, turn + 260.0)};
        case MaskShape::SplitComplementary:
            return {at(1.0, turn), at(0.3, turn + 75.0), at(1.0, turn + 150.0), at(1.0, turn + 210.0),
                    at(0.3, turn + 285.0)};
        case MaskShape::Complementary:
            return {at(1.0, turn), at(0.25, turn + 90.0), at(1.0, turn + 180.0), at(0.25, turn + 270.0)};
        case MaskShape::Circle:
            return circle(turn);
        case MaskShape::None:
            break;
    }
    return {};
}

}  // namespace

glm::dvec2 disc_place(const Channels& oklch) {
    const double most = most_chroma(oklch[0], oklch[2]);
    return at(most > 0.0 ? std::min(oklch[1] / most, 1.0) : 0.0, oklch[2]);
}

Channels colour_on_disc(double lightness, const glm::dvec2& place, double hue_deg) {
    const double saturation = std::min(glm::length(place), 1.0);
    if (saturation > 0.0) hue_deg = turned_deg(core::degrees(std::atan2(place.y, place.x)));
    return {lightness, saturation * most_chroma(lightness, hue_deg), hue_deg};
}

std::vector<glm::dvec2> mask_outline(const GamutMask& mask) {
    if (mask.corners.empty()) return own_outline(mask.shape, mask.turn_deg);
    std::vector<glm::dvec2> outline;
    for (const glm::dvec2& corner : mask.corners)
        outline.push_back(turned(corner, mask.turn_deg));
    return outline;
}

std::size_t movable_corners(MaskShape shape) {
    return shape == MaskShape::Circle ? 0 : own_outline(shape, 0.0).size();
}

bool are_corners(const std::vector<glm::dvec2>& corners, MaskShape shape) {
    constexpr double kRim = 1.0 + 1e-9;
    return !corners.empty() && corners.size() == movable_corners(shape) && is_convex(corners) &&
           std::all_of(corners.begin(), corners.end(),
                       [](const glm::dvec2& corner) { return glm::length(corner) <= kRim; });
}

GamutMask with_corner(const GamutMask& mask, std::size_t corner, const glm::dvec2& place) {
    GamutMask moved = mask;
    if (moved.corners.empty()) moved.corners = own_outline(mask.shape, 0.0);
    moved.corners.at(corner) = turned(place / std::max(1.0, glm::length(place)), -mask.turn_deg);
    return are_corners(moved.corners, mask.shape) ? moved : mask;
}

glm::dvec2 held_inside(const std::vector<glm::dvec2>& outline, const glm::dvec2& place) {
    if (holds(outline, place)) return place;
    glm::dvec2 nearest = outline.front();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 here = nearest_on(outline[i], outline[(i + 1) % outline.size()], place);
        if (glm::distance(here, place) < glm::distance(nearest, place)) nearest = here;
    }
    return nearest;
}

Channels held_in_mask(const GamutMask& mask, const Channels& oklch) {
    const glm::dvec2 place = disc_place(oklch);
    const glm::dvec2 held = held_inside(mask_outline(mask), place);
    return held == place ? oklch : colour_on_disc(oklch[0], held, oklch[2]);
}

}  // namespace pastoso::tools
