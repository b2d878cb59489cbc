// A painter who never rests: what is done follows from a seed alone.
#pragma once

#include "core/random.hpp"
#include "document/events.hpp"

#include <memory>
#include <vector>

namespace pastoso::document {

inline CanvasSettings hasty_canvas() {
    CanvasSettings canvas;
    canvas.width_mm = 60.0;
    canvas.height_mm = 40.0;
    canvas.px_per_mm = 2.0;
    return canvas;
}

class HastyPainter {
  public:
    explicit HastyPainter(std::uint32_t seed) : seed_(seed) {}

    /// What is done next: a stroke as a rule, now and then Undo, Redo, DryNow, other paint, the well,
    /// layers, selections, masking, fills, textures, tracing pictures, another canvas. Nothing that is
    /// refused: Kill expects all of it in the recording.
    std::vector<Action> next() {
        if (!began_) {
            began_ = true;
            return {UseMedium{"soft-body acrylic"}, TiltCanvas{50, 90}, TakeBrush{"flat", 8, 1}, dip()};
        }
        const int what = choice(31);
        if (what < 3) return std::vector<Action>(static_cast<std::size_t>(1 + choice(4)), Undo{});
        if (what == 3) return {Redo{}};
        if (what == 4) return {DryNow{}};
        if (what == 5) return {SqueezePaint{{{{"PB29", 1.0}}}, 200.0, 20.0 + choice(60), 40.0}};
        if (what == 6) return {CleanWell{}};
        if (what == 7) return {dip()};
        if (what == 9) return {AddLayer{"Above"}};
        if (what == 10) return {SelectLayer{1}};
        if (what == 11) return {SetLayer{1, {.name = "Paint", .opacity = uniform()}}};
        if (what == 13)
            return {SelectArea{{{5, 5}, {50.0 * uniform(), 2}, {55, 40.0 * uniform()}},
                               choice(2) == 0 ? Combination::Replace : Combination::Add}};
        if (what == 14) return {choice(2) == 0 ? Action{SelectAll{}} : Action{InvertSelection{}}};
        if (what == 15)
            return {
                TransformLayer{1, {.centre_x_mm = 30, .centre_y_mm = 20, .turn_deg = 60.0 * uniform()}}};
        if (what == 16) return {ResizeCanvas{10.0 * uniform() - 5.0, 0, 40.0 + choice(30), 40}};
        if (what == 17 && choice(3) == 0) return {LayTracing{}};
        if (what == 17) return {LayTracing{picture(), {5.0 * uniform(), 0, 40, 30}}};
        if (what == 18) return {SetTracing{{0, 0, 30, 20}, uniform()}};
        if (what == 19) return {own_medium(), dip()};
        if (what == 20) return {margin()};
        if (what == 21) return {choice(2) == 0 ? fill() : texture()};
        if (what == 12 && choice(3) == 0) return {FlattenLayers{}};
        if (what == 24 || what == 25) return {masking()};
        if (what == 26) return {distortion()};
        if (what == 27) return {SetLayer{1, {.name = "Paint", .bare_locked = choice(2) == 0}}};
        if (what == 28) return {other_canvas()};
        if (what == 29) return {squeezed(false), squeezed(true), squeezed(true)};
        if (what == 30) return stroke(Surface::Canvas, true);
        return stroke(what == 8 ? Surface::Well : Surface::Canvas);
    }

  private:
    double uniform() { return core::uniform_noise(drawn_++, seed_); }
    int choice(int count) { return static_cast<int>(uniform() * count); }

    std::shared_ptr<const pigment::Picture> picture() {
        return std::make_shared<const pigment::Picture>(
            pigment::Picture{1, 2, {255, 0, 0, 255, 0, 0, static_cast<std::uint8_t>(choice(256)), 128}});
    }

    Action margin() {
        const double width_mm = 0.1 + 4.0 * uniform();
        const int which = choice(5);
        if (which == 0) return GrowSelection{width_mm};
        if (which == 1) return ShrinkSelection{width_mm};
        if (which == 2) return BorderSelection{width_mm};
        if (which == 3) return FeatherSelection{width_mm};
        return SelectSimilarColour{60.0 * uniform(), 40.0 * uniform(), 20.0 * uniform()};
    }

    Action masking() {
        const int which = choice(6);
        if (which == 0) return MaskSelection{};
        if (which == 1) return SelectMasked{};
        if (which == 2) return PeelMasking{};
        MaskStripe stripe{{{40.0 * uniform(), 30.0 * uniform()}, {20.0 + 40.0 * uniform(), 20}}};
        stripe.width_mm = 1.0 + 9.0 * uniform();
        stripe.straight_ends = which == 3;
        stripe.peels = which == 4;
        return stripe;
    }

    Action distortion() {
        return DistortLayer{1,
                            {.corner = {10, 10},
                             .width_mm = 30,
                             .height_mm = 20,
                             .upper_left = {10.0 + 4.0 * uniform(), 10},
                             .upper_right = {40, 10.0 - 4.0 * uniform()},
                             .lower_right = {40.0 + 4.0 * uniform(), 30},
                             .lower_left = {10, 30.0 + 4.0 * uniform()}}};
    }

    /// ResizeCanvas makes it as large as before, now and then.
    Action other_canvas() {
        const int which = choice(4);
        if (which == 0) return RotateCanvas{20.0 * uniform() - 10.0, choice(2) == 0};
        if (which == 1) return ScaleCanvas{0.8, 1.25};
        if (which == 2) return ScaleCanvas{1.25, 0.8};
        return TurnCanvas{{choice(2) == 0, choice(4)}};
    }

    SqueezePaint squeezed(bool joins) {
        return {{{{"PW6", 1.0}}}, 50.0, 20.0 + 60.0 * uniform(), 60.0, joins};
    }

    Action fill() {
        return FillWithPaint{.paint = {{{"PY35", 1.0}}},
                             .thickness_mm = 0.05 + 0.5 * uniform(),
                             .second = {{{"PB29", 1.0}}},
                             .line = {{0, 5}, {20.0 + 40.0 * uniform(), 30}}};
    }

    Action texture() {
        const PaintRecipe white{{{"PW6", 1.0}}};
        const int which = choice(3);
        if (which == 0) return LayTexture{white, layers::SandTexture{0.2 + uniform(), 5}};
        if (which == 1) return LayTexture{white, layers::KnifedTexture{.height_mm = 0.1 + uniform()}};
        return LayTexture{white, layers::PressedTexture{.place = {5, 5, 30.0 * uniform() + 1.0, 20},
                                                        .picture = picture()}};
    }

    Action own_medium() {
        film::Medium medium = film::find_medium("soft-body acrylic");
        medium.yield_stress_Pa = 30.0 * uniform();
        return UseMedium{medium.name, medium};
    }

    Action dip() {
        static constexpr const char* kPaints[] = {"PR108", "PY35", "PB29"};
        LoadPaint load;
        load.paint.ingredients = {{kPaints[choice(3)], 1.0}};
        return load;
    }

    /// One that begins up to 30 mm beside the canvas comes in, or not.
    std::vector<Action> stroke(Surface surface, bool beside = false) {
        std::vector<Action> actions;
        const double x_mm = beside ? -1.0 - 29.0 * uniform() : 50.0 * uniform();
        const double y_mm = 40.0 * uniform();
        const int samples = 5 + choice(60);
        for (int i = 0; i < samples; ++i) {
            brush::PenSample sample;
            sample.time_s = time_s_ += 0.005;
            sample.x_mm = x_mm + 0.4 * i;
            sample.y_mm = y_mm + 3.0 * uniform();
            sample.pressure = 0.3 + 0.5 * uniform();
            if (i == 0)
                actions.emplace_back(PenDown{sample, surface, beside});
            else
                actions.emplace_back(PenMove{sample});
        }
        actions.emplace_back(PenUp{});
        return actions;
    }

    const std::uint32_t seed_;
    std::uint32_t drawn_ = 0;
    bool began_ = false;
    double time_s_ = 0.0;
};

}  // namespace pastoso::document
