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
