// The strokes most likely to be rough: oblique ones of a full brush. smoothness_long_test.cpp has all.
#include "brush/smoothness.hpp"

namespace pastoso::brush {
namespace {

class Smoothness : public testing::TestWithParam<const char*> {};

TEST_P(Smoothness, IsThatOfFineCells) {
    for (const double angle_deg : {20.0, 61.0}) {
        SCOPED_TRACE(angle_deg);
        studio::expect_smooth_on_coarse_cells({GetParam(), angle_deg, 1.0});
    }
}

INSTANTIATE_TEST_SUITE_P(Presets, Smoothness, testing::ValuesIn(studio::kSmoothPresets),
                         [](const auto& preset) { return "Preset" + std::to_string(preset.index); });

}  // namespace
}  // namespace pastoso::brush
