// Eight presets in six directions, loaded, half empty and dry.
#include "brush/smoothness.hpp"

namespace pastoso::brush {
namespace {

class SmoothnessOfAll : public testing::TestWithParam<const char*> {};

TEST_P(SmoothnessOfAll, IsThatOfFineCells) {
    std::vector<studio::StraightStroke> strokes;
    for (const double fill : {1.0, 0.4, 0.1})
        for (const double angle_deg : {0.0, 7.0, 20.0, 33.0, 45.0, 61.0})
            strokes.push_back({GetParam(), angle_deg, fill});
    studio::expect_slopes_of_fine_cells(strokes);
}

INSTANTIATE_TEST_SUITE_P(Presets, SmoothnessOfAll, testing::ValuesIn(studio::kSmoothPresets),
                         [](const auto& preset) { return "Preset" + std::to_string(preset.index); });

}  // namespace
}  // namespace pastoso::brush
