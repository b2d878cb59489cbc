#include "document/action_checks.hpp"

#include "brush/preset.hpp"
#include "core/check.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "document/canvas.hpp"
#include "document/layers.hpp"
#include "document/well.hpp"
#include "film/medium.hpp"
#include "pigment/paint_name.hpp"

#include <cmath>
#include <string>

namespace pastoso::document {
namespace {

void check_between(const char* what, double value, double least, double most) {
    if (value >= least && value <= most) return;
    throw core::InputError(std::string("the ") + what + " is " + core::number_text(value) +
                           ", but must lie between " + core::number_text(least) + " and " +
                           core::number_text(most) + ".");
}

/// More parts than this are a mistake of units, and tiny ones would vanish in the mixture.
constexpr double kLeastParts = 1e-6;
constexpr double kMostParts = 1e6;
constexpr double kLeastStrength = 1e-4;

/// A guide has a direction.
constexpr double kShortestGuide_mm = 0.1;
constexpr double kHuge_mm = 4.0 * kMaxPenPosition_mm;

/// Paint is never higher.
constexpr double kMostPaint_mm = 1000.0;

constexpr double kLeastPicture_mm = 0.1;

constexpr double kLongestSession_s = 7.0 * 24.0 * 3600.0;

void check_place(const std::string& what, double x_mm, double y_mm) {
    check_between(("x of the " + what + " in mm").c_str(), x_mm, -kMaxPenPosition_mm,
                  kMaxPenPosition_mm);
    check_between(("y of the " + what + " in mm").c_str(), y_mm, -kMaxPenPosition_mm,
                  kMaxPenPosition_mm);
}

struct GuideChecker {
    void operator()(std::monostate) const {}
    void operator()(const brush::StraightLine&) const {}
    void operator()(const brush::Ruler& ruler) const {
        check_place("ruler's first point", ruler.x1_mm, ruler.y1_mm);
        check_place("ruler's second point", ruler.x2_mm, ruler.y2_mm);
        const double length_mm = std::hypot(ruler.x2_mm - ruler.x1_mm, ruler.y2_mm - ruler.y1_mm);
        check_between("distance of the ruler's points in mm", length_mm, kShortestGuide_mm, kHuge_mm);
    }
    void operator()(const brush::EllipseCurve& ellipse) const {
        check_place("ellipse's centre", ellipse.centre_x_mm, ellipse.centre_y_mm);
        check_between("half width of the ellipse in mm", ellipse.half_width_mm, kShortestGuide_mm,
                      kMaxPenPosition_mm);
        check_between("half height of the ellipse in mm", ellipse.half_height_mm, kShortestGuide_mm,
                      kMaxPenPosition_mm);
        check_between("turn of the ellipse", ellipse.turn_deg, -360.0, 360.0);
    }
};

void check_range(const char* what, double least_mm, double most_mm) {
    const std::string name = what;
    check_between(("least " + name + " in mm").c_str(), least_mm, 0.0, kMostPaint_mm);
    check_between(("most " + name + " in mm").c_str(), most_mm, least_mm, kMostPaint_mm);
}

void check_outline(const std::vector<CanvasPoint>& outline) {
    check_between("number of the outline's points", static_cast<double>(outline.size()), 3.0,
                  kMostOutlinePoints);
    for (const CanvasPoint& point : outline)
        check_place("outline's point", point.x_mm, point.y_mm);
}

void check_picture(const pigment::Picture& picture) {
    check_between("width of the picture in pixels", picture.width, 1, pigment::kMostPictureSide_px);
    check_between("height of the picture in pixels", picture.height, 1, pigment::kMostPictureSide_px);
    check_between("number of the picture's pixels", 1.0 * picture.width * picture.height, 1,
                  pigment::kMostPicturePixels);
    PASTOSO_CHECK_OP(picture.rgba.size(), ==, std::size_t{4} * picture.width * picture.height);
}

void check_picture_place(const layers::PicturePlace& place) {
    check_place("picture", place.x_mm, place.y_mm);
    check_between("width of the picture in mm", place.width_mm, kLeastPicture_mm, kMaxPenPosition_mm);
    check_between("height of the picture in mm", place.height_mm, kLeastPicture_mm, kMaxPenPosition_mm);
}

void check_scale(const char* axis, double scale) {
    check_between((std::string("scale of the transform along ") + axis + ", without its sign,").c_str(),
                  std::abs(scale), kLeastScale, kMostScale);
}

struct Checker {
    void operator()(const TakeBrush& take) const {
        preset_of(take);
        if (take.size_mm != 0.0) check_between("width of the brush in mm", take.size_mm, 0.5, 200.0);
    }
    void operator()(const LoadPaint& load) const {
        check_paint(load.paint);
        check_paint(load.second);
        check_between("share of the second paint", load.second_share, 0.0, 1.0);
        check_between("variation of the share", load.share_variation, 0.0, 1.0);
        check_between("fill of the brush", load.fill, 0.0, 1.2);
    }
    void operator()(const UseMedium& use) const { film::check_numbers(medium_of(use), "the medium"); }
    void operator()(const TiltCanvas& tilt) const {
        check_between("tilt of the canvas", tilt.tilt_deg, 0.0, 90.0);
        check_between("direction of the tilt", tilt.direction_deg, -360.0, 360.0);
    }
    void operator()(const SetDrying& drying) const {
        const film::DryingAir& air = drying.air;
        check_between("speed of drying", air.speed, 0.0, kFastestDrying);
        check_between("strength of the fan", air.fan, 1.0, 1000.0);
        check_between("x of the fan in mm", air.fan_x_mm, -kMaxPenPosition_mm, kMaxPenPosition_mm);
        check_between("y of the fan in mm", air.fan_y_mm, -kMaxPenPosition_mm, kMaxPenPosition_mm);
        check_between("radius of the fan in mm", air.fan_radius_mm, 0.0, kMaxPenPosition_mm);
    }
    void operator()(const PenDown& pen) const { check_sample(pen.sample); }
    void operator()(const PenMove& pen) const { check_sample(pen.sample); }
    void operator()(const SqueezePaint& squeeze) const {
        check_paint(squeeze.paint);
        check_between("volume of the squeezed paint in mm3", squeeze.volume_mm3, kLeastSqueeze_mm3,
                      kMostSqueeze_mm3);
        check_between("x of the squeezed paint in mm", squeeze.x_mm, 0.0, kWellWidth_mm);
        check_between("y of the squeezed paint in mm", squeeze.y_mm, 0.0, kWellHeight_mm);
    }
    void operator()(const CleanWell&) const {}
    void operator()(const CleanBrush& clean) const {
        check_between("share that is wiped off the brush", clean.share, 0.0, 1.0);
    }
    void operator()(const DryNow&) const {}
    void operator()(const PenUp&) const {}
    void operator()(const Undo&) const {}
    void operator()(const Redo&) const {}
    void operator()(const SetStabiliser& set) const {
        check_between("smoothing of the stabiliser in ms", set.stabiliser.smoothing_ms, 0.0, 2000.0);
        check_between("string of the stabiliser in mm", set.stabiliser.string_mm, 0.0, 200.0);
    }
    void operator()(const AddLayer& add) const { check_look({.name = add.name}); }
    void operator()(const PaintPicture& paint) const {
        check_look({.name = paint.name});
        PASTOSO_CHECK(paint.picture != nullptr);
        check_picture(*paint.picture);
        check_picture_place(paint.place);
    }
    void operator()(const LayTracing& lay) const {
        if (!lay.picture) return;
        check_picture(*lay.picture);
        check_picture_place(lay.place);
    }
    void operator()(const SetTracing& set) const {
        check_picture_place(set.place);
        check_between("opacity of the tracing picture", set.opacity, 0.0, 1.0);
    }
    void operator()(const GroupLayers& group) const { check_look({.name = group.name}); }
    void operator()(const SetLayer& set) const { check_look(set.look); }
    void operator()(const SetGroup& set) const { check_look(set.look); }
    // Whether there is such a layer, the painting alone knows.
    void operator()(const SelectLayer&) const {}
    void operator()(const DuplicateLayer&) const {}
    void operator()(const RemoveLayer&) const {}
    void operator()(const ClearLayer&) const {}
    void operator()(const TransformLayer& move) const {
        const layers::Transform& transform = move.transform;
        check_place("transform's centre", transform.centre_x_mm, transform.centre_y_mm);
        check_place("transform's move", transform.move_x_mm, transform.move_y_mm);
        check_between("turn of the transform", transform.turn_deg, -360.0, 360.0);
        check_scale("x", transform.scale_x);
        check_scale("y", transform.scale_y);
    }
    void operator()(const MoveLayer&) const {}
    void operator()(const MergeDown&) const {}
    void operator()(const FlattenLayers&) const {}
    void operator()(const MoveGroup&) const {}
    void operator()(const UngroupLayers&) const {}
    void operator()(const SelectArea& select) const { check_outline(select.outline); }
    void operator()(const SelectByHeight& select) const {
        check_range("height", select.least_mm, select.most_mm);
    }
    void operator()(const SelectByWetness& select) const {
        check_range("thickness of wet paint", select.least_mm, select.most_mm);
    }
    void operator()(const ResizeCanvas& resize) const {
        check_place("new canvas", resize.x_mm, resize.y_mm);
        check_between("width of the new canvas in mm", resize.width_mm, kMinCanvasSide_mm,
                      kMaxCanvasSide_mm);
        check_between("height of the new canvas in mm", resize.height_mm, kMinCanvasSide_mm,
                      kMaxCanvasSide_mm);
    }
    void operator()(const InvertSelection&) const {}
    void operator()(const SelectAll&) const {}
    void operator()(const SetGuide& set) const {
        check_between("reach of the guide in mm", set.guide.reach_mm, 0.0, kMaxPenPosition_mm);
        std::visit(GuideChecker{}, set.guide.form);
    }
    void operator()(const SetSymmetry& set) const {
        check_place("centre of the symmetry", set.symmetry.centre_x_mm, set.symmetry.centre_y_mm);
        check_between("axis of the symmetry", set.symmetry.axis_deg, -360.0, 360.0);
        check_between("number of the symmetry's copies", set.symmetry.count, 1, kMostCopies);
    }
};

}  // namespace

brush::Preset preset_of(const TakeBrush& take) {
    if (take.definition.empty()) return brush::find_preset(take.preset);
    return brush::parse_preset(take.definition, "the brush \"" + take.preset + "\"");
}

film::Medium medium_of(const UseMedium& use) {
    film::Medium medium = film::find_medium(use.name);
    if (!use.own) return medium;
    PASTOSO_CHECK(use.own->name == medium.name);
    return *use.own;
}

void check_action(const Action& action) {
    std::visit(Checker{}, action);
}

void check_sample(const brush::PenSample& sample) {
    check_between("time of the pen in s", sample.time_s, 0.0, kLongestSession_s);
    check_between("x of the pen in mm", sample.x_mm, -kMaxPenPosition_mm, kMaxPenPosition_mm);
    check_between("y of the pen in mm", sample.y_mm, -kMaxPenPosition_mm, kMaxPenPosition_mm);
    check_between("pressure of the pen", sample.pressure, 0.0, 1.0);
    check_between("x tilt of the pen", sample.tilt_x_deg, -90.0, 90.0);
    check_between("y tilt of the pen", sample.tilt_y_deg, -90.0, 90.0);
    check_between("rotation of the pen", sample.rotation_deg, -3600.0, 3600.0);
}

void check_time_order(const brush::PenSample& previous, const brush::PenSample& next) {
    if (next.time_s >= previous.time_s) return;
    throw core::InputError("the time " + core::number_text(next.time_s) + " s is earlier than " +
                           core::number_text(previous.time_s) + " s before it.");
}

void check_paint(const PaintRecipe& paint) {
    for (const Ingredient& ingredient : paint.ingredients) {
        pigment::check_paint_name(ingredient.pigment);
        const std::string parts = "number of parts of " + ingredient.pigment;
        check_between(parts.c_str(), ingredient.parts, kLeastParts, kMostParts);
    }
    check_between("strength of the paint", paint.strength, kLeastStrength, 1.0);
}

}  // namespace pastoso::document
