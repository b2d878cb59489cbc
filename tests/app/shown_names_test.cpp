// Whatever ships by name can be read in the painter's language.
#include "appearance/shown_names.hpp"

#include "brush/preset_fields.hpp"
#include "document/layers.hpp"
#include "film/media_families.hpp"
#include "pigment/palette.hpp"

#include <set>
#include <string>

#include <QCoreApplication>
#include <QTranslator>
#include <gtest/gtest.h>

namespace pastoso::appearance {
namespace {

/// All that the files name, in no language but their own.
std::set<std::string> names_in_files() {
    std::set<std::string> names;
    for (const brush::Preset& preset : brush::bundled_presets())
        names.insert(preset.name);
    for (const brush::PresetField& field : brush::preset_fields())
        names.insert(std::string(field.meaning));
    for (const pigment::Pigment& paint : pigment::bundled_palette())
        names.insert(paint.name);
    for (const film::Medium& medium : film::bundled_media())
        names.insert({medium.name, medium.description});
    for (const film::MediaFamily& family : film::bundled_media_families())
        names.insert(family.name);
    for (const document::Layer& layer : document::single_layer().layers)
        names.insert(layer.look.name);
    return names;
}

TEST(ShownNames, AreThoseOfTheFiles) {
    const auto table = translated_names();
    EXPECT_EQ(std::set<std::string>(table.begin(), table.end()), names_in_files());
}

TEST(ShownNames, NoneStandsThereTwice) {
    const auto table = translated_names();
    EXPECT_EQ(std::set<std::string>(table.begin(), table.end()).size(), table.size());
}

/// Answers as a file of translations does.
class InSwedish : public QTranslator {
  public:
    QString translate(const char* context, const char* text, const char*, int) const override {
        const bool known = QLatin1String(context) == QLatin1String("pastoso::appearance") &&
                           QLatin1String(text) == QLatin1String("Titanium white");
        return known ? QStringLiteral("Titanvitt") : QString();
    }
    bool isEmpty() const override { return false; }
};

TEST(ShownNames, AreTranslatedAndThePaintersOwnAreNot) {
    int count = 0;
    const QCoreApplication program(count, nullptr);
    InSwedish words;
    QCoreApplication::installTranslator(&words);
    EXPECT_EQ(shown_name(std::string("Titanium white")), QStringLiteral("Titanvitt"));
    EXPECT_EQ(shown_name(std::string("My titanium white")), QStringLiteral("My titanium white"));
}

TEST(ShownNames, StandAloneWithACapital) {
    EXPECT_EQ(shown_title("thin oil"), QStringLiteral("Thin oil"));
    EXPECT_EQ(shown_title(""), QString());
}

}  // namespace
}  // namespace pastoso::appearance
