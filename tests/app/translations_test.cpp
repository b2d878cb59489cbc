// The files of the translators: all is translated, and nothing that the program fills in is lost.
#include "document/actions/actions.hpp"
#include "source_file.hpp"

#include <set>
#include <string>

#include <QFile>
#include <QRegularExpression>
#include <QStringList>
#include <QXmlStreamReader>
#include <gtest/gtest.h>

namespace pastoso::tests {
namespace {

struct Message {
    QString source;
    QStringList translations;  ///< several where it depends on a number
    bool finished = true;
};

void read_translation(QXmlStreamReader& xml, Message& message) {
    message.finished = !xml.attributes().hasAttribute(QStringLiteral("type"));
    QString text;
    while (xml.readNext() != QXmlStreamReader::EndElement) {
        if (xml.isCharacters()) text += xml.text();
        if (xml.isStartElement()) message.translations += xml.readElementText();
    }
    if (message.translations.isEmpty()) message.translations += text;
}

std::vector<Message> messages_of(const std::string& language) {
    QFile file(
        QString::fromStdString(source_file("resources/translations/pastoso_" + language + ".ts")));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << language;
    QXmlStreamReader xml(&file);
    std::vector<Message> messages;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QStringLiteral("message")) messages.emplace_back();
        if (xml.name() == QStringLiteral("source")) messages.back().source = xml.readElementText();
        if (xml.name() == QStringLiteral("translation")) read_translation(xml, messages.back());
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return messages;
}

/// "%1" and the like, sorted.
QStringList places_in(const QString& text) {
    static const QRegularExpression place(QStringLiteral("%(?:\\d+|n)"));
    QStringList places;
    for (auto found = place.globalMatch(text); found.hasNext();)
        places += found.next().captured();
    places.sort();
    return places;
}

class Translations : public ::testing::TestWithParam<const char*> {};

TEST_P(Translations, AreComplete) {
    const std::vector<Message> messages = messages_of(GetParam());
    EXPECT_GT(messages.size(), 700U);
    for (const Message& message : messages)
        EXPECT_TRUE(message.finished) << message.source.toStdString();
}

TEST_P(Translations, KeepWhatIsFilledInAndTheMnemonics) {
    for (const Message& message : messages_of(GetParam())) {
        for (const QString& translation : message.translations) {
            if (translation.isEmpty()) continue;
            EXPECT_EQ(places_in(translation), places_in(message.source))
                << message.source.toStdString() << " -> " << translation.toStdString();
            EXPECT_EQ(translation.contains(QLatin1Char('&')), message.source.contains(QLatin1Char('&')))
                << message.source.toStdString() << " -> " << translation.toStdString();
        }
    }
}

TEST_P(Translations, TellTheUndoStepOfEveryAction) {
    std::set<std::string> sources;
    for (const Message& message : messages_of(GetParam()))
        sources.insert(message.source.toStdString());
    document::AllActions::for_each([&]<class A>(std::type_identity<A>) {
        const std::string step(document::Table<A>::kTraits.step);
        EXPECT_TRUE(step.empty() || sources.contains(step)) << step;
    });
}

INSTANTIATE_TEST_SUITE_P(Languages, Translations, ::testing::Values("ja", "sv", "zh_TW"));

}  // namespace
}  // namespace pastoso::tests
