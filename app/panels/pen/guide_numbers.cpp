#include "panels/pen/guide_numbers.hpp"

#include "core/units.hpp"

#include <cmath>
#include <variant>

#include <QtGlobal>

namespace pastoso::panels {
namespace {

using brush::EllipseCurve;
using brush::Grid;
using brush::PenGuide;
using brush::VanishingPoints;
using tools::GuideKind;
using enum GuideUnit;

template <class Member>
struct FormOf;
template <class Form>
struct FormOf<double Form::*> {
    using Type = Form;
};

/// A member of the guide's form, times what the panel shows of it.
template <auto kMember, int kTimes = 1>
double get(const PenGuide& guide) {
    return kTimes * (std::get<typename FormOf<decltype(kMember)>::Type>(guide.form).*kMember);
}
template <auto kMember, int kTimes = 1>
void set(PenGuide& guide, double value) {
    std::get<typename FormOf<decltype(kMember)>::Type>(guide.form).*kMember = value / kTimes;
}

template <auto kMember>
void set_point(PenGuide& guide, double value) {
    set<kMember>(guide, value);
    auto& points = std::get<VanishingPoints>(guide.form);
    points = tools::with_horizon(points);
}

void set_level(PenGuide& guide, double value) {
    set<&VanishingPoints::level_deg>(guide, value);
    set<&VanishingPoints::upright_deg>(guide, value + 90.0);
}

/// A ruler by its middle and its slope; it stays as long as it is.
struct RulerNumbers {
    double x_mm, y_mm, slope_deg;

    explicit RulerNumbers(const PenGuide& guide) {
        const auto& ruler = std::get<brush::Ruler>(guide.form);
        x_mm = 0.5 * (ruler.x1_mm + ruler.x2_mm);
        y_mm = 0.5 * (ruler.y1_mm + ruler.y2_mm);
        slope_deg = core::degrees(std::atan2(ruler.y2_mm - ruler.y1_mm, ruler.x2_mm - ruler.x1_mm));
    }
    brush::Ruler ruler(double half_mm) const {
        const double x = half_mm * std::cos(core::radians(slope_deg)),
                     y = half_mm * std::sin(core::radians(slope_deg));
        return {x_mm - x, y_mm - y, x_mm + x, y_mm + y};
    }
};

template <double RulerNumbers::*kNumber>
double get_of_ruler(const PenGuide& guide) {
    return RulerNumbers(guide).*kNumber;
}
template <double RulerNumbers::*kNumber>
void set_of_ruler(PenGuide& guide, double value) {
    auto& ruler = std::get<brush::Ruler>(guide.form);
    RulerNumbers numbers(guide);
    numbers.*kNumber = value;
    ruler = numbers.ruler(0.5 * std::hypot(ruler.x2_mm - ruler.x1_mm, ruler.y2_mm - ruler.y1_mm));
}

double get_reach(const PenGuide& guide) {
    return guide.reach_mm;
}
void set_reach(PenGuide& guide, double value) {
    guide.reach_mm = value;
}

constexpr double kFar_mm = 5000.0, kShortest_mm = 1.0, kHalfTurn_deg = 180.0;
constexpr auto kRulers = {GuideKind::Ruler, GuideKind::ParallelRuler};
constexpr auto kEllipses = {GuideKind::Ellipse, GuideKind::ConcentricEllipse};
constexpr auto kOne = {GuideKind::OnePoint};
constexpr auto kAny = {GuideKind::OnePoint, GuideKind::TwoPoints, GuideKind::ThreePoints};
constexpr auto kTwo = {GuideKind::TwoPoints, GuideKind::ThreePoints};
constexpr auto kThree = {GuideKind::ThreePoints};
constexpr auto kGrids = {GuideKind::Grid};
constexpr auto kReaching = {GuideKind::Ruler, GuideKind::Ellipse, GuideKind::Grid};

constexpr GuideNumber kNumbers[] = {
    {"ruler_x", QT_TR_NOOP("Middle, from the left"), Millimetres, -kFar_mm, kFar_mm, kRulers,
     get_of_ruler<&RulerNumbers::x_mm>, set_of_ruler<&RulerNumbers::x_mm>},
    {"ruler_y", QT_TR_NOOP("Middle, from above"), Millimetres, -kFar_mm, kFar_mm, kRulers,
     get_of_ruler<&RulerNumbers::y_mm>, set_of_ruler<&RulerNumbers::y_mm>},
    {"ruler_angle", QT_TR_NOOP("Slope"), Degrees, -kHalfTurn_deg, kHalfTurn_deg, kRulers,
     get_of_ruler<&RulerNumbers::slope_deg>, set_of_ruler<&RulerNumbers::slope_deg>},
    {"ellipse_x", QT_TR_NOOP("Middle, from the left"), Millimetres, -kFar_mm, kFar_mm, kEllipses,
     get<&EllipseCurve::centre_x_mm>, set<&EllipseCurve::centre_x_mm>},
    {"ellipse_y", QT_TR_NOOP("Middle, from above"), Millimetres, -kFar_mm, kFar_mm, kEllipses,
     get<&EllipseCurve::centre_y_mm>, set<&EllipseCurve::centre_y_mm>},
    {"ellipse_width", QT_TR_NOOP("Width"), Millimetres, kShortest_mm, kFar_mm, kEllipses,
     get<&EllipseCurve::half_width_mm, 2>, set<&EllipseCurve::half_width_mm, 2>},
    {"ellipse_height", QT_TR_NOOP("Height"), Millimetres, kShortest_mm, kFar_mm, kEllipses,
     get<&EllipseCurve::half_height_mm, 2>, set<&EllipseCurve::half_height_mm, 2>},
    {"ellipse_turn", QT_TR_NOOP("Turned by"), Degrees, -kHalfTurn_deg, kHalfTurn_deg, kEllipses,
     get<&EllipseCurve::turn_deg>, set<&EllipseCurve::turn_deg>},
    {"first_point_x", QT_TR_NOOP("First point, from the left"), Millimetres, -kFar_mm, kFar_mm, kAny,
     get<&VanishingPoints::x1_mm>, set_point<&VanishingPoints::x1_mm>},
    {"first_point_y", QT_TR_NOOP("First point, from above"), Millimetres, -kFar_mm, kFar_mm, kAny,
     get<&VanishingPoints::y1_mm>, set_point<&VanishingPoints::y1_mm>},
    {"second_point_x", QT_TR_NOOP("Second point, from the left"), Millimetres, -kFar_mm, kFar_mm, kTwo,
     get<&VanishingPoints::x2_mm>, set_point<&VanishingPoints::x2_mm>},
    {"second_point_y", QT_TR_NOOP("Second point, from above"), Millimetres, -kFar_mm, kFar_mm, kTwo,
     get<&VanishingPoints::y2_mm>, set_point<&VanishingPoints::y2_mm>},
    {"third_point_x", QT_TR_NOOP("Third point, from the left"), Millimetres, -kFar_mm, kFar_mm, kThree,
     get<&VanishingPoints::x3_mm>, set_point<&VanishingPoints::x3_mm>},
    {"third_point_y", QT_TR_NOOP("Third point, from above"), Millimetres, -kFar_mm, kFar_mm, kThree,
     get<&VanishingPoints::y3_mm>, set_point<&VanishingPoints::y3_mm>},
    {"horizon", QT_TR_NOOP("Slope of the horizon"), Degrees, -kHalfTurn_deg, kHalfTurn_deg, kOne,
     get<&VanishingPoints::level_deg>, set_level},
    {"grid_x", QT_TR_NOOP("Crossing, from the left"), Millimetres, -kFar_mm, kFar_mm, kGrids,
     get<&Grid::x_mm>, set<&Grid::x_mm>},
    {"grid_y", QT_TR_NOOP("Crossing, from above"), Millimetres, -kFar_mm, kFar_mm, kGrids,
     get<&Grid::y_mm>, set<&Grid::y_mm>},
    {"grid_direction", QT_TR_NOOP("Slope of the first lines"), Degrees, -kHalfTurn_deg, kHalfTurn_deg,
     kGrids, get<&Grid::direction_deg>, set<&Grid::direction_deg>},
    {"grid_spacing", QT_TR_NOOP("Spacing of the first lines"), Millimetres, kShortest_mm, kFar_mm,
     kGrids, get<&Grid::spacing_mm>, set<&Grid::spacing_mm>},
    {"grid_other_direction", QT_TR_NOOP("Slope of the others"), Degrees, -kHalfTurn_deg, kHalfTurn_deg,
     kGrids, get<&Grid::other_direction_deg>, set<&Grid::other_direction_deg>},
    {"grid_other_spacing", QT_TR_NOOP("Spacing of the others"), Millimetres, kShortest_mm, kFar_mm,
     kGrids, get<&Grid::other_spacing_mm>, set<&Grid::other_spacing_mm>},
    {"guide_reach", QT_TR_NOOP("Snaps within"), Millimetres, 0.1, kFar_mm, kReaching, get_reach,
     set_reach},
};

}  // namespace

std::span<const GuideNumber> guide_numbers() {
    return kNumbers;
}

}  // namespace pastoso::panels
