// The program's settings through the real window: what is chosen holds at once, is kept, and is there
// again.
#include "app/window_fixture.hpp"
#include "appearance/theme.hpp"
#include "commands/command_names.hpp"
#include "commands/command_search.hpp"
#include "commands/command_words.hpp"
#include "core/text_file.hpp"
#include "core/thread_count.hpp"
#include "core/user_data.hpp"
#include "dialogs/settings_dialog.hpp"
#include "main/program/language.hpp"
#include "main/program/preference_commands.hpp"
#include "main/window_parts.hpp"

#include <algorithm>
#include <cmath>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QLocale>
#include <QMenuBar>
#include <QPainter>
#include <QPixmapCache>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QTest>
#include <QTimer>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using dialogs::SettingsDialog;
using testing::Contains;
using testing::HasSubstr;

class SettingsWindow : public WindowTest {
  protected:
    void TearDown() override {
        main::apply_preferences({});
        main::speak(QStringLiteral("en"));
        WindowTest::TearDown();
    }

    /// Opens the settings, and does that in them.
    void in_settings(const std::function<void(SettingsDialog&)>& work,
                     Command command = Command::EditSettings) {
        bool done = false;
        QTimer::singleShot(0, [&] {
            auto* dialog = qobject_cast<SettingsDialog*>(QApplication::activeModalWidget());
            ASSERT_NE(dialog, nullptr);
            work(*dialog);
            done = true;
            dialog->reject();
        });
        action(command)->trigger();
        EXPECT_TRUE(done);
    }
    template <class Widget>
    static Widget& find(QWidget& dialog, const char* name) {
        auto* found = dialog.findChild<Widget*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    static void choose(QWidget& dialog, const char* name, const char* value) {
        auto& box = find<QComboBox>(dialog, name);
        box.setCurrentIndex(box.findData(QString::fromLatin1(value)));
        Q_EMIT box.activated(box.currentIndex());
    }
    tools::Preferences kept() { return tools::read_preferences(main::preferences_file()); }
};

TEST_F(SettingsWindow, TheThemeChangesAtOnceAndIsKept) {
    const QColor dark = window().palette().color(QPalette::Window);
    in_settings([](QWidget& dialog) { choose(dialog, "theme", "light"); });
    const QColor light = window().palette().color(QPalette::Window);
    EXPECT_LT(dark.lightness(), 64);
    EXPECT_GT(light.lightness(), 192);
    EXPECT_EQ(kept().theme, "light");
    in_settings([](QWidget& dialog) {
        EXPECT_EQ(find<QComboBox>(dialog, "theme").currentData().toString(), "light");
        choose(dialog, "theme", "dark");
    });
    EXPECT_EQ(window().palette().color(QPalette::Window), dark);
}

TEST_F(SettingsWindow, GreysOfBothThemesAreNeutralAndTextStandsOut) {
    for (const appearance::Theme theme : {appearance::Theme::Dark, appearance::Theme::Light}) {
        appearance::apply_theme(*qApp, theme);
        const appearance::ThemeColours& colours = appearance::colours();
        for (const QColor& grey : {colours.window, colours.field, colours.button, colours.edge})
            EXPECT_LE(std::abs(grey.red() - grey.blue()), 3) << grey.name().toStdString();
        const auto contrast = [](const QColor& a, const QColor& b) {
            return std::abs(a.lightness() - b.lightness());
        };
        EXPECT_GT(contrast(colours.text, colours.window), 150);
        EXPECT_GT(contrast(colours.quiet_text, colours.window), 110);
        EXPECT_GT(contrast(colours.faint_text, colours.window), 70);
        EXPECT_GT(contrast(colours.chosen_text, colours.chosen), 120);
        EXPECT_GT(contrast(colours.warning, colours.window), 100);
    }
}

/// By the definition of WCAG 2.1.
double contrast_ratio(const QColor& a, const QColor& b) {
    const auto luminance = [](const QColor& colour) {
        const auto linear = [](double value) {
            return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
               0.0722 * linear(colour.blueF());
    };
    const double first = luminance(a), second = luminance(b);
    return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

TEST_F(SettingsWindow, HighContrastIsWhatItSaysAndGoesAgain) {
    for (const appearance::Theme theme : {appearance::Theme::Light, appearance::Theme::Dark}) {
        SCOPED_TRACE(appearance::name_of(theme));
        appearance::apply_theme(*qApp, theme);
        const QColor usual = appearance::colours().text;
        appearance::set_contrast(*qApp, appearance::Contrast::High);
        const appearance::ThemeColours& colours = appearance::colours();
        EXPECT_EQ(appearance::theme(), theme);
        for (const QColor& behind : {colours.window, colours.field, colours.button}) {
            for (const QColor& words : {colours.text, colours.quiet_text})
                EXPECT_GE(contrast_ratio(words, behind), 7.0) << behind.name().toStdString();
            EXPECT_GE(contrast_ratio(colours.faint_text, behind), 4.5) << behind.name().toStdString();
            EXPECT_GE(contrast_ratio(colours.line, behind), 3.0) << behind.name().toStdString();
        }
        EXPECT_GE(contrast_ratio(colours.chosen_text, colours.chosen), 7.0);
        EXPECT_GE(contrast_ratio(colours.warning, colours.window), 7.0);
        EXPECT_EQ(window().palette().color(QPalette::WindowText), colours.text);
        appearance::set_contrast(*qApp, appearance::Contrast::Usual);
        EXPECT_EQ(appearance::colours().text, usual);
    }
}

TEST_F(SettingsWindow, TextIsScaledFromItsFirstSize) {
    const QFont usual = QApplication::font();
    appearance::scale_text(1.5);
    EXPECT_GT(QFontInfo(QApplication::font()).pixelSize(), QFontInfo(usual).pixelSize());
    appearance::scale_text(1.5);
    appearance::scale_text(1.0);
    EXPECT_EQ(QApplication::font(), usual);
}

TEST_F(SettingsWindow, AllWordsOfTheWindowAreScaled) {
    const auto sizes = [this] {
        std::vector<double> found;
        for (const QWidget* widget : window().findChildren<QWidget*>())
            found.push_back(widget->font().pointSizeF());
        return found;
    };
    const std::vector<double> usual = sizes();
    appearance::scale_text(1.5);
    QApplication::processEvents();
    const std::vector<double> larger = sizes();
    ASSERT_EQ(larger.size(), usual.size());
    for (std::size_t i = 0; i < usual.size(); ++i)
        EXPECT_NEAR(larger[i], 1.5 * usual[i], 0.1) << i;
    appearance::scale_text(1.0);
    QApplication::processEvents();
    EXPECT_EQ(sizes(), usual);
}

TEST_F(SettingsWindow, TheCanvasLiesOnTheGroundOfTheTheme) {
    action(Command::Pause)->trigger();
    canvas().zoom_about_centre(0.2);  // its shadow does not reach the corner
    for (const char* theme : {"light", "dark"}) {
        tools::Preferences preferences;
        preferences.theme = theme;
        main::apply_preferences(preferences);
        const QColor seen = picture().pixelColor(3, 3);
        EXPECT_EQ(seen.name(), appearance::colours().ground.name()) << theme;
        EXPECT_EQ(seen.red(), seen.green()) << "no hue beside the paint";
        EXPECT_EQ(seen.red(), seen.blue()) << "no hue beside the paint";
    }
}

TEST_F(SettingsWindow, EveryCommandHasAnIconInTheColourOfTheTheme) {
    for (const commands::CommandText& text : commands::command_list()) {
        const QImage picture = action(text.command)->icon().pixmap(16, 16).toImage();
        ASSERT_FALSE(picture.isNull()) << commands::name_of(text.command);
        int drawn = 0;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x)
                drawn += picture.pixelColor(x, y).alpha() > 128 ? 1 : 0;
        EXPECT_GT(drawn, 4) << commands::name_of(text.command);
        EXPECT_LT(drawn, 200) << commands::name_of(text.command);
    }
    const auto darkest = [&] {
        const QImage picture = action(Command::LookFlat)->icon().pixmap(16, 16).toImage();
        return picture.pixelColor(8, 8).lightness();
    };
    EXPECT_GT(darkest(), 200);
    tools::Preferences light;
    light.theme = "light";
    main::apply_preferences(light);
    EXPECT_LT(darkest(), 60);
}

TEST_F(SettingsWindow, AnIconIsDrawnOnceForEachSizeScaleAndColour) {
    const QIcon icon = action(Command::DryNow)->icon();
    const auto drawn = [&icon](int side, double scale = 1.0) {
        return icon.pixmap(QSize(side, side), scale).toImage();
    };
    const qint64 first = icon.pixmap(20, 20).cacheKey();
    EXPECT_EQ(icon.pixmap(20, 20).cacheKey(), first);
    EXPECT_EQ(drawn(24).size(), QSize(24, 24));
    EXPECT_EQ(drawn(20, 2.0).size(), QSize(40, 40));
    EXPECT_NE(icon.pixmap(QSize(20, 20), QIcon::Disabled).toImage(), drawn(20));
    // Painted at once or from what was drawn before: the same.
    QImage fresh(40, 40, QImage::Format_ARGB32_Premultiplied);
    QImage again = fresh;
    for (QImage* image : {&fresh, &again}) {
        if (image == &fresh) QPixmapCache::clear();
        image->fill(Qt::transparent);
        image->setDevicePixelRatio(2.0);
        QPainter painter(image);
        icon.paint(&painter, QRect(0, 0, 20, 20));
    }
    EXPECT_EQ(fresh, again);
    tools::Preferences light;
    light.theme = "light";
    main::apply_preferences(light);
    EXPECT_NE(icon.pixmap(20, 20).cacheKey(), first);
}

TEST_F(SettingsWindow, TheMemoryForUndoIsChosenAndThereAgain) {
    const auto chosen_then = [&](int MiB) {
        int before = 0;
        in_settings(
            [&](SettingsDialog& dialog) {
                EXPECT_EQ(find<QTabWidget>(dialog, "pages").currentIndex(),
                          static_cast<int>(SettingsDialog::Page::Keeping));
                before = find<QSpinBox>(dialog, "undo_memory").value();
                find<QSpinBox>(dialog, "undo_memory").setValue(MiB);
            },
            Command::UndoMemory);
        return before;
    };
    EXPECT_EQ(chosen_then(64), 512);
    start_again();
    EXPECT_EQ(chosen_then(1024), 64);
    // Undo goes on as before.
    mouse_stroke(line_mm({10, 10}, {30, 20}));
    const double painted_mm3 = volume_mm3();
    EXPECT_GT(painted_mm3, 0.0);
    wait_for([&] { return studio().commands().action(Command::Undo)->isEnabled(); });
    action(Command::Undo)->trigger();
    EXPECT_EQ(volume_mm3(), 0.0);
}

TEST_F(SettingsWindow, SpeaksTheLanguageThatIsChosenFromTheNextStartOn) {
    const auto file_menu = [&] { return window().menuBar()->actions().front()->text(); };
    in_settings([](QWidget& dialog) { choose(dialog, "language", "sv"); });
    EXPECT_EQ(kept().language, "sv");
    EXPECT_EQ(file_menu(), "&File");
    main::speak(QStringLiteral("sv"));
    start_again();
    EXPECT_EQ(file_menu(), "&Arkiv");
    EXPECT_EQ(QLocale().decimalPoint(), ",");
    for (const char* language : {"ja", "zh_TW"}) {
        main::speak(QString::fromLatin1(language));
        start_again();
        EXPECT_GT(file_menu().front().unicode(), 0x2E80) << language;
        EXPECT_THAT(commands::find_commands(commands::plain_words("&New layer").mid(1)),
                    Contains(Command::AddLayer))
            << language;
    }
    main::speak(QStringLiteral("en"));
    start_again();
    EXPECT_EQ(file_menu(), "&File");
}

TEST_F(SettingsWindow, ThreadsHoldForTheNextPainting) {
    in_settings([](QWidget& dialog) { find<QSpinBox>(dialog, "threads").setValue(3); });
    EXPECT_EQ(core::default_thread_count(), 3);
    EXPECT_EQ(kept().threads, 3);
    in_settings([](QWidget& dialog) { find<QSpinBox>(dialog, "threads").setValue(0); });
    EXPECT_EQ(core::default_thread_count(), core::processor_count());
}

TEST_F(SettingsWindow, SavesByItselfWhereThereIsAFileAndAChangeButNotWithinAStroke) {
    in_settings([](QWidget& dialog) { find<QSpinBox>(dialog, "autosave").setValue(1); });
    EXPECT_EQ(kept().autosave_min, 1);
    auto& timer = *window().findChild<QTimer*>(QStringLiteral("autosave"));
    EXPECT_EQ(timer.interval(), 60000);
    timer.start(20);
    int times = 0;
    const QObject counting;
    QObject::connect(&timer, &QTimer::timeout, &counting, [&times] { ++times; });
    const auto let_it_come_due = [&] {
        const int wanted = times + 3;
        wait_for([&] { return times >= wanted; });
        parts().files.saver().wait();
    };
    mouse_stroke(line_mm({10, 10}, {30, 20}));
    wait_for([&] { return window().isWindowModified(); });
    let_it_come_due();
    EXPECT_TRUE(window().isWindowModified());

    const std::filesystem::path file = data_file("own.pastoso");
    std::filesystem::create_directories(file.parent_path());
    parts().files.save_painting(QString::fromStdString(file.string()));
    parts().files.saver().wait();
    const auto first = std::filesystem::last_write_time(file);
    let_it_come_due();
    EXPECT_EQ(std::filesystem::last_write_time(file), first);

    press({10, 15});
    move({20, 18});
    wait_for([&] { return session().status().stroke_in_progress; });
    let_it_come_due();
    EXPECT_EQ(std::filesystem::last_write_time(file), first);
    release({20, 18});
    wait_for([&] { return std::filesystem::last_write_time(file) != first; });
    timer.stop();
    parts().files.saver().wait();
    EXPECT_FALSE(window().isWindowModified());
}

TEST_F(SettingsWindow, TellsWhatTheMachineIsAndCopiesIt) {
    in_settings([](QWidget& dialog) {
        QApplication::clipboard()->clear();
        find<QPushButton>(dialog, "copy_facts").click();
        const std::string text = QApplication::clipboard()->text().toStdString();
        EXPECT_THAT(text, HasSubstr("Qt " QT_VERSION_STR));
        EXPECT_THAT(text, HasSubstr("OpenGL: "));
        EXPECT_THAT(text, HasSubstr("Graphics: "));
    });
}

TEST_F(SettingsWindow, AFileThatCanNotBeReadIsToldAndLeftAlone) {
    const std::string broken = "{\"version\": 1, \"theme\": \"pink\"}";
    std::filesystem::create_directories(main::preferences_file().parent_path());
    core::write_text_file(main::preferences_file(), broken);
    start_again();
    EXPECT_THAT(told(), HasSubstr("preferences.json"));
    in_settings([](QWidget& dialog) { choose(dialog, "theme", "light"); });
    EXPECT_EQ(core::read_text_file(main::preferences_file()), broken);
}

}  // namespace
}  // namespace pastoso::tests
