#include "tools/tube_rack.hpp"

#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"

#include <gmock/gmock.h>

namespace pastoso::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class TubeRackTest : public ::testing::Test {
  protected:
    std::filesystem::path file() const { return folder_.path() / "tubes.json"; }

    tests::TemporaryFolder folder_;
    const Tubes all_ = {"PW6", "PB29", "PR108", ""};
    TubeRack rack_;
};

TEST_F(TubeRackTest, StandsAsItShipsUntilItIsArranged) {
    EXPECT_EQ(shown_tubes(rack_, all_), all_);
    arrange({"PR108", "PW6", "", "PB29"}, rack_);
    EXPECT_THAT(shown_tubes(rack_, all_), ElementsAre("PR108", "PW6", "", "PB29"));
    EXPECT_THAT(shown_tubes(rack_, {"PW6", "PB29", "PR108", "PY35", ""}),
                ElementsAre("PR108", "PW6", "", "PB29", "PY35"))
        << "a new tube comes last";
    EXPECT_THAT(shown_tubes(rack_, {"PW6"}), ElementsAre("PW6"));
}

TEST_F(TubeRackTest, ASetHasItsOwnTubesAndOrder) {
    EXPECT_TRUE(save_set("sea", {"PB29", "PW6"}, rack_));
    EXPECT_THAT(shown_tubes(rack_, all_), ElementsAre("PB29", "PW6"));
    put_into_set("PR108", "sea", rack_);
    put_into_set("PW6", "sea", rack_);
    EXPECT_THAT(shown_tubes(rack_, all_), ElementsAre("PB29", "PW6", "PR108"));
    arrange({"PR108", "PB29", "PW6"}, rack_);
    take_out("PB29", rack_);
    EXPECT_THAT(shown_tubes(rack_, all_), ElementsAre("PR108", "PW6"));
    rack_.chosen.clear();
    EXPECT_EQ(shown_tubes(rack_, all_), all_) << "all tubes stand as before";
}

TEST_F(TubeRackTest, ATubeThatIsAwayIsNotLost) {
    save_set("mine", {"PX900", "PB29", "PW6"}, rack_);
    arrange({"PW6", "PB29"}, rack_);
    EXPECT_THAT(shown_tubes(rack_, all_), ElementsAre("PW6", "PB29"));
    EXPECT_THAT(shown_tubes(rack_, {"PX900", "PB29", "PW6"}), ElementsAre("PW6", "PB29", "PX900"));
}

TEST_F(TubeRackTest, SetsAreSavedRenamedAndRemoved) {
    EXPECT_FALSE(save_set("  ", {"PW6"}, rack_));
    EXPECT_FALSE(rename_chosen("sky", rack_)) << "none is chosen";
    save_set("sea", {"PW6"}, rack_);
    save_set("sky", {"PB29"}, rack_);
    save_set("sea", {"PR108"}, rack_);
    ASSERT_EQ(rack_.sets.size(), 2U) << "of that name there is one";
    EXPECT_THAT(chosen_set(rack_)->tubes, ElementsAre("PR108"));
    EXPECT_FALSE(rename_chosen("sky", rack_));
    EXPECT_FALSE(rename_chosen("", rack_));
    EXPECT_TRUE(rename_chosen("sea", rack_));
    EXPECT_TRUE(rename_chosen("storm", rack_));
    EXPECT_EQ(rack_.chosen, "storm");
    remove_chosen(rack_);
    ASSERT_EQ(rack_.sets.size(), 1U);
    EXPECT_EQ(rack_.sets[0].name, "sky");
    EXPECT_EQ(chosen_set(rack_), nullptr);
}

TEST_F(TubeRackTest, ComesBackAsItWasWritten) {
    EXPECT_EQ(read_rack(file()), TubeRack());
    arrange({"PR108", "PW6"}, rack_);
    save_set("sea \"at noon\"", {"PB29", ""}, rack_);
    save_set("sky", {}, rack_);
    write_rack(rack_, file());
    EXPECT_EQ(read_rack(file()), rack_);
}

TEST_F(TubeRackTest, SetsGoToOthersAndNoneIsThereTwice) {
    save_set("sea", {"PB29", ""}, rack_);
    save_set("sky", {"PW6"}, rack_);
    write_tube_sets(rack_.sets, file());
    const std::vector<TubeSet> sets = read_tube_sets(file());
    EXPECT_EQ(sets, rack_.sets);
    EXPECT_EQ(add_sets(sets, rack_), 0);
    TubeRack other;
    save_set("sea", {"PR108"}, other);
    EXPECT_EQ(add_sets(sets, other), 2);
    EXPECT_THAT(other.sets, ElementsAre(TubeSet{"sea", {"PR108"}}, TubeSet{"sea 2", {"PB29", ""}},
                                        TubeSet{"sky", {"PW6"}}));
    EXPECT_EQ(other.chosen, "sea") << "what is shown stays so";
}

TEST_F(TubeRackTest, FaultsOfAFileOfSetsAreToldWithTheirPlace) {
    const auto fault_of = [this](const std::string& text) -> std::string {
        core::write_text_file(file(), text);
        try {
            read_tube_sets(file());
        } catch (const core::InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(fault_of(R"({"format": "gpl", "version": 1, "sets": []})"),
                HasSubstr("tubes.json, format: \"gpl\" is not one of pastoso-tube-sets"));
    EXPECT_THAT(fault_of(R"({"format": "pastoso-tube-sets", "version": 2, "sets": []})"),
                HasSubstr("tubes.json, version: "));
    EXPECT_THAT(fault_of(R"({"format": "pastoso-tube-sets", "version": 1, "sets": [{"name": "a"}]})"),
                HasSubstr("\"tubes\" is missing"));
    EXPECT_THROW(read_tube_sets(file().parent_path() / "none.json"), core::InputError);
}

TEST_F(TubeRackTest, FaultsAreToldWithTheirPlace) {
    const auto fault_of = [this](const std::string& text) -> std::string {
        core::write_text_file(file(), text);
        try {
            read_rack(file());
        } catch (const core::InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(fault_of("{\"version\": 1, \"order\": [7], \"sets\": [], \"chosen\": \"\"}"),
                HasSubstr("tubes.json, order[0]: "));
    EXPECT_THAT(fault_of("{\"version\": 1, \"order\": [], \"sets\": [{\"name\": \"\", \"tubes\": []}], "
                         "\"chosen\": \"\"}"),
                HasSubstr("tubes.json, sets[0].name: a set needs a name."));
    EXPECT_THAT(fault_of("{\"version\": 1, \"sets\": []}"), HasSubstr("\"order\" is missing"));
}

}  // namespace
}  // namespace pastoso::tools
