#include "view/selection_outline.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::view {
namespace {

using testing::IsEmpty;
using testing::UnorderedElementsAre;
using Line = std::array<float, 4>;

/// '#' is chosen.
grid::Mask mask_of(const std::vector<const char*>& rows) {
    const grid::Shape shape{static_cast<int>(std::string(rows.front()).size()),
                            static_cast<int>(rows.size())};
    grid::Mask mask(shape);
    for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x)
            if (rows[y][x] == '#') mask.set(x, y, grid::kWhole);
    return mask;
}

std::vector<Line> lines_of(const std::vector<glm::vec2>& corners) {
    std::vector<Line> lines;
    for (std::size_t i = 0; i < corners.size(); i += 2)
        lines.push_back({corners[i].x, corners[i].y, corners[i + 1].x, corners[i + 1].y});
    return lines;
}

std::vector<Line> borders(const grid::Mask& mask, const MaskWindow& window, double cell_mm = 1.0) {
    return lines_of(*mask_borders_mm(mask, cell_mm, window, 1000000));
}
std::vector<Line> borders(const grid::Mask& mask, double cell_mm = 1.0) {
    return borders(mask, {mask.shape().cells()}, cell_mm);
}

TEST(SelectionOutline, OfOneCellIsASquare) {
    const grid::Mask mask = mask_of({"...", ".#.", "..."});
    EXPECT_THAT(borders(mask, 0.5), UnorderedElementsAre(Line{0.5, 0.5, 1, 0.5}, Line{0.5, 1, 1, 1},
                                                         Line{0.5, 0.5, 0.5, 1}, Line{1, 0.5, 1, 1}));
}

TEST(SelectionOutline, JoinsTheBordersOfCellsToLongLines) {
    const grid::Mask mask = mask_of({"##..", "####", "...."});
    EXPECT_THAT(borders(mask),
                UnorderedElementsAre(Line{0, 0, 2, 0}, Line{2, 1, 4, 1}, Line{0, 2, 4, 2},
                                     Line{0, 0, 0, 2}, Line{2, 0, 2, 1}, Line{4, 1, 4, 2}));
}

TEST(SelectionOutline, RunsAroundHoles) {
    const grid::Mask mask = mask_of({"###", "#.#", "###"});
    EXPECT_THAT(borders(mask), UnorderedElementsAre(Line{0, 0, 3, 0}, Line{0, 3, 3, 3}, Line{0, 0, 0, 3},
                                                    Line{3, 0, 3, 3}, Line{1, 1, 2, 1}, Line{1, 2, 2, 2},
                                                    Line{1, 1, 1, 2}, Line{2, 1, 2, 2}));
}

TEST(SelectionOutline, OfAllCellsIsTheCanvasEdge) {
    const grid::Mask mask = grid::inverted(grid::Mask(grid::Shape{130, 70}));
    EXPECT_THAT(borders(mask), UnorderedElementsAre(Line{0, 0, 130, 0}, Line{0, 70, 130, 70},
                                                    Line{0, 0, 0, 70}, Line{130, 0, 130, 70}));
    EXPECT_THAT(borders(grid::Mask(grid::Shape{130, 70})), IsEmpty());
}

TEST(SelectionOutline, InAWindowHasNoBorderWhereTheWindowEnds) {
    const grid::Mask mask = mask_of({"####", "####", "####", "...."});
    EXPECT_THAT(borders(mask, {{1, 1, 3, 4}}), UnorderedElementsAre(Line{1, 3, 3, 3}));
    EXPECT_THAT(borders(mask, {{-5, -5, 2, 2}}),
                UnorderedElementsAre(Line{0, 0, 2, 0}, Line{0, 0, 0, 2}));
    EXPECT_THAT(borders(mask, {{20, 20, 30, 30}}), IsEmpty());
}

TEST(SelectionOutline, InBlocksGoesAroundEveryBlockWithAChosenCell) {
    const grid::Mask mask = mask_of({".#...", ".....", ".....", "....#", "....."});
    EXPECT_THAT(
        borders(mask, {mask.shape().cells(), 2}),
        UnorderedElementsAre(Line{0, 0, 2, 0}, Line{0, 2, 2, 2}, Line{0, 0, 0, 2}, Line{2, 0, 2, 2},
                             Line{4, 2, 5, 2}, Line{4, 4, 5, 4}, Line{4, 2, 4, 4}, Line{5, 2, 5, 4}));
}

/// The pieces of border of single cells, in a plain way.
std::set<Line> pieces_of(const grid::Mask& mask) {
    const grid::Shape shape = mask.shape();
    const auto chosen = [&](int x, int y) { return shape.contains(x, y) && mask.at(x, y) != 0; };
    std::set<Line> pieces;
    for (int y = 0; y <= shape.height; ++y) {
        for (int x = 0; x <= shape.width; ++x) {
            const auto left = static_cast<float>(x), top = static_cast<float>(y);
            if (chosen(x, y) != chosen(x, y - 1)) pieces.insert({left, top, left + 1, top});
            if (chosen(x, y) != chosen(x - 1, y)) pieces.insert({left, top, left, top + 1});
        }
    }
    return pieces;
}

TEST(SelectionOutline, HasEveryPieceOfBorderOnceAndNoOther) {
    for (const float density : {0.02F, 0.5F, 0.98F}) {
        grid::Mask mask(grid::Shape{150, 90});
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 150; ++x)
                mask.set(x, y, core::uniform_noise(150U * y + x, 7) < density ? grid::kWhole : 0);
        std::set<Line> pieces;
        for (const Line& line : borders(mask)) {
            const bool level = line[1] == line[3];
            for (float at = level ? line[0] : line[1]; at < (level ? line[2] : line[3]); ++at) {
                const Line piece =
                    level ? Line{at, line[1], at + 1, line[1]} : Line{line[0], at, line[0], at + 1};
                EXPECT_TRUE(pieces.insert(piece).second);
            }
        }
        EXPECT_EQ(pieces, pieces_of(mask));
    }
}

TEST(SelectionOutline, OfASoftEdgeRunsAlongOneHalf) {
    grid::Mask soft(grid::Shape{6, 1});
    for (int x = 0; x < 6; ++x)
        soft.set(x, 0, static_cast<std::uint8_t>(255 - 40 * x));
    EXPECT_EQ(pieces_of(grid::hardened(soft)).size(), 10U) << "four cells";
    EXPECT_EQ(borders(soft), borders(grid::hardened(soft)));
}

TEST(SelectionOutline, SaysWhenThereWouldBeTooManyLines) {
    const grid::Mask mask = mask_of({"#.#"});
    EXPECT_EQ(mask_borders_mm(mask, 1.0, {mask.shape().cells()}, 8)->size(), 2 * 8U);
    EXPECT_EQ(mask_borders_mm(mask, 1.0, {mask.shape().cells()}, 7), std::nullopt);
}

TEST(SelectionOutline, OfSpecklesIsExactCloseByAndCoarseFromAfar) {
    const grid::Shape shape{1024, 1024};
    auto mask = std::make_shared<grid::Mask>(shape);
    for (int y = 0; y < shape.height; y += 2)
        for (int x = 0; x < shape.width; x += 2)
            mask->set(x, y, grid::kWhole);
    SelectionOutline outline;
    const document::Selection selection = mask;
    EXPECT_THAT(lines_of(outline.lines_mm(selection, 1.0, shape.cells())),
                UnorderedElementsAre(Line{0, 0, 1024, 0}, Line{0, 1024, 1024, 1024}, Line{0, 0, 0, 1024},
                                     Line{1024, 0, 1024, 1024}));
    const auto close = lines_of(outline.lines_mm(selection, 1.0, {70, 70, 90, 90}));
    EXPECT_EQ(close.size(), 4U * 32 * 32 + 2 * 32) << "every speck of the tile, and what borders on it";
    EXPECT_THAT(outline.lines_mm(nullptr, 1.0, shape.cells()), IsEmpty());
}

}  // namespace
}  // namespace pastoso::view
