#include "liquid/tea/tea_settings.hpp"

#include "core/error.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

TEST(TeaSettings, TheUsualTeaIsPossible) {
    EXPECT_NO_THROW(check_tea({}));
}

TEST(TeaSettings, EveryNumberHasItsRange) {
    for (const TeaNumber& number : tea_numbers()) {
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity(), 2.0 * number.most + 1.0}) {
            TeaSettings settings;
            settings.*number.value = bad;
            EXPECT_THROW(check_tea(settings), core::InputError) << number.key << " = " << bad;
        }
    }
}

TEST(TeaSettings, TheCupMustStandInTheBox) {
    TeaSettings settings;
    settings.cup.axis_m.x = 0.03F;
    EXPECT_THROW(check_tea(settings), core::InputError);
    settings = {};
    settings.cup.level_m = settings.cup.floor_m;
    EXPECT_THROW(check_tea(settings), core::InputError);
    settings = {};
    settings.milk_m3 = tea_volume_m3(settings.cup);
    EXPECT_THROW(check_tea(settings), core::InputError);
}

}  // namespace
}  // namespace pastoso::liquid
