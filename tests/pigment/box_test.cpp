#include "pigment/box.hpp"

#include "core/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

using testing::HasSubstr;

std::string failure(const std::string& json) {
    try {
        parse_box(json, "box.json", bundled_palette());
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(DefaultBox, HoldsTheDesignsPaintsInTheirOrder) {
    const std::vector<std::string> names = {"PW6",   "PW4",     "PY35",    "PY74", "PY43",   "PO20",
                                            "PR108", "PR254",   "PR101",   "PR83", "PV19",   "PR122",
                                            "PV23",  "PB29",    "PB28",    "PB36", "PB15:3", "PG7",
                                            "PG18",  "PBr7-BS", "PBr7-RU", "PBk9"};
    ASSERT_EQ(default_box().size(), 22U);
    for (std::size_t i = 0; i < names.size(); ++i)
        EXPECT_EQ(default_box()[i].ci_name, names[i]);
}

TEST(ParseBox, KeepsTheOrder) {
    EXPECT_EQ(parse_box(R"({"box": ["PB29", "PW6"]})", "box.json", bundled_palette()),
              (std::vector<std::string>{"PB29", "PW6"}));
}

TEST(ParseBox, NamesTheEntry) {
    EXPECT_THAT(failure("{"), HasSubstr("box.json: this is not valid JSON"));
    EXPECT_THAT(failure("[]"), HasSubstr("box.json: the list \"box\" of paints is missing"));
    EXPECT_THAT(failure(R"({"box": []})"), HasSubstr("the list \"box\" of paints is missing"));
    EXPECT_THAT(failure(R"({"box": ["PW6", 4]})"), HasSubstr("box.json, box[1]: expected the name"));
    EXPECT_THAT(failure(R"({"box": ["PX1"]})"), HasSubstr("box[0]: there is no pigment \"PX1\""));
    EXPECT_THAT(failure(R"({"box": ["PW6", "PW6"]})"), HasSubstr("box[1]: \"PW6\" stands there twice"));
}

}  // namespace
}  // namespace pastoso::pigment
