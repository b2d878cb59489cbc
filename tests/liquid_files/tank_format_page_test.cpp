// docs/tank-format.md states every number as the program has it, and its example and the scenes that
// come with the program are read.
#include "core/text_file.hpp"
#include "files/format_page.hpp"
#include "liquid_files/tank_json.hpp"
#include "source_file.hpp"

#include <map>
#include <set>

#include <gmock/gmock.h>

namespace pastoso::liquid_files {
namespace {

using tank::ShapeDistance;
using tank::TankScene;
using Rows = std::map<std::string, files::FormatRow>;

constexpr const char* kPage = "tank-format.md";

/// A tank written out, one object.
files::Json usual() {
    return files::parse_json(tank_to_json(TankScene{}), "usual");
}

TankScene read(const std::string& entries) {
    return tank_from_json(R"({"format": "pastoso-tank", "version": 1, )" + entries + "}", "page");
}

TEST(TankFormatPage, StatesEveryNumberAsTheProgramHasIt) {
    files::expect_numbers(files::rows_of_page(kPage), tank::tank_numbers(), TankScene{});
}

/// The range is that of the reader: `entries` around a value.
void expect_readers_range(const Rows& rows, const std::string& key, const std::string& before,
                          const std::string& after, double beside) {
    ASSERT_TRUE(rows.contains(key)) << key << " is missing";
    const std::string& range = rows.at(key).range;
    const std::size_t to = range.find(" to ");
    const auto least = files::number_of(range.substr(0, to)),
               most = files::number_of(range.substr(to + 4));
    ASSERT_TRUE(least && most) << key;
    const auto with = [&](double value) {
        return before +
               (beside == 1.0 ? files::Json(static_cast<std::int64_t>(value)) : files::Json(value))
                   .dump() +
               after;
    };
    EXPECT_NO_THROW(read(with(*least))) << key;
    EXPECT_NO_THROW(read(with(*most))) << key;
    EXPECT_THROW(read(with(*least - beside)), core::InputError) << key;
    EXPECT_THROW(read(with(*most + beside)), core::InputError) << key;
}

TEST(TankFormatPage, StatesTheWholeNumbersAsTheProgramHasThem) {
    const Rows rows = files::rows_of_page(kPage);
    expect_readers_range(rows, "seed", "\"seed\": ", "", 1.0);
    expect_readers_range(rows, "cells", "\"cells\": [8, ", ", 8]", 1.0);
    EXPECT_EQ(files::number_of(rows.at("seed").value), usual().at("seed").get<double>());
    EXPECT_EQ(files::number_of(rows.at("cells").value), usual().at("cells")[0].get<double>());
}

TEST(TankFormatPage, StatesTheWindAsTheProgramHasIt) {
    const Rows rows = files::rows_of_page(kPage);
    for (const auto& [key, value] : usual().at("wind").items()) {
        expect_readers_range(rows, key, "\"wind\": {\"" + key + "\": ", "}", 0.5);
        EXPECT_EQ(files::number_of(rows.at(key).value), value.get<double>()) << key;
    }
}

TEST(TankFormatPage, NamesNothingThatTheProgramDoesNotHave) {
    const files::Json values = usual();
    std::set<std::string> known;
    for (const auto& [key, value] : values.items())
        known.insert(key);
    for (const auto& [key, value] : values.at("wind").items())
        known.insert(key);
    for (const auto& [key, row] : files::rows_of_page(kPage))
        EXPECT_TRUE(known.contains(key)) << key;
    const std::string page = core::read_text_file(tests::source_file("docs/tank-format.md"));
    for (const std::string& key : known)
        EXPECT_THAT(page, testing::HasSubstr("`" + key + "`"));
}

TEST(TankFormatPage, TheExampleIsRead) {
    const TankScene scene = tank_from_json(files::example_of_page(kPage), "example");
    EXPECT_EQ(scene.liquids.size(), 2U);
    EXPECT_EQ(scene.solids.size(), 1U);
    EXPECT_EQ(scene.jets.size(), 1U);
    EXPECT_EQ(scene.drains.size(), 1U);
    EXPECT_EQ(scene.wind.speed_m_s, 2.0);
    // The bowl is open at the top, and the ball falls into it.
    const ShapeDistance bowl(scene.solids[0]);
    EXPECT_GT(bowl({0.12F, 0.1F, 0.1F}), 0.0F);
    EXPECT_LT(bowl({0.12F, 0.1F, 0.055F}), 0.0F);
    EXPECT_GT(bowl({0.12F, 0.1F, 0.145F}), 0.0F);
    EXPECT_LT(ShapeDistance(scene.liquids[1].shape)({0.12F, 0.1F, 0.18F}), 0.0F);
}

TEST(TankFormatPage, ScenesThatComeWithTheProgramAreListedAndRead) {
    const std::string page = core::read_text_file(tests::source_file("docs/tank-format.md"));
    EXPECT_THAT(bundled_tank_names(), testing::ElementsAre("falling-liquid", "two-liquids"));
    for (const std::string& name : bundled_tank_names()) {
        EXPECT_FALSE(read_tank(name).name.empty()) << name;
        EXPECT_THAT(page, testing::HasSubstr("| `" + name + "` |"));
    }
    EXPECT_THROW(read_tank("none"), core::InputError);
}

/// What of the tank's room the cells hold whose middles `is_in` accepts, in m3.
template <class Inside>
double volume_m3(const TankScene& scene, Inside&& is_in) {
    int count = 0;
    for (int k = 0; k < scene.cells.z; ++k)
        for (int j = 0; j < scene.cells.y; ++j)
            for (int i = 0; i < scene.cells.x; ++i)
                count += is_in((glm::vec3(i, j, k) + 0.5F) * static_cast<float>(scene.cell_m)) ? 1 : 0;
    return count * scene.cell_m * scene.cell_m * scene.cell_m;
}

TEST(TankFormatPage, TheLiquidThatFallsIsABallAboveAPool) {
    const TankScene scene = read_tank("falling-liquid");
    const ShapeDistance pool(scene.liquids.at(0).shape), ball(scene.liquids.at(1).shape);
    const glm::vec3 size = scene.size_m();
    const double floor_m2 = static_cast<double>(size.x) * static_cast<double>(size.y);
    EXPECT_NEAR(volume_m3(scene, [&](const glm::vec3& at) { return pool(at) < 0.0F; }), 0.04 * floor_m2,
                1e-9);
    // Counted in cells, of which 8000 lie in it; a percent is a 1/75 of a cell off its surface.
    EXPECT_NEAR(volume_m3(scene, [&](const glm::vec3& at) { return ball(at) < 0.0F; }), 5.236e-4, 5e-6);
    EXPECT_EQ(
        volume_m3(scene, [&](const glm::vec3& at) { return std::max(ball(at), pool(at)) < 0.02F; }),
        0.0);
}

TEST(TankFormatPage, TheTwoLiquidsLieApartWithSolidsBetweenThem) {
    const TankScene scene = read_tank("two-liquids");
    const ShapeDistance dam(scene.liquids.at(0).shape), milk(scene.liquids.at(1).shape);
    EXPECT_EQ(scene.liquids[0].milk, 0.0F);
    EXPECT_EQ(scene.liquids[1].milk, 1.0F);
    const ShapeDistance post(scene.solids.at(0)), sill(scene.solids.at(1));
    const auto with = [&](const ShapeDistance& a, const ShapeDistance& b) {
        return volume_m3(scene, [&](const glm::vec3& at) { return std::max(a(at), b(at)) < 0.0F; });
    };
    EXPECT_EQ(with(post, dam), 0.0);
    EXPECT_EQ(with(post, milk), 0.0);
    EXPECT_EQ(with(sill, dam), 0.0);
    EXPECT_EQ(with(dam, milk), 0.0);
    EXPECT_GT(with(dam, dam), 2e-3);
    EXPECT_GT(with(milk, milk) - with(milk, sill), 3e-4);
    // The sill is higher than the milk, which reaches up to it, and lower than the dam.
    EXPECT_LT(sill({0.266F, 0.1F, 0.022F}), 0.0F);
    EXPECT_GT(milk({0.3F, 0.1F, 0.022F}), 0.0F);
    EXPECT_LT(std::max(milk({0.27F, 0.1F, 0.018F}), sill({0.27F, 0.1F, 0.018F})), 0.0F);
    EXPECT_GT(sill({0.266F, 0.1F, 0.026F}), 0.0F);
}

}  // namespace
}  // namespace pastoso::liquid_files
