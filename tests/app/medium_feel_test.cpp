#include "tools/medium_feel.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

using film::Medium;

constexpr Feel kAll[] = {Feel::StiffToRunny, Feel::ShortToLong, Feel::OpaqueToTransparent};

TEST(MediumFeel, EndsAndMiddleOfEveryMediumAreAllowed) {
    for (const Medium& medium : film::bundled_media())
        for (const Feel feel : kAll)
            for (const double place : {0.0, 0.5, 1.0})
                EXPECT_NO_THROW(
                    check_numbers(with_place(medium, feel, place), core::Message::verbatim(medium.name)))
                    << place;
}

TEST(MediumFeel, TheEndsAreThoseOfTheTable) {
    for (const Feel feel : kAll) {
        Medium medium = with_place(film::find_medium("soft-body acrylic"), feel, 0.5);
        for (const auto& number : numbers_of(feel)) {
            EXPECT_EQ(with_place(medium, feel, 0.0).*number.member, number.from);
            EXPECT_EQ(with_place(medium, feel, 1.0).*number.member, number.to);
        }
    }
}

TEST(MediumFeel, AMediumStaysAsItIsWhereItStands) {
    for (const Medium& medium : film::bundled_media())
        for (const Feel feel : kAll)
            EXPECT_EQ(with_place(medium, feel, place_of(medium, feel)), medium) << medium.name;
}

TEST(MediumFeel, APlaceIsReadBackAndMovesNoOtherSlider) {
    const Medium& oil = film::find_medium("linseed oil");
    for (const Feel feel : kAll) {
        for (const double place : {0.1, 0.37, 0.9}) {
            const Medium moved = with_place(oil, feel, place);
            for (const Feel other : kAll)
                EXPECT_NEAR(place_of(moved, other), other == feel ? place : place_of(oil, other), 1e-12);
        }
    }
}

/// Each stands further along than the one before.
void expect_in_order(Feel feel, const std::vector<const char*>& media) {
    double before = -1.0;
    for (const char* name : media) {
        const double place = place_of(film::find_medium(name), feel);
        EXPECT_GT(place, before) << name;
        before = place;
    }
}

TEST(MediumFeel, TheMediaStandInTheOrderThatPaintersKnow) {
    expect_in_order(Feel::StiffToRunny, {"wax paste", "heavy-body oil", "alkyd gel", "linseed oil",
                                         "stand oil", "thin oil", "thinner"});
    expect_in_order(Feel::StiffToRunny,
                    {"soft-body acrylic", "fluid acrylic", "house paint", "ink glaze", "thinner"});
    expect_in_order(Feel::ShortToLong,
                    {"wax paste", "heavy-body oil", "linseed oil", "thin oil", "thinner"});
    expect_in_order(Feel::OpaqueToTransparent, {"heavy-body oil", "wax paste", "linseed oil",
                                                "stand oil", "thin oil", "alkyd gel", "ink glaze"});
}

TEST(MediumFeel, NumbersGoOneWay) {
    for (const Feel feel : kAll) {
        for (const auto& number : numbers_of(feel)) {
            const double sign = number.to > number.from ? 1.0 : -1.0;
            Medium medium = with_place(film::find_medium("house paint"), feel, 0.0);
            for (double place = 0.1; place < 1.05; place += 0.1) {
                const double before = medium.*number.member;
                medium = with_place(medium, feel, place);
                EXPECT_GT(sign * (medium.*number.member - before), 0.0) << place;
            }
        }
    }
}

}  // namespace
}  // namespace pastoso::tools
