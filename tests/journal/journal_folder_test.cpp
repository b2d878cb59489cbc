#include "journal/journal_folder.hpp"

#include "files/temporary_folder.hpp"
#include "journal/journal_file.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::journal {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class JournalFolder : public files::TemporaryFolder {
  protected:
    static void put(const std::filesystem::path& path) { std::ofstream(path) << "x"; }
};

TEST_F(JournalFolder, IsNobodyElsesWhileItIsHeld) {
    std::filesystem::path path;
    {
        const Claim claim = Claim::on_new_folder(folder / "journals");
        path = claim.folder();
        put(path / kStrokesFile);
        EXPECT_FALSE(Claim::on(path));
        EXPECT_THAT(abandoned_journals(folder / "journals"), IsEmpty());
    }
    EXPECT_THAT(abandoned_journals(folder / "journals"), ElementsAre(path));
    EXPECT_TRUE(Claim::on(path));
}

TEST_F(JournalFolder, EveryPaintingHasItsOwn) {
    const Claim first = Claim::on_new_folder(folder), second = Claim::on_new_folder(folder);
    EXPECT_NE(first.folder(), second.folder());
}

TEST_F(JournalFolder, GoesWithEverythingInIt) {
    Claim claim = Claim::on_new_folder(folder);
    put(claim.folder() / kStrokesFile);
    put(claim.folder() / "checkpoint-1.pastoso");
    claim.discard();
    EXPECT_FALSE(std::filesystem::exists(claim.folder()));
}

TEST_F(JournalFolder, RemainsOfOneThatNeverBeganAreClearedAway) {
    const auto path = [this] { return Claim::on_new_folder(folder).folder(); }();
    std::filesystem::create_directory(folder / "painting-empty");
    std::filesystem::create_directory(folder / "not a journal");
    EXPECT_THAT(abandoned_journals(folder), IsEmpty());
    EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(JournalFolder, ThereMayBeNone) {
    EXPECT_THAT(abandoned_journals(folder / "none"), IsEmpty());
    EXPECT_FALSE(Claim::on(folder / "none"));
}

}  // namespace
}  // namespace pastoso::journal
