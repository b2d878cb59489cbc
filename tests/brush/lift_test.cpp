// A brush that is lifted while it travels: its tips slide forward until they let go.
#include "brush/studio.hpp"

#include <algorithm>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

/// Cells that hold more than 10 um.
std::vector<char> wet_cells(const film::FilmState& film) {
    std::vector<char> wet;
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x)
            wet.push_back(studio::thickness_mm(film, x, y) > 0.01 ? 1 : 0);
    return wet;
}

/// Takes out the wet cells that hang together with `first`. Returns how many they are.
int take_piece(std::vector<char>& wet, const grid::Shape& canvas, int first) {
    std::vector<int> open{first};
    wet[first] = 0;
    int count = 0;
    while (!open.empty()) {
        const int cell = open.back(), x = cell % canvas.width, y = cell / canvas.width;
        open.pop_back();
        ++count;
        const auto visit = [&](int to_x, int to_y) {
            const bool inside = to_x >= 0 && to_y >= 0 && to_x < canvas.width && to_y < canvas.height;
            if (!inside || wet[to_y * canvas.width + to_x] == 0) return;
            wet[to_y * canvas.width + to_x] = 0;
            open.push_back(to_y * canvas.width + to_x);
        };
        visit(x - 1, y);
        visit(x + 1, y);
        visit(x, y - 1);
        visit(x, y + 1);
    }
    return count;
}

/// Spots apart from the largest piece of paint.
int spots(const film::FilmState& film) {
    std::vector<char> wet = wet_cells(film);
    std::vector<int> pieces;
    for (std::size_t cell = 0; cell < wet.size(); ++cell)
        if (wet[cell] != 0) pieces.push_back(take_piece(wet, film.shape, static_cast<int>(cell)));
    return static_cast<int>(pieces.size()) - 1;
}

/// Lifts the brush over the last `share` of a way of 40 mm.
film::FilmState lifted(const char* preset, double share, double px_per_mm) {
    film::FilmState film = studio::smooth(60.0, 40.0, px_per_mm);
    Brush brush(find_preset(preset), 0.0, 2);
    brush.load(studio::dark_paint(), 0.9);
    studio::paint(
        brush, film,
        [share](double t) {
            PenSample sample = studio::line(8.0, 20.0, 48.0, 20.0, 0.5, 90.0)(t);
            sample.pressure = 0.5 * std::min(1.0, (1.0 - t) / share);
            return sample;
        },
        120.0, 0.6);
    return film;
}

TEST(Lift, LeavesNoSpotsBeyondTheStroke) {
    for (const char* preset :
         {"Large flat 40", "Flat bristle 20", "Filbert 14", "Round bristle 12", "Rigger 2"})
        for (const double share : {0.05, 0.1, 0.3})
            for (const double px_per_mm : {4.0, 8.0})
                EXPECT_LE(spots(lifted(preset, share, px_per_mm)), 2)
                    << preset << ", lifted over " << share << " of the way, " << px_per_mm << " px/mm";
}

// A letter is 3 mm high, as far as a wide brush moves in a dab.
TEST(Lift, WritingEndsWithoutBlobs) {
    film::FilmState film = studio::smooth(12.0, 12.0, 16.0);
    Brush pen(find_preset("Rigger 2"), 0.5, 2);
    pen.load(studio::dark_paint(), 1.0);
    studio::paint(pen, film, studio::line(4.0, 6.0, 7.0, 6.0, 0.3, 0.0), 120.0, 0.1);
    const double middle_mm = studio::highest_mm(film, studio::cells_of(film, 5.0, 4.0, 6.0, 8.0));
    const double end_mm = studio::highest_mm(film, studio::cells_of(film, 6.0, 4.0, 9.0, 8.0));
    EXPECT_GT(middle_mm, 0.01);
    EXPECT_LT(end_mm, 1.6 * middle_mm);
}

}  // namespace
}  // namespace pastoso::brush
