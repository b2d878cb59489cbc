// What the engine tells can be read in the painter's language.
#include "appearance/shown_message.hpp"

#include "core/error.hpp"

#include <QCoreApplication>
#include <QTranslator>
#include <gtest/gtest.h>

namespace pastoso::appearance {
namespace {

/// Answers as a file of translations does.
class InSwedish : public QTranslator {
  public:
    QString translate(const char* context, const char* text, const char*, int) const override {
        if (QLatin1String(context) != QLatin1String("Engine")) return {};
        if (QLatin1String(text) == QLatin1String("%1: is %2, not a file."))
            return QStringLiteral("%2, ingen fil: %1");
        return QLatin1String(text) == QLatin1String("a folder") ? QStringLiteral("en mapp") : QString();
    }
    bool isEmpty() const override { return false; }
};

TEST(ShownMessage, IsTranslatedWithItsWordsButNotWithNames) {
    int count = 0;
    const QCoreApplication program(count, nullptr);
    const core::Message told =
        core::message("%1: is %2, not a file.", "a folder", core::message("a folder"));
    EXPECT_EQ(shown_message(told), QStringLiteral("a folder: is a folder, not a file."));
    InSwedish words;
    QCoreApplication::installTranslator(&words);
    EXPECT_EQ(shown_message(told), QStringLiteral("en mapp, ingen fil: a folder"));
    EXPECT_EQ(shown_sentence(told), QStringLiteral("En mapp, ingen fil: a folder"));
    EXPECT_EQ(shown_sentence(core::message("nobody has translated this.")),
              QStringLiteral("Nobody has translated this."));
    EXPECT_EQ(shown_sentence({}), QString());
}

TEST(ShownMessage, KeepsLettersOfAllLanguages) {
    EXPECT_EQ(shown_message(core::message("%1: cannot be read to its end.", "絵/målning.png")),
              QStringLiteral("絵/målning.png: cannot be read to its end."));
}

}  // namespace
}  // namespace pastoso::appearance
