#include "tools/medium_numbers.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

using film::Medium;

TEST(MediumNumbers, AnyChangeOfAnyMediumIsOneThatThePaintTakes) {
    for (const Medium& medium : film::bundled_media())
        for (const film::MediumNumber& number : film::medium_numbers())
            for (const double value : {number.least - 1.0, number.least, number.most, number.most + 1.0}) {
                const Medium changed = with_number(medium, number.member, value);
                EXPECT_NO_THROW(film::check_numbers(changed, core::Message::verbatim(number.key)));
            }
}

TEST(MediumNumbers, OthersStayAsTheyAre) {
    const Medium oil = film::find_medium("heavy-body oil");
    Medium expected = oil;
    expected.viscosity_m2_s = 0.01;
    EXPECT_EQ(with_number(oil, &Medium::viscosity_m2_s, 0.01), expected);
}

TEST(MediumNumbers, AngleAndProfileKeepTheirOrder) {
    const Medium oil = film::find_medium("heavy-body oil");
    EXPECT_EQ(with_number(oil, &Medium::advancing_angle_deg, 4.0).receding_angle_deg, 4.0);
    EXPECT_EQ(with_number(oil, &Medium::alpha_min, 1.5).alpha_max, 1.5);
}

}  // namespace
}  // namespace pastoso::tools
