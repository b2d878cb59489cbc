// Everything that can happen to a painting, as plain data: the window makes these, the stroke log keeps
// them, a replay applies them again.
#pragma once

#include "brush/pen_filter.hpp"
#include "brush/pen_guide.hpp"
#include "brush/pen_sample.hpp"
#include "brush/symmetry.hpp"
#include "document/extent_events.hpp"
#include "document/layer_events.hpp"
#include "document/picture_events.hpp"
#include "document/selection_events.hpp"
#include "film/cell/drying_air.hpp"
#include "film/medium.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pastoso::document {

/// Paint time passes in ticks of this length; every event is applied between two ticks, so that a replay
/// gives the same bits as the session it was logged in.
inline constexpr double kTick_s = 1.0 / 60.0;

/// One paint of a mixture: parts by volume at full strength.
struct Ingredient {
    std::string pigment;  ///< Colour Index name, for example "PB29", or a colour of sRGB, "#c03020"
    double parts = 1.0;   ///< > 0
    friend bool operator==(const Ingredient&, const Ingredient&) = default;
};

/// A mixture of paints thinned with clear medium.
struct PaintRecipe {
    std::vector<Ingredient> ingredients{};  ///< none: the medium alone
    double strength =
        1.0;  ///< share of pigmented paint in the volume, the rest is clear medium; 0 < s <= 1
    friend bool operator==(const PaintRecipe&, const PaintRecipe&) = default;
};

struct TakeBrush {  ///< takes a clean brush in hand; what the old one held goes to the waste account
    std::string preset;
    double size_mm = 0.0;  ///< width of the tip; 0: the preset's own
    std::uint32_t seed = 1;
    /// A preset that does not come with the program: all of it, as brush::preset_to_json() writes it.
    std::string definition{};
    friend bool operator==(const TakeBrush&, const TakeBrush&) = default;
};
struct LoadPaint {  ///< dips the brush
    PaintRecipe paint{};
    PaintRecipe second{};          ///< no ingredients: the brush holds `paint` alone
    double second_share = 0.0;     ///< mean share of the second paint, 0 to 1
    double share_variation = 0.0;  ///< how much the share differs from bristle to bristle, 0 to 1
    bool side_by_side = false;     ///< double load: one half of the tip each, instead of half-mixed
    bool tip_only = false;  ///< dips only the hairs that reach deepest; the others stay as they are
    double fill = 1.0;      ///< of the brush's capacity, 0 to 1.2
    friend bool operator==(const LoadPaint&, const LoadPaint&) = default;
};
/// What the pen is on: the canvas, or the mixing well beside it. Both have their millimetres counted
/// from their own upper left corner.
enum class Surface { Canvas, Well };

/// Squeezes paint out of a tube onto the mixing well, in the medium in hand. What a place has no room
/// for stays in the tube.
struct SqueezePaint {
    PaintRecipe paint{};
    double volume_mm3 = 250.0;  ///< 1 to 5000
    double x_mm = 0.0;          ///< on the well
    double y_mm = 0.0;
    friend bool operator==(const SqueezePaint&, const SqueezePaint&) = default;
};
struct CleanWell {  ///< wipes the mixing well bare, into the waste account
    friend bool operator==(const CleanWell&, const CleanWell&) = default;
};
struct CleanBrush {      ///< wipes paint off the brush, into the waste account
    double share = 1.0;  ///< of what every bristle holds, 0 to 1; less than all blots it
    friend bool operator==(const CleanBrush&, const CleanBrush&) = default;
};
/// Takes another medium in hand. Paint loaded from now on brings its viscosity, yield stress, solids and
/// drying time along; the other properties of the medium become those of all wet paint.
struct UseMedium {
    std::string name;                   ///< of one that comes with the program
    std::optional<film::Medium> own{};  ///< its numbers as the painter changed them, under its name
    friend bool operator==(const UseMedium&, const UseMedium&) = default;
};
struct TiltCanvas {
    double tilt_deg = 0.0;        ///< 0 flat, 90 upright
    double direction_deg = 90.0;  ///< where down points on the canvas: 0 right, 90 to the lower edge
    friend bool operator==(const TiltCanvas&, const TiltCanvas&) = default;
};
struct SetDrying {  ///< how fast paint on the canvas dries from now on; in the well it stays open
    film::DryingAir air;
    friend bool operator==(const SetDrying&, const SetDrying&) = default;
};
struct DryNow {  ///< all wet paint on the canvas becomes dry at once, or what is selected of it
    friend bool operator==(const DryNow&, const DryNow&) = default;
};
struct PenDown {
    brush::PenSample sample;
    Surface surface = Surface::Canvas;  ///< until the pen lifts
    friend bool operator==(const PenDown&, const PenDown&) = default;
};
struct PenMove {
    brush::PenSample sample;
    friend bool operator==(const PenMove&, const PenMove&) = default;
};
struct PenUp {
    friend bool operator==(const PenUp&, const PenUp&) = default;
};
struct Undo {
    friend bool operator==(const Undo&, const Undo&) = default;
};
struct Redo {
    friend bool operator==(const Redo&, const Redo&) = default;
};
struct SetStabiliser {  ///< steadies the hand, from the next stroke on
    brush::Stabiliser stabiliser;
    friend bool operator==(const SetStabiliser&, const SetStabiliser&) = default;
};
struct SetGuide {  ///< leads the pen on the canvas, from the next stroke on
    brush::PenGuide guide;
    friend bool operator==(const SetGuide&, const SetGuide&) = default;
};
/// Paints every stroke on the canvas from the next one on with several brushes at once. Each starts with
/// what the brush in hand holds, taken from the tubes, and is wiped when the stroke ends.
struct SetSymmetry {
    brush::Symmetry symmetry;
    friend bool operator==(const SetSymmetry&, const SetSymmetry&) = default;
};

using Action =
    std::variant<TakeBrush, LoadPaint, CleanBrush, UseMedium, TiltCanvas, SetDrying, DryNow, PenDown,
                 PenMove, PenUp, Undo, Redo, SetStabiliser, SetGuide, SetSymmetry, SqueezePaint,
                 CleanWell, AddLayer, SelectLayer, SetLayer, DuplicateLayer, RemoveLayer, ClearLayer,
                 TransformLayer, MoveLayer, MergeDown, FlattenLayers, GroupLayers, SetGroup, MoveGroup,
                 UngroupLayers, SelectArea, SelectByHeight, SelectByWetness, InvertSelection, SelectAll,
                 ResizeCanvas, PaintPicture, LayTracing, SetTracing>;

struct Event {
    std::int64_t tick = 0;  ///< the number of ticks that had passed when it happened
    Action action;
    friend bool operator==(const Event&, const Event&) = default;
};

/// What a canvas is made of; the same settings at another resolution give the same canvas, finer or
/// coarser.
struct CanvasSettings {
    double width_mm = 300.0;
    double height_mm = 200.0;
    double px_per_mm = 4.0;         ///< cells per millimetre
    std::string support = "linen";  ///< "linen", "cotton duck", "panel", or "image" with support_image
    std::string support_image{};    ///< path of a height image of the user's own
    double support_relief_mm =
        0.0;  ///< height of its white above its black; 0: the support's own relief
    /// Where on its cloth the canvas begins, in whole cells; of an image, from where it was stretched.
    double support_x_mm = 0.0, support_y_mm = 0.0;
    friend bool operator==(const CanvasSettings&, const CanvasSettings&) = default;
};

/// A painting as a list of what the painter did.
struct Recording {
    CanvasSettings canvas;
    std::vector<Event> events;  ///< ticks do not decrease
    std::int64_t end_tick = 0;  ///< how long the paint is let run in all, >= the last event's tick
    friend bool operator==(const Recording&, const Recording&) = default;
};

}  // namespace pastoso::document
