// Which tools the list shows.
#include "panels/pen/brush_finder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::panels {
namespace {

using testing::ElementsAre;
using Kind = BrushChoice::Kind;

std::vector<BrushEntry> entries() {
    return {{QStringLiteral("Flat"), QStringLiteral("Brushes")},
            {QStringLiteral("Fan"), QStringLiteral("Brushes"), 10.0, true},
            {QStringLiteral("Palette knife"), QStringLiteral("Knives")},
            {QStringLiteral("broken.json"), QStringLiteral("Cannot be read"), 0.0, true,
             QStringLiteral("is broken")}};
}

const tools::BrushShelf kShelf{{"Palette knife", "gone"},
                               {"Palette knife", "gone", "Flat", "broken.json"}};

std::vector<std::string> names(const BrushChoice& choice) {
    std::vector<std::string> list;
    for (const BrushEntry& entry : chosen_brushes(entries(), kShelf, choice))
        list.push_back(entry.name.toStdString());
    return list;
}

TEST(BrushFinder, AllStandInTheirOrderAndFavouritesAreMarked) {
    EXPECT_THAT(names({}), ElementsAre("Flat", "Fan", "Palette knife", "broken.json"));
    EXPECT_TRUE(chosen_brushes(entries(), kShelf, {})[2].favourite);
    EXPECT_FALSE(chosen_brushes(entries(), kShelf, {})[0].favourite);
}

TEST(BrushFinder, AFolderHoldsItsOwn) {
    EXPECT_THAT(names({Kind::Favourites}), ElementsAre("Palette knife"));
    EXPECT_THAT(names({Kind::Own}), ElementsAre("Fan", "broken.json"));
    EXPECT_THAT(names({Kind::Family, QStringLiteral("Brushes")}), ElementsAre("Flat", "Fan"));
}

TEST(BrushFinder, FavouritesAndTagsStandInTheirOwnOrderUnderNoHeading) {
    tools::BrushShelf shelf{{"Palette knife", "Flat"}, {}};
    tools::set_tag("Fan", "hair", true, shelf);
    tools::set_tag("Flat", "hair", true, shelf);
    const auto names_in = [&](const BrushChoice& choice) {
        std::vector<std::string> list;
        for (const BrushEntry& entry : chosen_brushes(entries(), shelf, choice)) {
            list.push_back(entry.name.toStdString());
            EXPECT_TRUE(entry.family.isEmpty());
        }
        return list;
    };
    EXPECT_THAT(names_in({Kind::Favourites}), ElementsAre("Palette knife", "Flat"));
    EXPECT_THAT(names_in({Kind::Tag, QStringLiteral("hair")}), ElementsAre("Fan", "Flat"));
}

TEST(BrushFinder, EachFamilyStandsInThePaintersOrder) {
    const tools::BrushShelf shelf{{}, {}, {"Palette knife", "gone", "Fan"}};
    std::vector<std::string> list;
    for (const BrushEntry& entry : chosen_brushes(entries(), shelf, {}))
        list.push_back(entry.name.toStdString());
    EXPECT_THAT(list, ElementsAre("Fan", "Flat", "Palette knife", "broken.json"));
}

TEST(BrushFinder, TheLatestComesFirstAndWhatCannotBeTakenIsLeftOut) {
    EXPECT_THAT(names({Kind::Recent}), ElementsAre("Palette knife", "Flat"));
    EXPECT_TRUE(chosen_brushes(entries(), kShelf, {Kind::Recent})[0].family.isEmpty());
}

TEST(BrushFinder, LettersLookThroughAllNamesAndFamilies) {
    EXPECT_THAT(names({Kind::Favourites, {}, QStringLiteral("fl")}), ElementsAre("Flat"));
    EXPECT_THAT(names({Kind::All, {}, QStringLiteral("KNI pal")}), ElementsAre("Palette knife"));
    EXPECT_THAT(names({Kind::All, {}, QStringLiteral("brush")}), ElementsAre("Flat", "Fan"));
    EXPECT_THAT(names({Kind::All, {}, QStringLiteral("lat")}), ElementsAre());
    EXPECT_THAT(names({Kind::Favourites, {}, QStringLiteral("  ")}), ElementsAre("Palette knife"));
}

}  // namespace
}  // namespace pastoso::panels
