// The manual as the window reads it: its pages, in which language they are had, and what is found in
// them.
#include "help/manual.hpp"

#include "core/error.hpp"
#include "core/resources.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "help/topic.hpp"

#include <algorithm>
#include <cctype>

#include <QRegularExpression>
#include <gmock/gmock.h>

namespace pastoso::help {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class ManualTest : public testing::Test {
  protected:
    ManualTest() {
        write("en", "README",
              "# The manual\n\n1. [Paint](paint.md): tubes\n2. [Keys](keys.md#all)\n"
              "3. [Paint again](paint.md#oils) and [elsewhere](../media.md)\n");
        write("en", "paint",
              "# Paint\n\nFrom **tubes**.\n\n## Kinds of paint: oils!\n\nStand `oil` levels.\n\n"
              "```\n# no heading\n```\n\n## Varnish\n\n![a coat](pictures/coat.png) Gloss, "
              "[matt](view.md).\n");
        write("en", "keys", "# Keys\n\n| oil | O |\n| --- | --- |\n");
        write("sv", "paint",
              "# F\u00e4rg\n\nUr tub.\n\n## Sorters f\u00e4rg\n\nStandolja.\n\n## Fernissa\n\nBlank.\n");
    }
    void write(const char* language, const std::string& name, const char* text) const {
        const auto folder = folder_.path() / language;
        std::filesystem::create_directories(folder);
        core::write_text_file(folder / (name + ".md"), text);
    }
    Manual manual(const char* language = "en") const {
        return {folder_.path(), QString::fromUtf8(language)};
    }
    static std::vector<std::string> places(const std::vector<Found>& found) {
        std::vector<std::string> places;
        for (const Found& one : found)
            places.push_back((one.page + QLatin1Char('#') + one.section.anchor).toStdString());
        return places;
    }

    tests::TemporaryFolder folder_;
};

TEST_F(ManualTest, HasThePagesOfItsContentsOnce) {
    const Manual read = manual();
    std::vector<std::string> titles;
    for (const Page& page : read.pages())
        titles.push_back(page.title().toStdString());
    EXPECT_THAT(titles, ElementsAre("The manual", "Paint", "Keys"));
}

TEST_F(ManualTest, NamesPartsAsLinksDo) {
    const Manual read = manual();
    const Page& paint = *read.page(QStringLiteral("paint"));
    ASSERT_EQ(paint.sections.size(), 3U) << "what stands in code is no heading";
    EXPECT_EQ(paint.sections[1].anchor, QStringLiteral("kinds-of-paint-oils"));
    EXPECT_EQ(paint.sections[2].words.trimmed(), QStringLiteral("Gloss, matt."));
    EXPECT_EQ(read.page(QStringLiteral("media")), nullptr);
}

TEST_F(ManualTest, IsEnglishWhereThereIsNoTranslation) {
    const Manual read = manual("sv");
    EXPECT_EQ(read.pages()[0].title(), QStringLiteral("The manual"));
    EXPECT_EQ(read.pages()[1].title(), QStringLiteral("F\u00e4rg"));
    EXPECT_EQ(read.pages()[1].sections[2].anchor, QStringLiteral("varnish")) << "links are the same";
    EXPECT_EQ(read.file("paint.md"), folder_.path() / "sv" / "paint.md");
    EXPECT_EQ(read.file("keys.md"), folder_.path() / "en" / "keys.md");
    EXPECT_EQ(manual("tlh").pages()[1].title(), QStringLiteral("Paint"));
}

TEST_F(ManualTest, FindsPartsThatHoldAllWords) {
    const Manual read = manual();
    EXPECT_THAT(places(read.find(QStringLiteral("OIL"))),
                ElementsAre("paint#kinds-of-paint-oils", "keys#keys"));
    EXPECT_THAT(places(read.find(QStringLiteral(" levels  stand "))),
                ElementsAre("paint#kinds-of-paint-oils"));
    EXPECT_THAT(places(read.find(QStringLiteral("paint"))),
                ElementsAre("paint#paint", "paint#kinds-of-paint-oils", "README#the-manual"))
        << "headings come first";
    EXPECT_THAT(read.find(QStringLiteral("acrylic")), IsEmpty());
    EXPECT_THAT(read.find(QStringLiteral("  ")), IsEmpty());
    EXPECT_THAT(places(manual("sv").find(QStringLiteral("olja"))),
                ElementsAre("paint#kinds-of-paint-oils"));
}

TEST_F(ManualTest, ShowsTheWordAmongOthers) {
    std::string text = "# Keys\n\n";
    for (int i = 0; i < 60; ++i)
        text += "before ";
    text += "needle";
    for (int i = 0; i < 60; ++i)
        text += " after";
    write("en", "keys", text.c_str());
    const QString excerpt = manual().find(QStringLiteral("needle")).front().excerpt;
    EXPECT_TRUE(excerpt.contains(QStringLiteral("before needle after"))) << excerpt.toStdString();
    EXPECT_TRUE(excerpt.startsWith(QStringLiteral("\u2026 before")) &&
                excerpt.endsWith(QStringLiteral(" \u2026")))
        << excerpt.toStdString();
    EXPECT_LT(excerpt.size(), 160);
}

TEST_F(ManualTest, NamesAPageThatIsNotThere) {
    std::filesystem::remove(folder_.path() / "en" / "keys.md");
    EXPECT_THROW(manual(), core::InputError);
}

// ---- the manual itself

class TheManual : public testing::Test {
  protected:
    bool has(const QString& topic) const {
        const Page* page = manual_.page(topic.section(QLatin1Char('#'), 0, 0));
        const QString anchor = topic.section(QLatin1Char('#'), 1);
        return page != nullptr &&
               (anchor.isEmpty() ||
                std::any_of(page->sections.begin(), page->sections.end(),
                            [&](const Section& section) { return section.anchor == anchor; }));
    }
    const Manual manual_{core::resource_path("manual"), QStringLiteral("en")};
};

TEST_F(TheManual, HasAPageForEveryTopic) {
    for (const Topic& topic : topics())
        EXPECT_TRUE(has(QString::fromLatin1(topic.page))) << topic.widget << ": " << topic.page;
}

TEST_F(TheManual, LinksToWhatIsThere) {
    static const QRegularExpression link(QStringLiteral("\\]\\(([^):]+)\\)"));
    int links = 0;
    for (const Page& page : manual_.pages()) {
        const std::filesystem::path file = manual_.file(page.name.toStdString() + ".md");
        const QString text = QString::fromStdString(core::read_text_file(file));
        for (auto it = link.globalMatch(text); it.hasNext(); ++links) {
            const QString to = it.next().captured(1);
            const std::string path = to.section(QLatin1Char('#'), 0, 0).toStdString();
            const std::filesystem::path target = core::resource_path("manual") / "en" / path;
            EXPECT_TRUE(path.empty() || std::filesystem::exists(target.lexically_normal()))
                << page.name.toStdString() << ": " << to.toStdString();
            const QString name = QString::fromStdString(std::filesystem::path(path).stem().string());
            const QString anchor = to.section(QLatin1Char('#'), 1);
            if (anchor.isEmpty() || !manual_.page(path.empty() ? page.name : name)) continue;
            EXPECT_TRUE(has((path.empty() ? page.name : name) + QLatin1Char('#') + anchor))
                << page.name.toStdString() << ": " << to.toStdString();
        }
    }
    EXPECT_GT(links, 100);
}

/// Libraries that the program is linked to, as the packages to build it with name them.
TEST_F(TheManual, NamesEveryLibrary) {
    const std::string page = core::read_text_file(manual_.file("libraries.md"));
    for (const char* library : {"Qt", "OpenImageIO", "libpng", "Little CMS", "libzip", "Expat",
                                "Zstandard", "JSON", "GLM", "FFTW", "Embree", "XCB", "CLI11"})
        EXPECT_THAT(page, testing::HasSubstr(std::string("[") + library));
}

}  // namespace
}  // namespace pastoso::help
