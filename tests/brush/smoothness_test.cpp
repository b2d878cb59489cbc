// Oblique strokes of a full brush, which are most likely to be rough, and one of a dry one.
// smoothness_long_test.cpp has all.
#include "brush/smoothness.hpp"

namespace pastoso::brush {
namespace {

class Smoothness : public testing::TestWithParam<const char*> {};

TEST_P(Smoothness, IsThatOfFineCells) {
    studio::expect_slopes_of_fine_cells(
        {{GetParam(), 20.0, 1.0}, {GetParam(), 61.0, 1.0}, {GetParam(), 7.0, 0.1}});
}

INSTANTIATE_TEST_SUITE_P(Presets, Smoothness, testing::ValuesIn(studio::kSmoothPresets),
                         [](const auto& preset) { return "Preset" + std::to_string(preset.index); });

}  // namespace
}  // namespace pastoso::brush
