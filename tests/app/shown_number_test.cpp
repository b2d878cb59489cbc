// Numbers as the painter's language writes them.
#include "appearance/shown_number.hpp"

#include <QLocale>
#include <gtest/gtest.h>

namespace pastoso::appearance {
namespace {

class ShownNumber : public testing::Test {
  protected:
    static void speak(const char* language) { QLocale::setDefault(QLocale(QLatin1String(language))); }
    void TearDown() override { QLocale::setDefault(before_); }

  private:
    QLocale before_;
};

TEST_F(ShownNumber, HasTheDecimalsAskedForAndTheMarkOfTheLanguage) {
    speak("en");
    EXPECT_EQ(shown_number(1.0, 2), "1.00");
    EXPECT_EQ(shown_number(2.25, 0), "2");
    speak("sv");
    EXPECT_EQ(shown_number(1.0, 2), "1,00");
}

TEST_F(ShownNumber, HasAtMostSixDigitsAndNoMarksBetweenThousands) {
    speak("en");
    EXPECT_EQ(shown_number(297.0), "297");
    EXPECT_EQ(shown_number(300.0 / 25.4), "11.811");
    EXPECT_EQ(shown_number(1234.5), "1234.5");
    EXPECT_EQ(shown_number(12345.0, 1), "12345.0");
    speak("sv");
    EXPECT_EQ(shown_number(1234.5), "1234,5");
}

}  // namespace
}  // namespace pastoso::appearance
