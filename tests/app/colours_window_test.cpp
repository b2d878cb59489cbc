// The colours of the screen through the real window: profiles of files, of the system, of a printer.
#include "app/window_fixture.hpp"
#include "appearance/screen_colours.hpp"
#include "core/text_file.hpp"
#include "dialogs/settings_dialog.hpp"
#include "files/made_profiles.hpp"
#include "glass/liquid_picture_dialog.hpp"
#include "glass/tank_page.hpp"
#include "glass/tea_page.hpp"
#include "liquid_files/tank_json.hpp"
#include "main/liquids/tank_mode.hpp"
#include "main/liquids/tea_mode.hpp"
#include "main/program/colord_profile.hpp"
#include "main/program/kept_preferences.hpp"
#include "main/window_parts.hpp"
#include "panels/paint/paint_swatch.hpp"
#include "pigment/colour.hpp"

#include <cmath>
#include <xcb/xcb.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDBusMessage>
#include <QDBusObjectPath>
#include <QDBusVariant>
#include <QDBusVirtualObject>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QScreen>
#include <QSpinBox>
#include <QTimer>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using dialogs::SettingsDialog;
using testing::EndsWith;
using testing::HasSubstr;

constexpr double kGamma = 1.8;

class ColoursWindow : public WindowTest {
  protected:
    void TearDown() override {
        WindowTest::TearDown();
        appearance::screen_colours().use(nullptr, nullptr);
        appearance::screen_colours().squint(false);
    }
    std::string file(const char* name, const std::string& bytes) {
        core::write_text_file(folder_.path() / name, bytes);
        return (folder_.path() / name).string();
    }
    std::string swapped() { return file("screen.icc", made_monitor(swapped_primaries(), kGamma)); }
    std::string printer() { return file("ink.icc", made_printer()); }

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
    static void choose(QWidget& dialog, const char* value, const char* name = "monitor") {
        auto* box = dialog.findChild<QComboBox*>(QString::fromLatin1(name));
        box->setCurrentIndex(box->findData(QString::fromLatin1(value)));
        Q_EMIT box->activated(box->currentIndex());
    }
    static void type(QWidget& dialog, const char* name, const std::string& path) {
        auto* line = dialog.findChild<QLineEdit*>(QString::fromLatin1(name));
        line->setText(QString::fromStdString(path));
        Q_EMIT line->editingFinished();
    }
    void show_on(const std::string& path) {
        in_settings([&](SettingsDialog& dialog) {
            choose(dialog, "file");
            type(dialog, "monitor_file", path);
        });
    }
    void print_on(const std::string& path) {
        in_settings([&](SettingsDialog& dialog) { type(dialog, "printer_file", path); });
    }
    std::vector<panels::StandingMessage> messages() { return studio().messages().standing(); }

    void give(Command command) { action(command)->trigger(); }
    void paint() {
        give(Command::Pause);
        mouse_stroke(line_mm({8.0, 6.0}, {48.0, 33.0}));
    }

    tests::TemporaryFolder folder_;
};

/// What the screen with swapped primaries is given for a level.
double swapped_level(int level) {
    return 255.0 * std::pow(pigment::decode_srgb(level / 255.0), 1.0 / kGamma);
}

/// Of the canvas's pixels, the mean distance from what the screen is to be given, in levels.
double mean_fault(const QImage& plain, const QImage& seen) {
    double sum = 0.0;
    for (int y = 0; y < plain.height(); ++y)
        for (int x = 0; x < plain.width(); ++x) {
            const QColor before = plain.pixelColor(x, y), after = seen.pixelColor(x, y);
            sum += std::abs(after.red() - swapped_level(before.green())) +
                   std::abs(after.green() - swapped_level(before.red())) +
                   std::abs(after.blue() - swapped_level(before.blue()));
        }
    return sum / (3.0 * plain.width() * plain.height());
}

TEST_F(ColoursWindow, CanvasAndSwatchesTakeTheColoursOfTheScreen) {
    paint();
    for (const char* drawn_by : {"processor", "opengl"}) {
        in_settings([&](QWidget& dialog) { choose(dialog, drawn_by, "drawn_by"); });
        canvas().fit();
        canvas().zoom_about_centre(2.0);  // nothing but canvas
        const QImage plain = picture();
        auto* swatch = window().findChildren<panels::PaintSwatch*>().front();
        const QPoint beside_the_mark(swatch->width() / 2, swatch->height() / 2);
        const QColor before = swatch->grab().toImage().pixelColor(beside_the_mark);
        show_on(swapped());
        EXPECT_TRUE(messages().empty());
        const QImage seen = picture();
        // Both pictures are dithered, each by half a level at most and a quarter in the mean, which the
        // curve raises in the dark.
        EXPECT_LT(mean_fault(plain, seen), 0.75);
        EXPECT_GT(difference(plain, seen).mean, 3.0);
        const QColor after = swatch->grab().toImage().pixelColor(beside_the_mark);
        EXPECT_NEAR(after.red(), swapped_level(before.green()), 1.0);
        EXPECT_NEAR(after.green(), swapped_level(before.red()), 1.0);
        in_settings([](QWidget& dialog) { choose(dialog, "none"); });
        EXPECT_EQ(difference(picture(), plain).largest, 0);
    }
}

class LiquidColours : public ColoursWindow {
  protected:
    void open_small_tank() {
        tank::TankScene scene;
        scene.cells = {12, 12, 12};
        scene.cell_m = 0.01;
        scene.liquids.push_back(
            {.shape = {tank::Block{glm::vec3(-0.1F), glm::vec3(0.3F, 0.3F, 0.04F)}}});
        parts().tank.open_scene(
            QString::fromStdString(file("small.json", liquid_files::tank_to_json(scene))));
        wait_for([this] { return parts().tank.page().view().shown() != nullptr; });
    }
    void open_small_glass() {
        give(Command::MilkTea);
        liquid::TeaSettings settings;
        settings.cells = 16;
        parts().tea.page().panel().show_settings(settings);
        give(Command::TeaNewGlass);
        wait_for([this] {
            const auto* shown = parts().tea.page().view().shown();
            return shown != nullptr && shown->settings.cells == 16;
        });
    }
    /// At rest, and small, so that it is drawn soon without a graphics card.
    QImage frame(glass::GlassView& view) {
        view.setFixedSize(320, 240);
        view.set_hurried(true);
        QApplication::processEvents();
        wait_for([&] { return view.finished(); });
        return view.grabFramebuffer().convertToFormat(QImage::Format_RGB888);
    }
    void expect_colours_of_the_screen(glass::GlassView& view) {
        const QImage plain = frame(view), kept = view.picture();
        EXPECT_EQ(difference(plain, kept.convertToFormat(QImage::Format_RGB888)).largest, 1)
            << "only the frame is dithered";
        show_on(swapped());
        const QImage seen = frame(view);
        EXPECT_LT(mean_fault(plain, seen), 0.75) << "as of the canvas";
        EXPECT_GT(difference(plain, seen).mean, 3.0);
        EXPECT_EQ(view.picture(), kept) << "what is kept is not for this screen";
        in_settings([](QWidget& dialog) { choose(dialog, "none"); });
        EXPECT_EQ(difference(frame(view), plain).largest, 0);
    }
};

TEST_F(LiquidColours, TheTankIsShownInThoseOfTheScreen) {
    open_small_tank();
    give(Command::LiquidPause);
    parts().tank.session().wait_until_applied();
    expect_colours_of_the_screen(parts().tank.page().view());
}

TEST_F(LiquidColours, TheGlassIsShownInThoseOfTheScreen) {
    open_small_glass();
    give(Command::LiquidPause);
    parts().tea.session().wait_until_applied();
    expect_colours_of_the_screen(parts().tea.page().view());
}

TEST_F(LiquidColours, PicturesOfThemAre) {
    open_small_tank();
    glass::LiquidPictureDialog& dialog = parts().tank.picture();
    for (const char* side : {"picture_width", "picture_height"})
        dialog.findChild<QSpinBox*>(QString::fromLatin1(side))->setValue(16);
    dialog.findChild<QSpinBox*>(QStringLiteral("picture_samples"))->setValue(1);
    dialog.findChild<QPushButton*>(QStringLiteral("picture_start"))->click();
    wait_for([&] { return !dialog.rendering() && dialog.has_picture(); });
    const auto seen = [&] {
        for (const QLabel* label : dialog.findChildren<QLabel*>())
            if (!label->pixmap().isNull())
                return label->pixmap().toImage().convertToFormat(QImage::Format_RGB888);
        return QImage();
    };
    const QImage plain = seen();
    dialog.hide();
    show_on(swapped());
    ASSERT_FALSE(plain.isNull());
    EXPECT_EQ(seen(), appearance::shown(plain).convertToFormat(QImage::Format_RGB888));
    EXPECT_NE(seen(), plain);
}

TEST_F(ColoursWindow, TheChoiceIsKept) {
    const std::string path = swapped();
    show_on(path);
    const tools::Preferences kept = tools::read_preferences(main::preferences_file());
    EXPECT_EQ(kept.monitor, "file");
    EXPECT_EQ(kept.monitor_file, path);
    in_settings([&](SettingsDialog& dialog) {
        EXPECT_EQ(dialog.findChild<QComboBox*>(QStringLiteral("monitor"))->currentData().toString(),
                  "file");
        EXPECT_EQ(dialog.findChild<QLineEdit*>(QStringLiteral("monitor_file"))->text().toStdString(),
                  path);
    });
}

TEST_F(ColoursWindow, OfAFileThatIsNoneABarTellsAndTheScreenIsSrgb) {
    const QImage plain = picture();
    show_on(file("none.icc", "this is no profile"));
    ASSERT_EQ(messages().size(), 1U);
    EXPECT_EQ(messages().front().matter, panels::Matter::Colours);
    EXPECT_THAT(messages().front().sentence.toStdString(), HasSubstr("none.icc: is no ICC profile ("));
    EXPECT_THAT(messages().front().sentence.toStdString(), EndsWith("."));
    EXPECT_EQ(difference(picture(), plain).largest, 0);
    in_settings([](QWidget& dialog) { choose(dialog, "none"); });
    EXPECT_TRUE(messages().empty());
}

TEST_F(ColoursWindow, AProofAsksForThePrinterFirst) {
    in_settings([](SettingsDialog&) {}, Command::SoftProof);
    EXPECT_FALSE(action(Command::SoftProof)->isChecked()) << "none was chosen";
    const QImage plain = picture();
    in_settings([this](SettingsDialog& dialog) { type(dialog, "printer_file", printer()); },
                Command::SoftProof);
    EXPECT_TRUE(action(Command::SoftProof)->isChecked());
    paint();
    const QImage proof = picture();
    give(Command::SoftProof);
    EXPECT_FALSE(action(Command::SoftProof)->isChecked());
    EXPECT_GT(difference(picture(), proof).mean, 0.1);
    give(Command::GamutWarning);
    EXPECT_TRUE(action(Command::GamutWarning)->isChecked());
    print_on("");
    EXPECT_FALSE(action(Command::GamutWarning)->isChecked()) << "the printer is gone";
}

TEST_F(ColoursWindow, ValuesAreOfThePaintingAlone) {
    paint();
    const QImage coloured = picture();
    give(Command::ValueCheck);
    const QImage greys = picture();
    const QColor red(200, 60, 30);
    EXPECT_EQ(appearance::shown(red), red) << "tubes keep their colours";
    const QColor grey = appearance::shown_in_painting(red);
    EXPECT_EQ(grey.red(), grey.green());
    EXPECT_EQ(grey.green(), grey.blue());
    const QPoint middle = coloured.rect().center();
    EXPECT_GT(coloured.pixelColor(middle).hsvSaturation(), 100);
    EXPECT_LT(greys.pixelColor(middle).hsvSaturation(), 4) << "a dither of one level";
    give(Command::ValueCheck);
    EXPECT_EQ(difference(picture(), coloured).largest, 0);
}

/// The largest step from a pixel to the next one in the middle row.
int largest_step(const QImage& picture) {
    const int y = picture.height() / 2;
    int largest = 0;
    for (int x = 1; x < picture.width(); ++x)
        largest =
            std::max(largest, std::abs(qGreen(picture.pixel(x, y)) - qGreen(picture.pixel(x - 1, y))));
    return largest;
}

TEST_F(ColoursWindow, SquintingLeavesLargeShapesAlone) {
    paint();
    const QImage sharp = picture();
    give(Command::SquintView);
    const QImage squinted = picture();
    EXPECT_GT(largest_step(sharp), 20);
    EXPECT_LT(largest_step(squinted), largest_step(sharp) / 3);
    EXPECT_EQ(squinted.size(), sharp.size());
    give(Command::ValueCheck);
    EXPECT_LT(picture().pixelColor(sharp.rect().center()).hsvSaturation(), 4) << "in greys, too";
    give(Command::ValueCheck);
    EXPECT_EQ(difference(picture(), squinted).largest, 0);
    give(Command::SquintView);
    EXPECT_EQ(difference(picture(), sharp).largest, 0);
}

TEST_F(ColoursWindow, ColoursAndPicturesAreShownAlike) {
    show_on(swapped());
    const QColor paint(200, 60, 30);
    QImage picture(3, 2, QImage::Format_RGB888);
    picture.fill(paint);
    EXPECT_EQ(appearance::shown(paint).red(), qRound(swapped_level(60)));
    EXPECT_EQ(appearance::shown(picture).pixelColor(1, 1), appearance::shown(paint));
    EXPECT_EQ(appearance::shown(QPixmap::fromImage(picture)).toImage().pixelColor(1, 1),
              appearance::shown(paint));
    EXPECT_FALSE(appearance::shown(QColor()).isValid());
}

/// Sets the root window's profile; none where it is empty.
void set_x11_profile(const std::string& bytes) {
    auto* x11 = qGuiApp->nativeInterface<QNativeInterface::QX11Application>();
    ASSERT_NE(x11, nullptr);
    xcb_connection_t* display = x11->connection();
    const auto asked = xcb_intern_atom(display, 0, 12, "_ICC_PROFILE");
    xcb_intern_atom_reply_t* atom = xcb_intern_atom_reply(display, asked, nullptr);
    const xcb_window_t root = xcb_setup_roots_iterator(xcb_get_setup(display)).data->root;
    xcb_change_property(display, XCB_PROP_MODE_REPLACE, root, atom->atom, XCB_ATOM_CARDINAL, 8,
                        static_cast<uint32_t>(bytes.size()), bytes.data());
    std::free(atom);
    xcb_flush(display);
}

TEST_F(ColoursWindow, TheProfileOfTheDisplayIsTheSystems) {
    const QImage plain = picture();
    set_x11_profile(made_monitor(swapped_primaries(), kGamma, "of the display"));
    open_another();
    wait_for([] { return appearance::screen_colours().cube() != nullptr; });
    EXPECT_GT(difference(picture(), plain).mean, 3.0);
    in_settings([](SettingsDialog& dialog) {
        EXPECT_EQ(dialog.findChild<QComboBox*>(QStringLiteral("monitor"))->currentText().toStdString(),
                  "Of the system (of the display)");
    });
    set_x11_profile("");
}

/// A bus of its own, with a colord on it that has one screen.
class FakeColord : public QDBusVirtualObject {
  public:
    QString introspect(const QString&) const override { return {}; }
    bool handleMessage(const QDBusMessage& message, const QDBusConnection& bus) override {
        const auto arguments = message.arguments();
        QDBusMessage reply = message.createReply();
        if (message.member() == QLatin1String("FindDeviceByProperty")) {
            if (arguments != QVariantList{QStringLiteral("XRANDR_name"), QStringLiteral("DP-1")})
                return bus.send(
                    message.createErrorReply(QStringLiteral("org.freedesktop.ColorManager.NotFound"),
                                             QStringLiteral("no device")));
            reply << QVariant::fromValue(QDBusObjectPath("/devices/a"));
        } else if (arguments.value(1).toString() == QLatin1String("Profiles")) {
            reply << QVariant::fromValue(QDBusVariant(QVariant::fromValue(paths)));
        } else if (message.path() == QLatin1String("/profiles/b")) {
            reply << QVariant::fromValue(QDBusVariant(QStringLiteral("/somewhere/b.icc")));
        }
        return bus.send(reply);
    }
    QList<QDBusObjectPath> paths{QDBusObjectPath("/profiles/b"), QDBusObjectPath("/profiles/c")};
};

class ColordProfileTest : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        daemon_.start(QStringLiteral("dbus-daemon"),
                      {QStringLiteral("--session"), QStringLiteral("--nofork"),
                       QStringLiteral("--nosyslog"), QStringLiteral("--print-address")});
        if (!daemon_.waitForStarted()) GTEST_SKIP() << "there is no dbus-daemon here";
        while (!daemon_.canReadLine())
            ASSERT_TRUE(daemon_.waitForReadyRead());
        const QString address = QString::fromLatin1(daemon_.readLine()).trimmed();
        service_ = QDBusConnection::connectToBus(address, QStringLiteral("service"));
        client_ = QDBusConnection::connectToBus(address, QStringLiteral("client"));
        ASSERT_TRUE(service_.registerService(QStringLiteral("org.freedesktop.ColorManager")));
        ASSERT_TRUE(
            service_.registerVirtualObject(QStringLiteral("/"), &colord_, QDBusConnection::SubPath));
    }
    void TearDown() override {
        QDBusConnection::disconnectFromBus(QStringLiteral("service"));
        QDBusConnection::disconnectFromBus(QStringLiteral("client"));
        daemon_.terminate();
        daemon_.waitForFinished();
        WindowTest::TearDown();
    }
    std::vector<QString> answers(main::ColordProfile& profile, const std::function<void()>& ask) {
        std::vector<QString> told;
        const auto told_by = QObject::connect(&profile, &main::ColordProfile::found,
                                              [&](const QString& file) { told.push_back(file); });
        ask();
        wait_for([&] { return !told.empty(); });
        QObject::disconnect(told_by);
        return told;
    }

    QProcess daemon_;
    FakeColord colord_;
    QDBusConnection service_{QString()}, client_{QString()};
};

TEST_F(ColordProfileTest, IsTheFirstOfTheScreensProfiles) {
    main::ColordProfile profile(client_);
    EXPECT_EQ(answers(profile, [&] { profile.ask(QStringLiteral("DP-1")); }),
              std::vector<QString>{QStringLiteral("/somewhere/b.icc")});
    EXPECT_EQ(answers(profile, [&] { profile.ask(QStringLiteral("DP-2")); }),
              std::vector<QString>{QString()});
}

TEST_F(ColordProfileTest, IsAskedAgainWhenTheSystemsAreOthers) {
    main::ColordProfile profile(client_);
    answers(profile, [&] { profile.ask(QStringLiteral("DP-1")); });
    colord_.paths.clear();
    const auto told = answers(profile, [&] {
        service_.send(QDBusMessage::createSignal(QStringLiteral("/org/freedesktop/ColorManager"),
                                                 QStringLiteral("org.freedesktop.ColorManager"),
                                                 QStringLiteral("DeviceChanged"))
                      << QVariant::fromValue(QDBusObjectPath("/devices/a")));
    });
    EXPECT_EQ(told, std::vector<QString>{QString()});
}

TEST_F(ColordProfileTest, WithoutAServiceThereIsNone) {
    service_.unregisterService(QStringLiteral("org.freedesktop.ColorManager"));
    main::ColordProfile profile(client_), without(QDBusConnection(QStringLiteral("nowhere")));
    for (main::ColordProfile* asked : {&profile, &without})
        EXPECT_EQ(answers(*asked, [&] { asked->ask(QStringLiteral("DP-1")); }),
                  std::vector<QString>{QString()});
}

}  // namespace
}  // namespace pastoso::tests
