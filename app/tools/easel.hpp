// Turns what the painter does at the easel into the actions of a painting.
#pragma once

#include "brush/pen_sample.hpp"
#include "document/events.hpp"
#include "document/puddles.hpp"
#include "tools/hand.hpp"
#include "tools/heading.hpp"
#include "tools/squeezed_paints.hpp"

#include <cstdint>
#include <functional>
#include <optional>

#include <glm/vec2.hpp>

namespace pastoso::tools {

struct CanvasMove;

/// Where a pen or the mouse is, as the window tells it.
struct Pointer {
    double x_mm = 0.0;
    double y_mm = 0.0;
    document::Surface surface = document::Surface::Canvas;  ///< that x and y lie on
    bool beside = false;  ///< of it, or of what the brush changes there
    double pressure = 0.5;
    double tilt_x_deg = 0.0;
    double tilt_y_deg = 0.0;
    bool tells_tilt = false;             ///< a pen that can; the hand's own otherwise
    std::optional<double> rotation_deg;  ///< of the pen about its axis, where it can tell
    double wheel = 0.0;                  ///< of an airbrush, -1 to 1
    double hand_deg = 0.0;  ///< of a tip's width that neither the pen nor its way turns: the hand's own
    std::uint64_t time_ms = 0;  ///< of the event, on the windowing system's clock
};

/// The pressure of a mouse, which has none.
inline constexpr double kMousePressure = 0.5;

/// Keeps the painter's Hand and posts what follows from every change of it. A change of tool during a
/// stroke ends the stroke first.
class Easel {
  public:
    using Post = std::function<void(document::Action)>;

    /// Posts nothing yet: set_up() does, on a new canvas. `note_hand` is called whenever the brush
    /// moves.
    Easel(Hand hand, Post post, std::function<void()> note_hand = {});

    /// Pours the medium, tilts the canvas, lets the air move, takes the brush and dips it: for a canvas
    /// that knows nothing yet.
    void set_up();

    /// Takes over what somebody else (a replay) does to brush, paint, medium and tilt; posts nothing.
    void adopt(const Hand& hand) { hand_ = hand; }

    const Hand& hand() const { return hand_; }
    bool painting() const { return painting_; }

    void take_brush(const std::string& preset, double width_mm);
    void set_brush_width(double width_mm);
    void take_brush(const brush::Preset& preset, double width_mm);

    /// Takes that tool, clean, or dipped where it is; the one in hand lies aside with what it holds.
    void take_for_now(const brush::Preset& preset, double width_mm);

    /// The tool in hand and the one that lies aside change places.
    void swap_brushes();

    /// Changes what the brush in hand is like, from the next stroke on, which starts with it freshly
    /// dipped; as wide as it is held, or as that width.
    void change_brush(const brush::Preset& preset);
    void change_brush(const brush::Preset& preset, double width_mm);

    void choose_paint(const document::PaintRecipe& paint);  ///< cleans the brush and dips it
    void swap_paints();                                     ///< the second becomes the first
    void set_dip(const Dip& dip);                           ///< holds from the next dip on
    void reload();  ///< cleans the brush and dips it again; it only cleans a tool that is not dipped
    void dip();     ///< tops it up with what it is dipped in, over what it holds
    void blot();    ///< leaves a quarter of what it holds
    void clean();
    void use_medium(const std::string& name);  ///< cleans the brush and dips it in paint of that kind
    void change_medium(const film::Medium& medium);  ///< other numbers under its name; the same

    /// Thins the medium in hand, which keeps its numbers, to that share of paint, within the limits of
    /// film::thinned(), and dips as for another medium. Nothing where it is that thin, or nothing thins
    /// it.
    void set_paint_share(double share);
    void thin_to_wash(bool wash);  ///< to kWashShare, and back to what was thicker than that before
    void tilt(double tilt_deg, double direction_deg);
    void set_drying_speed(double speed);
    void dry_now();
    void set_reload_each_stroke(bool reload);
    void set_turn_with_stroke(bool turn);
    void set_tilted(bool tilted);
    void set_stabiliser(const brush::Stabiliser& stabiliser);
    void set_symmetry(const brush::Symmetry& symmetry);

    /// Lays a guide in place of the one that lies there; every stroke follows it until it is taken away.
    void lay_guide(const brush::PenGuide& guide);
    void take_guide_away();  ///< its strength stays for the next one

    /// A ruler along the latest stroke, or `otherwise` where there is none worth it.
    brush::Ruler ruler_along_stroke(const brush::Ruler& otherwise) const;

    /// One of document::SelectionActions, document::MarginActions or document::MaskingActions.
    void select(const document::Action& selection);

    /// What lay on the canvas came to lie elsewhere on it: guides, symmetry and fan follow.
    void move_along(const CanvasMove& move);

    void resize(const document::ResizeCanvas& resize);
    void turn_canvas(const document::TurnCanvas& turn);
    void scale_canvas(const document::ScaleCanvas& scale);
    void rotate_canvas(const document::RotateCanvas& rotate);
    void transform(const document::TransformLayer& transform);
    void distort(const document::DistortLayer& distort);
    void fill(const document::FillWithPaint& fill);
    void tone_ground(const document::ToneGround& tone);
    void lay_texture(const document::LayTexture& lay);
    void adjust_dry_paint(const document::AdjustDryPaint& adjust);
    void undo();
    void redo();

    /// Squeezes a dollop of the present paint onto the mixing well: at a place, or at the next one of a
    /// row along its edges. Keeps within the well.
    void squeeze(double x_mm, double y_mm);
    void squeeze_next() { squeeze_next(hand_.paint); }

    /// The same with another paint; one undo step with the last one where it joins that.
    void squeeze_next(const document::PaintRecipe& paint, bool joins = false);
    /// As much of a mixture as there was, where it lay.
    void squeeze_puddle(const document::Puddle& puddle, bool joins);
    void clean_well();

    /// What was squeezed out here.
    SqueezedPaints& squeezed_paints() { return squeezed_paints_; }

    /// While a recording is played the brush is in another hand: presses paint nothing.
    void lend_brush(bool lent) { lent_ = lent; }
    bool brush_is_lent() const { return lent_; }

    /// `straight`: paints a straight line to where the brush is lifted, on the canvas. A brush that was
    /// in the well keeps what it took up there, until it is cleaned or loaded.
    void press(const Pointer& pointer, bool straight = false);
    void move(const Pointer& pointer);  ///< also of a pointer in the air, which paints nothing
    void release();

    /// The brush has not moved for this long since the last call here: one that lags behind to steady
    /// the hand catches up. Only over the surface that it paints on.
    void wait(double seconds, document::Surface surface = document::Surface::Canvas);

    /// Where the straight line that is being drawn starts.
    std::optional<Pointer> line_start() const;

    /// How the brush is held over the canvas now, in the air too; where and when do not count.
    brush::PenSample held() const;

  private:
    void squeeze(const document::PaintRecipe& paint, double x_mm, double y_mm, bool joins);
    void end_stroke();
    void pour(const document::UseMedium& medium);
    void post_brush();
    void do_with_brushes(const document::Action& action);
    void follow(const Pointer& pointer);
    void forget_guide();
    void choose_guide(const Pointer& pointer, bool straight);
    bool turns_with_path(const Pointer& pointer) const;
    void decide_start(const Pointer& pointer);
    brush::PenSample sample(const Pointer& pointer);

    Hand hand_;
    Post post_;
    std::function<void()> note_hand_;
    Heading heading_;
    double rotation_deg_ = 0.0;
    Pointer followed_;  ///< where it was last
    bool lent_ = false;
    bool painting_ = false;
    document::Surface painting_on_ = document::Surface::Canvas;  ///< in the latest stroke
    double share_before_wash_ = 1.0;                             ///< of paint in the medium in hand
    bool mixed_ = false;               ///< the brush was in the well since it was loaded
    int squeezed_ = 0;                 ///< places of the row that are taken
    SqueezedPaints squeezed_paints_;
    Pointer pressed_, latest_;         ///< of the latest stroke on the canvas
    std::optional<Pointer> start_;     ///< of a stroke whose direction is not known yet
    double start_rotation_deg_ = 0.0;  ///< that it began with
    brush::PenSample previous_;        ///< that was posted
    double waited_s_ = 0.0;            ///< since the brush moved
    bool has_clock_zero_ = false;
    std::uint64_t clock_zero_ms_ = 0;
    double previous_time_s_ = 0.0;
    std::uint32_t brushes_taken_ = 0;
    bool brush_changed_ = false;  ///< since it was posted
    struct Aside {
        bool mixed = false, changed = false;
    };
    Aside aside_;  ///< the same of the brush that lies there
};

}  // namespace pastoso::tools
