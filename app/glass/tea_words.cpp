#include "glass/tea_words.hpp"

#include "core/check.hpp"

#include <algorithm>

#include <QObject>

namespace pastoso::glass {
namespace {

using S = liquid::TeaSettings;

constexpr const char* kSeconds = QT_TR_NOOP(" s");
constexpr const char* kMillimetres = QT_TR_NOOP(" mm");
constexpr const char* kAcceleration = QT_TR_NOOP(" m/s\u00b2");
constexpr const char* kDiffusion = QT_TR_NOOP(" mm\u00b2/s");
constexpr const char* kPercent = QT_TR_NOOP(" %");

constexpr TeaRow kPouring[] = {
    TeaRow{&S::pour_s, QT_TR_NOOP("Pours for"), QT_TR_NOOP("How long the milk of a new glass is poured"),
           kSeconds, 1.0, 1, 0.2, 10.0, true},
    TeaRow{&S::pour_radius_m, QT_TR_NOOP("Stream"), QT_TR_NOOP("Radius of the stream at the jug"),
           kMillimetres, 1e3, 1, 1.0, 15.0},
    TeaRow{&S::pour_speed_m_s, QT_TR_NOOP("Speed"),
           QT_TR_NOOP("Speed of the stream at the jug, downwards"), QT_TR_NOOP(" m/s"), 1.0, 2, 0.0,
           0.6},
    TeaRow{&S::pour_height_m, QT_TR_NOOP("Falls"),
           QT_TR_NOOP("How high above the tea the lip of the jug is"), kMillimetres, 1e3, 1, 0.0,
           100.0}};

constexpr TeaRow kRising[] = {
    TeaRow{&S::fat_m_s2, QT_TR_NOOP("Fat lifts"), QT_TR_NOOP("How fast fat lets milk rise"),
           kAcceleration, 1.0, 2, 0.0, 2.0},
    TeaRow{&S::cold_m_s2, QT_TR_NOOP("Cold sinks"), QT_TR_NOOP("How fast cold lets milk sink"),
           kAcceleration, 1.0, 2, 0.0, 2.0},
    TeaRow{&S::dissolved_m_s2, QT_TR_NOOP("Milky tea sinks"),
           QT_TR_NOOP("How fast tea with milk in it sinks"), kAcceleration, 1.0, 3, 0.0, 0.5},
    TeaRow{&S::slow_warming_s, QT_TR_NOOP("Warms at rest in"),
           QT_TR_NOOP("Time in which milk at rest warms"), kSeconds, 1.0, 0, 1.0, 2000.0, true},
    TeaRow{&S::fast_warming_s, QT_TR_NOOP("A ball warms in"), QT_TR_NOOP("Time in which a ball warms"),
           kSeconds, 1.0, 2, 0.05, 20.0, true},
    TeaRow{&S::chill_share, QT_TR_NOOP("Cold given on"),
           QT_TR_NOOP("Share of the milk's cold that the tea gets"), kPercent, 100.0, 0, 0.0, 100.0}};

constexpr TeaRow kBalls[] = {
    TeaRow{&S::first_ball_s, QT_TR_NOOP("First ball after"), QT_TR_NOOP("When the first ball forms"),
           kSeconds, 1.0, 1, 0.0, 20.0},
    TeaRow{&S::ball_interval_s, QT_TR_NOOP("A ball every"),
           QT_TR_NOOP("Time between two balls, in the mean"), kSeconds, 1.0, 2, 0.05, 5.0, true},
    TeaRow{&S::ball_radius_m, QT_TR_NOOP("Ball's radius"), QT_TR_NOOP("Radius of a ball, in the mean"),
           kMillimetres, 1e3, 1, 2.0, 15.0},
    TeaRow{&S::ball_radius_spread, QT_TR_NOOP("Sizes differ by"),
           QT_TR_NOOP("How much balls differ in size"), kPercent, 100.0, 0, 0.0, 90.0}};

constexpr TeaRow kDissolving[] = {
    TeaRow{&S::dissolving_s, QT_TR_NOOP("A warm ball in"),
           QT_TR_NOOP("Time in which a warm ball dissolves"), kSeconds, 1.0, 1, 1.0, 200.0, true},
    TeaRow{&S::dissolving_on_top_s, QT_TR_NOOP("On top in"),
           QT_TR_NOOP("Time in which milk under the surface dissolves"), kSeconds, 1.0, 1, 0.5, 100.0,
           true},
    TeaRow{&S::top_depth_m, QT_TR_NOOP("On top is"), QT_TR_NOOP("How far down that is"), kMillimetres,
           1e3, 1, 0.0, 40.0},
    TeaRow{&S::dissolving_at_rest_s, QT_TR_NOOP("At rest in"),
           QT_TR_NOOP("Time in which milk at rest dissolves"), kSeconds, 1.0, 0, 5.0, 1000.0, true},
    TeaRow{&S::rest_ends_s, QT_TR_NOOP("All from"), QT_TR_NOOP("When all milk begins to dissolve"),
           kSeconds, 1.0, 0, 0.0, 120.0},
    TeaRow{&S::warm_below, QT_TR_NOOP("Warm below"), QT_TR_NOOP("Coldness below which a ball dissolves"),
           kPercent, 100.0, 0, 0.0, 100.0},
    TeaRow{&S::milk_diffusion_m2_s, QT_TR_NOOP("Milk spreads"), QT_TR_NOOP("How dissolved milk spreads"),
           kDiffusion, 1e6, 1, 0.0, 100.0}};

constexpr TeaRow kFlow[] = {
    TeaRow{&S::viscosity_m2_s, QT_TR_NOOP("Viscosity"),
           QT_TR_NOOP("Kinematic viscosity: water 1, oil 80, honey 5000"), kDiffusion, 1e6, 1, 0.0,
           200.0},
    TeaRow{&S::heat_diffusion_m2_s, QT_TR_NOOP("Heat spreads"), QT_TR_NOOP("How heat spreads"),
           kDiffusion, 1e6, 1, 0.0, 50.0},
    TeaRow{&S::force_reach_m, QT_TR_NOOP("Force reaches"),
           QT_TR_NOOP("How far the force reaches from its axis"), kMillimetres, 1e3, 0, 3.0, 60.0},
    TeaRow{&S::confinement, QT_TR_NOOP("Whirls kept"), QT_TR_NOOP("Force that keeps small whirls alive"),
           "", 1.0, 2, 0.0, 0.3},
    TeaRow{&S::step_s, QT_TR_NOOP("Time step"), QT_TR_NOOP("Length of a time step"), QT_TR_NOOP(" ms"),
           1e3, 1, 5.0, 60.0},
    TeaRow{&S::tolerance, QT_TR_NOOP("Pressure within"), QT_TR_NOOP("How exact the pressure is solved"),
           "", 1.0, 6, 1e-5, 1e-2, true}};

constexpr TeaSection kSections[] = {
    TeaSection{QT_TR_NOOP("Pouring"), kPouring}, TeaSection{QT_TR_NOOP("Sinking and rising"), kRising},
    TeaSection{QT_TR_NOOP("Balls of milk"), kBalls}, TeaSection{QT_TR_NOOP("Dissolving"), kDissolving},
    TeaSection{QT_TR_NOOP("Flow"), kFlow}};

constexpr TeaRow kPouredMilk = {&S::milk_m3,
                                QT_TR_NOOP("Milk"),
                                QT_TR_NOOP("How much milk is poured into a new glass by itself"),
                                QT_TR_NOOP(" ml"),
                                1e6,
                                0,
                                0.0,
                                100.0};

}  // namespace

std::span<const TeaSection> tea_sections() {
    return kSections;
}

const TeaRow& poured_milk() {
    return kPouredMilk;
}

const liquid::TeaNumber& number_of(const TeaRow& row) {
    const auto numbers = liquid::tea_numbers();
    const auto found =
        std::find_if(numbers.begin(), numbers.end(),
                     [&](const liquid::TeaNumber& number) { return number.value == row.value; });
    PASTOSO_CHECK(found != numbers.end());
    return *found;
}

}  // namespace pastoso::glass
