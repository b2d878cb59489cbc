#include "core/value_range.hpp"

#include "core/error.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace pastoso::core {
namespace {

std::string fault(double value) {
    try {
        check_range("depth_m", value, -0.5, 2.0);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ValueRange, BothEndsBelongToIt) {
    for (const double value : {-0.5, 0.0, 2.0})
        EXPECT_EQ(fault(value), "") << value;
}

TEST(ValueRange, WhatLiesOutsideIsNamedWithTheRange) {
    EXPECT_EQ(fault(2.25), "depth_m is 2.25, not between -0.5 and 2.");
    EXPECT_EQ(fault(-1e-3 - 0.5), "depth_m is -0.501, not between -0.5 and 2.");
}

TEST(ValueRange, WhatIsNoNumberLiesInNone) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double value : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity})
        EXPECT_NE(fault(value), "") << value;
}

}  // namespace
}  // namespace pastoso::core
