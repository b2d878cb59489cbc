#include "pigment/user_pigments.hpp"

#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

using testing::HasSubstr;

std::string heading() {
    std::string text = "ci_name,name,coef";
    for (int nm = 380; nm <= 730; nm += 10)
        text += "," + std::to_string(nm);
    return text + "\n";
}

/// One line with the same value in so many columns.
std::string line(const std::string& labels, double value, int columns = kSpectralSamples) {
    std::ostringstream text;
    text << labels;
    for (int i = 0; i < columns; ++i)
        text << ',' << value;
    return text.str() + "\n";
}

std::string file_of(const std::string& ci_name, double absorption) {
    return heading() + line(ci_name + ",Mine,K", absorption) + line(ci_name + ",Mine,S", 30.0);
}

class UserPigmentFolder : public testing::Test {
  protected:
    void write(const std::string& name, const std::string& text) {
        core::write_text_file(folder_.path() / name, text);
    }
    UserPigments read() const { return read_user_pigments(folder_.path()); }

    tests::TemporaryFolder folder_;
};

TEST_F(UserPigmentFolder, IsReadInTheOrderOfItsFiles) {
    write("b.csv", file_of("Mine-2", 2.0));
    write("a.csv", file_of("Mine-1", 1.0));
    write("notes.txt", "no pigments");
    const UserPigments user = read();
    EXPECT_TRUE(user.faults.empty());
    ASSERT_EQ(user.pigments.size(), 2U);
    EXPECT_EQ(user.pigments[0].ci_name, "Mine-1");
    EXPECT_EQ(user.pigments[1].ci_name, "Mine-2");
    EXPECT_FLOAT_EQ(user.pigments[1].coefficients[3], 2.0F);
}

TEST_F(UserPigmentFolder, ThatDoesNotExistIsEmpty) {
    const UserPigments user = read_user_pigments(folder_.path() / "none");
    EXPECT_TRUE(user.pigments.empty());
    EXPECT_TRUE(user.faults.empty());
}

TEST_F(UserPigmentFolder, AFileWithTooFewBandsIsLeftOutAndTheOthersStay) {
    write("bad.csv", heading() + line("Mine-1,Mine,K", 1.0, 20) + line("Mine-1,Mine,S", 1.0));
    write("good.csv", file_of("Mine-2", 2.0));
    const UserPigments user = read();
    ASSERT_EQ(user.pigments.size(), 1U);
    EXPECT_EQ(user.pigments[0].ci_name, "Mine-2");
    ASSERT_EQ(user.faults.size(), 1U);
    EXPECT_EQ(user.faults[0].text(),
              (folder_.path() / "bad.csv").string() +
                  ", line 2: column 24 (580): missing; there are 23 columns instead of 39.");
}

TEST_F(UserPigmentFolder, NamesThatAreTakenAreRefused) {
    write("1.csv", file_of("PB29", 2.0));
    write("2.csv", file_of("Mine", 2.0));
    write("3.csv", file_of("Mine", 3.0));
    const UserPigments user = read();
    ASSERT_EQ(user.pigments.size(), 1U);
    ASSERT_EQ(user.faults.size(), 2U);
    EXPECT_THAT(user.faults[0].text(), HasSubstr("1.csv: there is already a pigment \"PB29\""));
    EXPECT_THAT(user.faults[1].text(), HasSubstr("3.csv: there is already a pigment \"Mine\""));
}

TEST_F(UserPigmentFolder, PaintStrongerThanTheFilmCanHoldIsRefused) {
    write("1.csv", file_of("Mine", 5000.0));
    const UserPigments user = read();
    ASSERT_EQ(user.faults.size(), 1U);
    EXPECT_THAT(user.faults[0].text(), HasSubstr("K of the pigment \"Mine\" is 5000"));
}

}  // namespace
}  // namespace pastoso::pigment
