// The mark that makes each tool besides brushes and knives what it is: pens, dry sticks, sponge, roller,
// marbling comb and squeegee.

#include "brush/brush.hpp"
#include "brush/studio.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

/// What counts as painted, mm.
constexpr double kSeen_mm = 0.002;

/// A full tool along a straight way.
film::FilmState drawn(const char* tool, film::FilmState film, const studio::Movement& movement,
                      double seconds = 0.5) {
    Brush brush(find_preset(tool));
    brush.load(studio::dark_paint(), 1.0);
    studio::paint(brush, film, movement, 250.0, seconds);
    return film;
}

/// Width, mm, of a straight line of `length_mm`: what it covers over how long it is.
double width_of_line(const char* tool, double angle_deg, double pressure) {
    constexpr double kLength_mm = 20.0, kMiddle_mm = 20.0;
    const double c = 0.5 * kLength_mm * std::cos(core::radians(angle_deg));
    const double s = 0.5 * kLength_mm * std::sin(core::radians(angle_deg));
    const film::FilmState film = drawn(
        tool, studio::smooth(40.0, 40.0, 16.0),
        studio::line(kMiddle_mm - c, kMiddle_mm - s, kMiddle_mm + c, kMiddle_mm + s, pressure, 0.0));
    return studio::coverage(film, film.shape.cells()) * 40.0 * 40.0 / kLength_mm;
}

/// The edge stands at 40 degrees; its ends add a tenth to what a short line covers.
TEST(Nib, IsAsWideAsItsEdgeStandsAcrossTheWay) {
    EXPECT_NEAR(width_of_line("nib", 130.0, 0.5), 3.0, 0.4);
    EXPECT_NEAR(width_of_line("nib", 85.0, 0.5), 3.0 * std::sin(core::radians(45.0)), 0.6);
    EXPECT_LT(width_of_line("nib", 40.0, 0.5), 0.9);
}

TEST(RulingPen, DrawsOneWidthHoweverItIsPressedAndTurned) {
    const double width_mm = width_of_line("Ruling pen 1", 0.0, 0.5);
    EXPECT_NEAR(width_mm, 1.0, 0.25);
    EXPECT_NEAR(width_of_line("Ruling pen 1", 0.0, 0.1), width_mm, 0.03);
    EXPECT_NEAR(width_of_line("Ruling pen 1", 90.0, 1.0), width_mm, 0.15);
}

/// Shares of the cells of a rectangle that are painted: of those in the upper third of the support, and
/// of those in the lower.
struct Cover {
    double crowns, hollows;
};
Cover cover_of(const film::FilmState& film, const grid::Rect& cells) {
    std::vector<std::pair<float, bool>> heights;
    for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x)
            heights.emplace_back(film.support_mm.at(x, y), studio::thickness_mm(film, x, y) > kSeen_mm);
    std::sort(heights.begin(), heights.end());
    const auto third = static_cast<std::ptrdiff_t>(heights.size() / 3);
    const auto painted = [](const auto& cell) { return cell.second; };
    const auto share = [&](auto first) {
        return static_cast<double>(std::count_if(first, first + third, painted)) /
               static_cast<double>(third);
    };
    return {share(heights.end() - third), share(heights.begin())};
}

Cover cover_by(const char* stick, double pressure) {
    const film::FilmState film = drawn(stick, studio::linen(60.0, 20.0, 8.0),
                                       studio::line(8.0, 10.0, 52.0, 10.0, pressure, 90.0));
    return cover_of(film, studio::cells_of(film, 20.0, 8.5, 45.0, 11.5));
}

TEST(DrySticks, TouchTheGrainAlone) {
    for (const char* stick : {"charcoal", "pastel"}) {
        const Cover light = cover_by(stick, 0.2), firm = cover_by(stick, 1.0);
        EXPECT_GT(light.crowns, 0.3) << stick;
        EXPECT_LT(light.hollows, 0.1 * light.crowns) << stick;
        EXPECT_GE(firm.crowns, light.crowns) << stick;
        EXPECT_GT(firm.hollows, 0.5) << stick << " fills the weave when it is pressed";
    }
}

TEST(DrySticks, LeaveACoatThatIsNoThickerInTheHollows) {
    const film::FilmState film = drawn("charcoal", studio::linen(60.0, 20.0, 8.0),
                                       studio::line(8.0, 10.0, 52.0, 10.0, 1.0, 90.0));
    // A film as levels the hollows is as thick as they are deep, a tenth of a millimetre and more.
    EXPECT_LT(studio::highest_mm(film, film.shape.cells()), 0.05);
}

/// Correlation of the thickness of two rectangles of one size.
double correlation(const film::FilmState& a, const grid::Rect& of_a, const film::FilmState& b,
                   const grid::Rect& of_b) {
    double sa = 0.0, sb = 0.0, saa = 0.0, sbb = 0.0, sab = 0.0, n = 0.0;
    for (int y = 0; y < of_a.height(); ++y)
        for (int x = 0; x < of_a.width(); ++x, ++n) {
            const double ha = studio::thickness_mm(a, of_a.x0 + x, of_a.y0 + y);
            const double hb = studio::thickness_mm(b, of_b.x0 + x, of_b.y0 + y);
            sa += ha, sb += hb, saa += ha * ha, sbb += hb * hb, sab += ha * hb;
        }
    return (sab - sa * sb / n) / std::sqrt((saa - sa * sa / n) * (sbb - sb * sb / n));
}

/// A roller that rolls to the right over 250 mm.
film::FilmState rolled() {
    return drawn("roller", studio::smooth(260.0, 60.0, 4.0),
                 studio::line(5.0, 30.0, 255.0, 30.0, 0.5, 90.0), 1.5);
}

TEST(Roller, LaysAnEvenFilmAllOverItsWidth) {
    const film::FilmState film = rolled();
    const grid::Rect inside = studio::cells_of(film, 60.0, 10.0, 200.0, 50.0);
    EXPECT_GT(studio::coverage(film, inside), 0.98);
    const double mean_mm = studio::mean_thickness_mm(film, inside);
    for (double x_mm = 60.0; x_mm < 200.0; x_mm += 20.0)
        for (double y_mm = 10.0; y_mm < 50.0; y_mm += 20.0)
            EXPECT_NEAR(studio::mean_thickness_mm(
                            film, studio::cells_of(film, x_mm, y_mm, x_mm + 20.0, y_mm + 20.0)),
                        mean_mm, 0.2 * mean_mm);
}

TEST(Roller, MarksTheSameAgainAfterEachTurn) {
    const film::FilmState film = rolled();
    const double girth_mm = find_preset("roller").tip.girth_mm;
    const auto piece = [&](double x_mm) {
        return studio::cells_of(film, x_mm, 10.0, x_mm + 40.0, 50.0);
    };
    const auto alike = [&](double further_mm) {
        return correlation(film, piece(70.0), film, piece(70.0 + further_mm));
    };
    // What differs from side to side stays: it is told apart by how much more alike a whole turn is.
    EXPECT_GT(alike(girth_mm), 0.8);
    EXPECT_LT(alike(0.5 * girth_mm), alike(girth_mm) - 0.3);
}

TEST(Roller, PrintsWhatItTookUpATurnLater) {
    const double girth_mm = find_preset("roller").tip.girth_mm;
    film::FilmState film = studio::smooth(200.0, 60.0, 4.0);
    studio::cover(film, studio::cells_of(film, 60.0, 5.0, 70.0, 55.0), 0.5, studio::dark_paint());
    Brush roller(find_preset("roller"));
    studio::paint(roller, film, studio::line(20.0, 30.0, 190.0, 30.0, 0.5, 90.0), 250.0, 1.5);
    const auto left_mm = [&](double x_mm) {
        return studio::mean_thickness_mm(film, studio::cells_of(film, x_mm, 10.0, x_mm + 6.0, 50.0));
    };
    EXPECT_GT(left_mm(62.0 + girth_mm), 0.005);
    EXPECT_LT(left_mm(62.0 + 0.5 * girth_mm), 0.1 * left_mm(62.0 + girth_mm));
}

studio::Movement press_down(double x_mm, double y_mm, double pressure) {
    return [=](double t) {
        return PenSample{.x_mm = x_mm, .y_mm = y_mm, .pressure = pressure * std::sin(core::kPi * t)};
    };
}

/// Prints of a sponge that always stands the same way.
Preset still_sponge() {
    Preset sponge = find_preset("sponge");
    std::erase_if(sponge.dynamics,
                  [](const auto& curve) { return curve.target == DynamicsTarget::Rotation; });
    return sponge;
}

film::FilmState print_of(Brush& sponge, double pressure) {
    film::FilmState film = studio::smooth(60.0, 60.0, 6.0);
    studio::paint(sponge, film, press_down(30.0, 30.0, pressure), 250.0, 0.3);
    return film;
}

TEST(Sponge, IsFullOfHolesThatCloseUnderPressure) {
    const auto covered = [](double pressure) {
        Brush sponge(still_sponge());
        sponge.load(studio::dark_paint(), 1.0);
        const film::FilmState film = print_of(sponge, pressure);
        return studio::coverage(film, studio::cells_of(film, 20.0, 22.0, 40.0, 38.0));
    };
    EXPECT_GT(covered(0.35), 0.15);
    EXPECT_LT(covered(0.35), 0.85);
    EXPECT_GT(covered(1.0), covered(0.35) + 0.1);
}

TEST(Sponge, PrintsAnotherPatternAfterEachLoad) {
    Brush sponge(still_sponge());
    sponge.load(studio::dark_paint(), 1.0);
    Brush same = sponge;
    const film::FilmState first = print_of(sponge, 0.4), again = print_of(same, 0.4);
    sponge.load(studio::dark_paint(), 1.0);
    const film::FilmState second = print_of(sponge, 0.4);
    const grid::Rect cells = studio::cells_of(first, 15.0, 18.0, 45.0, 42.0);
    EXPECT_DOUBLE_EQ(correlation(first, cells, again, cells), 1.0);
    EXPECT_LT(correlation(first, cells, second, cells), 0.6);
}

/// Furrows that a column of cells crosses, at least 15 um deep in a film of that thickness.
int furrows_at(const film::FilmState& film, int x, double film_mm) {
    constexpr double kSeenFurrow_mm = 0.015;
    int furrows = 0;
    bool within = false;
    for (int y = 0; y < film.shape.height; ++y) {
        const bool low = studio::thickness_mm(film, x, y) < film_mm - kSeenFurrow_mm;
        furrows += low && !within ? 1 : 0;
        within = low;
    }
    return furrows;
}

TEST(MarblingComb, LaysNothingAndTakesNothingAway) {
    const auto combed = [](film::FilmState film, Brush& comb) {
        studio::paint(comb, film, studio::line(20.0, 50.0, 80.0, 50.0, 0.7, 90.0), 250.0, 1.0);
        return film;
    };
    Brush comb(find_preset("Marbling comb 80"));
    EXPECT_EQ(studio::volume_mm3(combed(studio::smooth(100.0, 100.0, 4.0), comb)), 0.0);
    film::FilmState wet = studio::smooth(100.0, 100.0, 4.0);
    studio::cover(wet, 0.6, studio::dark_paint());
    const double before_mm3 = studio::volume_mm3(wet);
    const film::FilmState after = combed(wet, comb);
    // What the teeth push ahead of them when they are lifted stays on them.
    EXPECT_NEAR(studio::volume_mm3(after), before_mm3, 0.005 * before_mm3);
    EXPECT_EQ(furrows_at(after, 200, 0.6), 10);
}

TEST(Squeegee, DrawsAnEvenFilmAsWideAsItIs) {
    const film::FilmState film = drawn("squeegee", studio::smooth(120.0, 140.0, 2.0),
                                       studio::line(10.0, 70.0, 110.0, 70.0, 0.3, 90.0), 1.0);
    EXPECT_GT(studio::coverage(film, studio::cells_of(film, 30.0, 14.0, 90.0, 126.0)), 0.97);
    EXPECT_LT(studio::coverage(film, studio::cells_of(film, 30.0, 0.0, 90.0, 8.0)), 0.02);
}

TEST(Squeegee, ScrapesOffWhatLiesWetWhenItIsPressed) {
    film::FilmState film = studio::smooth(120.0, 140.0, 2.0);
    studio::cover(film, 0.6, studio::light_paint());
    Brush squeegee(find_preset("squeegee"));
    studio::paint(squeegee, film, studio::line(10.0, 70.0, 110.0, 70.0, 1.0, 90.0), 250.0, 1.0);
    EXPECT_LT(studio::mean_thickness_mm(film, studio::cells_of(film, 40.0, 30.0, 70.0, 110.0)), 0.15);
}

}  // namespace
}  // namespace pastoso::brush
