// Where paint may lie when another medium is taken in hand, as tables that several tests cross.
#pragma once

#include "document/layered_canvas.hpp"
#include "document/painting_state.hpp"
#include "document/scenes.hpp"
#include "film/medium.hpp"

#include <cstdlib>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::document {

struct NamedActions {
    std::string name;
    std::vector<Action> actions;
    friend std::ostream& operator<<(std::ostream& out, const NamedActions& named) {
        return out << named.name;
    }
};

/// Each of them would run off an upright canvas at once, if it lay there.
inline std::vector<NamedActions> other_media() {
    film::Medium runny = film::find_medium("heavy-body oil");
    runny.viscosity_m2_s = 1e-5;
    runny.yield_stress_Pa = 0.0;
    return {{"thinner", {CleanBrush{}, UseMedium{"thinner"}}},
            {"ink glaze", {CleanBrush{}, UseMedium{"ink glaze"}}},
            {"own numbers", {CleanBrush{}, UseMedium{runny.name, runny}}}};
}

/// What makes of layer 1, which is active and alone, a layer in which paint lies otherwise.
inline std::vector<NamedActions> places_of_paint() {
    const std::vector<Action> dried_in_part = {SelectArea{{{0, 0}, {18, 0}, {18, 30}, {0, 30}}},
                                               DryNow{}, SelectAll{}};
    std::vector<Action> dried_and_inactive = dried_in_part;
    dried_and_inactive.emplace_back(AddLayer{"Above"});
    return {{"Active", {}},
            {"Inactive", {AddLayer{"Above"}}},
            {"Hidden", {AddLayer{"Above"}, SetLayer{1, {.name = "Paint", .visible = false}}}},
            {"InAGroup", {AddLayer{"Above"}, GroupLayers{"Group", {1}}}},
            {"DriedInPart", dried_in_part},
            {"DriedInPartAndInactive", dried_and_inactive}};
}

/// Makes layer 1 visible and active again, whatever was made of it.
inline std::vector<Action> back_to_paint() {
    return {SelectLayer{1}, SetLayer{1, {.name = "Paint"}}};
}

/// Oil on an upright canvas, at rest.
inline Recording standing_oil() {
    Recording recording{small_canvas(), {}, 30};
    auto& events = recording.events;
    events = {{0, TiltCanvas{90, 90}},
              {0, TakeBrush{"flat", 8, 1}},
              {0, UseMedium{"heavy-body oil"}},
              {0, load_of("PB29")},
              {0, PenDown{wave_sample(0.0, 10.0, 0)}}};
    for (int i = 1; i <= 30; ++i)
        events.push_back({0, PenMove{wave_sample(0.0, 10.0, i)}});
    events.push_back({0, PenUp{}});
    return recording;
}

/// Goes on at the recording's end.
inline void go_on(Recording& recording, const std::vector<Action>& actions, std::int64_t ticks = 0) {
    for (const Action& action : actions)
        recording.events.push_back({recording.end_tick, action});
    recording.end_tick += ticks;
}

inline void go_on(Painting& painting, const std::vector<Action>& actions, int ticks = 0) {
    for (const Action& action : actions)
        painting.apply(action);
    for (int i = 0; i < ticks; ++i)
        painting.advance_tick();
}

inline film::FilmState paint_of(const Painting& painting, LayerId layer) {
    const PaintingState state = painting.state();
    return *layers_apart(state.value.film, state.value.bare->support_mm,
                         state.value.layers)[place_of(state.value.layers, layer)];
}

/// The share of the paint that lies elsewhere now.
inline double moved_share(const film::FilmState& before, const film::FilmState& after) {
    std::int64_t moved = 0;
    for (int y = 0; y < before.shape.height; ++y)
        for (int x = 0; x < before.shape.width; ++x)
            moved += std::abs(after.thickness.at(x, y) - before.thickness.at(x, y));
    return static_cast<double>(moved) / static_cast<double>(film::totals(before).thickness);
}

/// The same volume, viscosity and yield stress to the bit, at the same place.
inline void expect_untouched(const film::FilmState& before, const film::FilmState& after) {
    const film::Totals then = film::totals(before), now = film::totals(after);
    ASSERT_GT(then.thickness, 0);
    EXPECT_EQ(now.thickness, then.thickness);
    EXPECT_EQ(now.paint[film::kViscosityChannel], then.paint[film::kViscosityChannel]);
    EXPECT_EQ(now.paint[film::kYieldChannel], then.paint[film::kYieldChannel]);
    // The edges draw in a little, where the contact angle is another one.
    EXPECT_LT(moved_share(before, after), 0.02);
}

}  // namespace pastoso::document
