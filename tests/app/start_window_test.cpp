// The start page over the canvas of the real window.
#include "app/window_fixture.hpp"
#include "commands/recent_paintings.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "dialogs/length_dialog.hpp"
#include "dialogs/new_canvas_dialog.hpp"
#include "dialogs/recovery_dialog.hpp"
#include "dialogs/transform_dialog.hpp"
#include "journal/recovery.hpp"
#include "main/window_parts.hpp"
#include "panels/parts/gallery.hpp"
#include "start/examples_section.hpp"
#include "start/new_canvas_section.hpp"
#include "start/recent_section.hpp"
#include "start/start_page.hpp"

#include <fstream>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QToolTip>
#include <QUrl>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class StartWindow : public WindowTest {
  protected:
    void SetUp() override {
        ::setenv("XDG_DATA_HOME", data_.path().c_str(), 1);
        WindowTest::SetUp();
        if (!HasFatalFailure()) pause();
    }
    void TearDown() override {
        WindowTest::TearDown();
        ::unsetenv("XDG_DATA_HOME");
    }

    /// Paint that stands still can be compared.
    void pause() { action(Command::Pause)->trigger(); }
    void start_again_paused() {
        start_again();
        pause();
    }
    template <class Widget>
    Widget& find(const char* name) {
        auto* found = window().findChild<Widget*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    start::StartPage& page() { return find<start::StartPage>("start_page"); }
    bool page_is_shown() {
        auto* found = window().findChild<start::StartPage*>();
        return found != nullptr && found->isVisible();
    }
    panels::Gallery& gallery(const char* name) { return find<panels::Gallery>(name); }
    void show_page() {
        parts().start.show_page();
        QApplication::processEvents();
    }
    void press_key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }
    void click(panels::Gallery& tiles, int number) {
        QTest::mouseClick(tiles.viewport(), Qt::LeftButton, {}, tiles.middle(number));
        loaded();
    }
    int number_of(panels::Gallery& tiles, const char* name) {
        for (int i = 0; i < tiles.count(); ++i)
            if (tiles.model()->index(i, 0).data().toString() == QString::fromUtf8(name)) return i;
        return -1;
    }
    void click(const char* button) {
        find<QPushButton>(button).click();
        loaded();
    }
    void choose(const char* toggle) { find<QToolButton>(toggle).click(); }

    /// Does this to the dialog that is going to ask.
    template <class Dialog, class Answer>
    void when_asked(Answer answer) {
        asked_ = 0;
        auto* looking = new QTimer(&window());
        QObject::connect(looking, &QTimer::timeout, looking, [this, looking, answer] {
            auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr) return;
            looking->deleteLater();
            looking->stop();
            ++asked_;
            answer(*dialog);
        });
        looking->start(5);
    }
    std::string size_on_easel() {
        const document::CanvasSettings canvas = session().canvas();
        return QStringLiteral("%1 x %2, %3")
            .arg(canvas.width_mm)
            .arg(canvas.height_mm)
            .arg(QString::fromStdString(canvas.support))
            .toStdString();
    }
    std::filesystem::path saved(const char* name) {
        const std::filesystem::path path = folder_.path() / name;
        parts().files.save_painting(QString::fromStdString(path.string()));
        EXPECT_EQ(parts().files.saver().wait().toStdString(), "");
        QApplication::processEvents();
        return path;
    }
    void paint() { mouse_stroke(line_mm({12.0, 12.0}, {48.0, 30.0})); }
    std::uint64_t state() { return document::state_hash(session().capture().painting); }
    void drop(const std::filesystem::path& file) { drop_all({file}); }
    void drop_all(const std::vector<std::filesystem::path>& files) {
        QMimeData data;
        QList<QUrl> addresses;
        for (const std::filesystem::path& file : files)
            addresses.push_back(QUrl::fromLocalFile(QString::fromStdString(file.string())));
        data.setUrls(addresses);
        drop_data(data);
    }
    void drop_data(const QMimeData& data) {
        QDragEnterEvent enter({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&window(), &enter);
        EXPECT_TRUE(enter.isAccepted());
        QDropEvent event({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&window(), &event);
        QApplication::processEvents();
        loaded();
    }

    std::filesystem::path picture_file(const char* name, const QColor& colour) {
        QImage plain(30, 20, QImage::Format_RGB888);
        plain.fill(colour);
        const std::filesystem::path file = folder_.path() / name;
        EXPECT_TRUE(plain.save(QString::fromStdString(file.string())));
        return file;
    }
    QMenu* question() { return window().findChild<QMenu*>("dropped_picture"); }
    void answer(int number) {
        ASSERT_NE(question(), nullptr);
        QAction* chosen = question()->actions().at(number);
        question()->close();
        chosen->trigger();
        loaded();
        session().wait_until_applied();
    }
    /// Other windows that are asked for leave their arguments in a file, in place of opening.
    std::filesystem::path told_to_others() {
        const std::filesystem::path told = folder_.path() / "others";
        const std::filesystem::path program = folder_.path() / "program";
        core::write_text_file(program, "#!/bin/sh\necho \"$@\" > '" + told.string() + ".new'\nmv '" +
                                           told.string() + ".new' '" + told.string() + "'\n");
        std::filesystem::permissions(program, std::filesystem::perms::owner_all);
        parts().new_window.start_with(QString::fromStdString(program.string()));
        return told;
    }

    TemporaryFolder data_, folder_;
    int asked_ = 0;
};

TEST_F(StartWindow, ThePageMeetsThePainterAndTheFirstStrokeFollowsAtOnce) {
    EXPECT_FALSE(page_is_shown());
    parts().start.welcome();
    ASSERT_TRUE(page_is_shown());
    EXPECT_EQ(QApplication::focusWidget(), &find<QPushButton>("start_painting"));
    QTest::mouseClick(&find<QPushButton>("start_painting"), Qt::LeftButton);
    EXPECT_FALSE(page_is_shown());
    paint();
    EXPECT_GT(volume_mm3(), 1.0);
}

TEST_F(StartWindow, AStrokeBesideThePagePaintsAndSendsItAway) {
    show_page();
    const QRect around = page().geometry();
    EXPECT_TRUE(canvas().geometry().contains(around));
    const QPoint beside(5, canvas().height() / 2);
    EXPECT_EQ(QApplication::widgetAt(canvas().mapToGlobal(beside)), &canvas());
    mouse_stroke(line_mm(canvas().canvas_mm(beside), {30.0, 20.0}));
    EXPECT_FALSE(page_is_shown());
    EXPECT_GT(volume_mm3(), 1.0);
}

TEST_F(StartWindow, AClickOnThePageIsNoStroke) {
    show_page();
    QTest::mouseClick(&page(), Qt::LeftButton, {}, {4, 4});
    EXPECT_TRUE(page_is_shown());
    EXPECT_EQ(volume_mm3(), 0.0);
}

TEST_F(StartWindow, KeysAreEnough) {
    show_page();
    press_key(Qt::Key_D);  // "dry now" anywhere else
    session().wait_until_applied();
    EXPECT_EQ(session().status().changes, 0);
    press_key(Qt::Key_Escape);
    EXPECT_FALSE(page_is_shown());
    EXPECT_EQ(QApplication::focusWidget(), &canvas());

    action(Command::StartPage)->trigger();
    ASSERT_TRUE(page_is_shown());
    for (int i = 0; i < 12 && !gallery("canvas_sizes").hasFocus(); ++i)
        press_key(Qt::Key_Tab);
    ASSERT_TRUE(gallery("canvas_sizes").hasFocus());
    press_key(Qt::Key_Right);
    press_key(Qt::Key_Right);
    press_key(Qt::Key_Return);
    loaded();
    EXPECT_FALSE(page_is_shown());
    EXPECT_EQ(size_on_easel(), "297 x 210, medium linen");
}

TEST_F(StartWindow, TheTabKeyStaysOnThePageBothWays) {
    show_page();
    const QWidget* first = QApplication::focusWidget();
    for (const Qt::Key key : {Qt::Key_Tab, Qt::Key_Backtab}) {
        int steps = 0;
        do {
            press_key(key);
            ASSERT_TRUE(page().isAncestorOf(QApplication::focusWidget()));
            ASSERT_LT(++steps, 100);
        } while (QApplication::focusWidget() != first);
        EXPECT_GT(steps, 5);
    }
}

TEST_F(StartWindow, OneClickPutsUpACanvasOfThatSizeAndSupport) {
    show_page();
    panels::Gallery& sizes = gallery("canvas_sizes");
    choose("support_cotton duck");
    choose("portrait");
    click(sizes, number_of(sizes, "A5"));
    EXPECT_FALSE(page_is_shown());
    EXPECT_EQ(size_on_easel(), "148 x 210, cotton duck");
    show_page();
    EXPECT_TRUE(find<QToolButton>("portrait").isChecked());
    choose("landscape");
    choose("support_panel");
    click(sizes, number_of(sizes, "Screen, HD"));
    EXPECT_EQ(size_on_easel(), "480 x 270, panel");
    const auto snapshot = session().snapshot();
    EXPECT_EQ(snapshot->film.shape.width, 1920);
    EXPECT_EQ(snapshot->film.shape.height, 1080);
}

TEST_F(StartWindow, MoreOpensTheDialogAndThePageStaysUntilThereIsACanvas) {
    show_page();
    panels::Gallery& sizes = gallery("canvas_sizes");
    when_asked<dialogs::NewCanvasDialog>([](QDialog& dialog) { dialog.reject(); });
    click(sizes, sizes.count() - 1);
    EXPECT_EQ(asked_, 1);
    EXPECT_TRUE(page_is_shown());
    when_asked<dialogs::NewCanvasDialog>([](QDialog& dialog) { dialog.accept(); });
    click(sizes, sizes.count() - 1);
    EXPECT_FALSE(page_is_shown());
}

TEST_F(StartWindow, ANewCanvasCanHaveATonedGroundAtOnce) {
    when_asked<dialogs::NewCanvasDialog>([](QDialog& dialog) { dialog.accept(); });
    action(Command::NewCanvas)->trigger();
    loaded();
    session().wait_until_applied();
    EXPECT_EQ(session().snapshot()->layers->layers.size(), 1U) << "none unless it is wanted";

    when_asked<dialogs::NewCanvasDialog>([](QDialog& dialog) {
        auto* ground = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("ground_mm"));
        EXPECT_FALSE(ground->isEnabled());
        EXPECT_EQ(ground->value(), 0.1);
        dialog.findChild<QCheckBox*>(QStringLiteral("toned_ground"))->click();
        EXPECT_TRUE(ground->isEnabled());
        ground->setValue(0.05);
        dialog.accept();
    });
    action(Command::NewCanvas)->trigger();
    EXPECT_EQ(asked_, 1);
    loaded();
    session().wait_until_applied();
    const auto layers = session().snapshot()->layers;
    ASSERT_EQ(layers->layers.size(), 2U);
    EXPECT_EQ(layers->layers[0].look.name, "Ground");
    EXPECT_EQ(layers->active, 1U) << "it is painted above it";
    const auto tone = std::get<document::ToneGround>(session().recording().events.back().action);
    EXPECT_EQ(tone.thickness_mm, 0.05);
    EXPECT_EQ(tone.paint, studio().easel().hand().paint);
    settle();
    action(Command::Undo)->trigger();
    session().wait_until_applied();
    EXPECT_EQ(session().snapshot()->layers->layers.size(), 1U) << "one step";
}

TEST_F(StartWindow, ANewCanvasIsTypedInAnyUnit) {
    dialogs::NewCanvasDialog dialog(canvas_settings(), 6.0);
    dialog.show();
    wait_until_shown(dialog);
    QApplication::setActiveWindow(&dialog);
    const auto box = [&](const char* name) {
        return dialog.findChild<QDoubleSpinBox*>(QString::fromLatin1(name));
    };
    ASSERT_EQ(dialog.focusWidget(), box("width_mm"));
    QTest::keyClicks(box("width_mm"), QStringLiteral("50 cm"));
    EXPECT_DOUBLE_EQ(dialog.settings().width_mm, 500.0) << "what stood there was selected";
    const auto type = [](QDoubleSpinBox* into, const char* words) {
        into->setFocus();
        into->selectAll();
        QTest::keyClicks(into, QString::fromLatin1(words));
        QTest::keyClick(into, Qt::Key_Tab);
    };
    type(box("height_mm"), "8 in");
    EXPECT_DOUBLE_EQ(dialog.settings().height_mm, 203.2);
    type(box("height_mm"), "5\"");
    EXPECT_DOUBLE_EQ(dialog.settings().height_mm, 127.0);
    type(box("height_mm"), "0.2m");
    EXPECT_DOUBLE_EQ(dialog.settings().height_mm, 200.0);
    type(box("height_mm"), "nothing");
    EXPECT_DOUBLE_EQ(dialog.settings().height_mm, 200.0) << "no letters without a number";
    type(box("px_per_mm"), "127 dpi");
    EXPECT_DOUBLE_EQ(dialog.settings().px_per_mm, 5.0);
    const QString summary = dialog.findChild<QLabel*>(QStringLiteral("summary"))->text();
    EXPECT_THAT(summary.toStdString(), HasSubstr("2500 × 1000 pixels, 127 dpi"));
    type(box("width_mm"), "3000 px");
    EXPECT_DOUBLE_EQ(dialog.settings().width_mm, 600.0) << "at 5 px/mm";
}

TEST_F(StartWindow, ALengthThatIsNotUnderstoodIsSaidAndChangesNothing) {
    dialogs::NewCanvasDialog dialog(canvas_settings(), 6.0);
    dialog.show();
    wait_until_shown(dialog);
    QApplication::setActiveWindow(&dialog);
    auto* width = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("width_mm"));
    width->setValue(250.0);
    width->setFocus();
    width->selectAll();
    QTest::keyClicks(width, QStringLiteral("300 yd"));
    QTest::keyClick(width, Qt::Key_Return);
    EXPECT_EQ(dialog.settings().width_mm, 250.0) << "not 300 mm, which it began with";
    QApplication::processEvents();
    EXPECT_THAT(QToolTip::text().toStdString(), HasSubstr("\"300 yd\" is not understood here"));
    EXPECT_TRUE(dialog.isVisible()) << "there is no canvas of another size than was typed";
    width->selectAll();
    QTest::keyClicks(width, QStringLiteral("99999999"));
    QTest::keyClick(width, Qt::Key_Return);
    EXPECT_EQ(dialog.settings().width_mm, document::kMaxCanvasSide_mm) << "as much as there can be";

    dialogs::ThicknessDialog thickness({.title = {},
                                        .explanation = {},
                                        .name = {},
                                        .button = {},
                                        .least_mm = 0.01,
                                        .most_mm = 2.0,
                                        .proposal_mm = 0.2});
    thickness.show();
    wait_until_shown(thickness);
    auto* length = thickness.findChild<QDoubleSpinBox*>(QStringLiteral("length_mm"));
    length->selectAll();
    QTest::keyClicks(length, QStringLiteral("1 px"));
    QTest::keyClick(length, Qt::Key_Return);
    EXPECT_EQ(thickness.chosen_mm(), 0.2) << "no resolution is at hand";
}

TEST_F(StartWindow, ALengthGrowsByItsArrow) {
    dialogs::NewCanvasDialog dialog(canvas_settings(), 6.0);
    dialog.show();
    wait_until_shown(dialog);
    for (const char* name : {"width_mm", "height_mm", "px_per_mm"}) {
        auto* box = dialog.findChild<QDoubleSpinBox*>(QString::fromLatin1(name));
        const double before = box->value();
        QTest::mouseClick(box, Qt::LeftButton, {}, {box->width() - 8, box->height() / 4});
        EXPECT_GT(box->value(), before) << name;
    }
}

TEST_F(StartWindow, ADialogGrowsWithItsWords) {
    dialogs::NewCanvasDialog dialog(canvas_settings(), 6.0);
    dialog.show();
    wait_until_shown(dialog);
    const auto* summary = dialog.findChild<QLabel*>(QStringLiteral("summary"));
    dialog.findChild<QDoubleSpinBox*>(QStringLiteral("px_per_mm"))->setValue(30.0);
    QApplication::processEvents();
    EXPECT_GE(summary->height(), summary->heightForWidth(summary->width()));

    dialogs::TransformDialog transform({.size_mm = {20.0, 10.0}}, {60.0, 40.0});
    transform.show();
    wait_until_shown(transform);
    transform.show_frame({.size_mm = {20.0, 10.0}, .move_mm = {500.0, 0.0}, .scale = {1.2, 1.1}});
    QApplication::processEvents();
    const auto* outcome = transform.findChild<QLabel*>(QStringLiteral("outcome"));
    EXPECT_GE(outcome->height(), outcome->heightForWidth(outcome->width()));
}

TEST_F(StartWindow, ANewCanvasSaysWhatItsResolutionShowsAndWhetherTheMachineKeepsPace) {
    dialogs::NewCanvasDialog dialog(canvas_settings(), 6.0);
    const auto says = [&](double px_per_mm, const char* words) {
        for (auto* box : dialog.findChildren<QDoubleSpinBox*>())
            if (box->suffix().contains(QStringLiteral("px/mm"))) box->setValue(px_per_mm);
        for (const auto* label : dialog.findChildren<QLabel*>())
            if (label->text().contains(QString::fromLatin1(words))) return true;
        return false;
    };
    EXPECT_TRUE(says(2.0, "brush marks blur. This machine keeps pace with the hand."));
    EXPECT_TRUE(says(6.0, "the weave show. This machine keeps pace with the hand."));
    EXPECT_TRUE(
        says(16.0, "in fine brushes as well. This machine keeps pace with the hand up to 6 px/mm;"));
}

TEST_F(StartWindow, WhatIsNotSavedIsNotLostToANewCanvas) {
    paint();
    settle();
    const std::uint64_t painted = state();
    show_page();
    EXPECT_EQ(find<QPushButton>("start_painting").text().toStdString(), "Back to the painting");
    when_asked<QMessageBox>([](QMessageBox& box) { box.button(QMessageBox::Cancel)->click(); });
    click(gallery("canvas_sizes"), 0);
    EXPECT_EQ(asked_, 1);
    EXPECT_TRUE(page_is_shown());
    EXPECT_EQ(state(), painted);
}

TEST_F(StartWindow, RecentPaintingsShowTheirPicturesAndOpen) {
    paint();
    settle();
    saved("harbour.pastoso");
    const std::uint64_t painted = state();
    start_again_paused();
    show_page();
    panels::Gallery& recent = gallery("recent_paintings");
    ASSERT_EQ(recent.count(), 1);
    wait_for([&] { return page().recent()->all_read(); });
    const QModelIndex tile = recent.model()->index(0, 0);
    EXPECT_EQ(tile.data().toString().toStdString(), "harbour");
    const QImage picture = tile.data(Qt::DecorationRole).value<QPixmap>().toImage();
    ASSERT_FALSE(picture.isNull());
    EXPECT_NEAR(1.0 * picture.width() / picture.height(), 1.5, 0.05);
    const QColor middle = picture.pixelColor(picture.width() / 2, picture.height() / 2);
    EXPECT_GT(middle.blue(), middle.red() + 20) << "the stroke is seen";
    click(recent, 0);
    EXPECT_FALSE(page_is_shown());
    EXPECT_EQ(state(), painted);
}

TEST_F(StartWindow, AFileThatIsGoneOrDamagedIsToldAndCanBeTakenFromTheList) {
    const auto gone = saved("gone.pastoso"), damaged = saved("damaged.pastoso");
    std::filesystem::remove(gone);
    core::write_text_file(damaged, "nothing");
    show_page();
    panels::Gallery& recent = gallery("recent_paintings");
    wait_for([&] { return page().recent()->all_read(); });
    ASSERT_THAT(page().recent()->paintings(), SizeIs(2));
    EXPECT_EQ(page().recent()->paintings()[0].fault.toStdString(), "This file cannot be read.");
    EXPECT_THAT(page().recent()->paintings()[0].reason.toStdString(), HasSubstr("damaged.pastoso"));
    EXPECT_EQ(page().recent()->paintings()[1].fault.toStdString(), "This file is not there any more.");

    click(recent, 1);
    ASSERT_THAT(studio().messages().standing(), SizeIs(1));
    EXPECT_THAT(studio().messages().standing()[0].sentence.toStdString(), HasSubstr("gone.pastoso"));
    EXPECT_TRUE(page_is_shown());
    EXPECT_EQ(size_on_easel(), "60 x 40, linen");

    QApplication::setActiveWindow(&window());  // which a window manager would see to
    recent.setFocus();
    recent.setCurrentIndex(recent.model()->index(1, 0));
    press_key(Qt::Key_Delete);
    EXPECT_THAT(commands::known_paintings(), ElementsAre(damaged));
    EXPECT_EQ(recent.count(), 1);
    press_key(Qt::Key_Home);
    press_key(Qt::Key_Delete);
    EXPECT_THAT(commands::known_paintings(), IsEmpty());
    EXPECT_TRUE(std::filesystem::exists(damaged)) << "only the list forgets it";
}

TEST_F(StartWindow, AnExampleIsPaintedOnItsCanvasAndNeedsNoSaving) {
    show_page();
    panels::Gallery& examples = gallery("examples");
    ASSERT_EQ(examples.count(), 4);
    for (int i = 0; i < 4; ++i)
        EXPECT_FALSE(examples.model()->index(i, 0).data(Qt::DecorationRole).value<QPixmap>().isNull());
    click(examples, number_of(examples, "Poppies"));
    EXPECT_FALSE(page_is_shown());
    EXPECT_EQ(size_on_easel(), "100 x 132, linen");
    wait_for([this] { return session().status().strokes > 5; });
    EXPECT_TRUE(session().status().replaying);
    wait_for([this] { return !session().status().replaying && !studio().easel().brush_is_lent(); });
    EXPECT_THAT(session().take_errors(), IsEmpty());
    EXPECT_GT(session().status().strokes, 300);
    EXPECT_GT(volume_mm3(), 500.0);
    EXPECT_FALSE(window().isWindowModified());
    const std::int64_t strokes = session().status().strokes;
    paint();
    session().wait_until_applied();
    EXPECT_EQ(session().status().strokes, strokes + 1) << "the brush is the painter's";
    wait_for([this] { return window().isWindowModified(); });
}

TEST_F(StartWindow, UnfinishedPaintingsStandAtTheTopAndComeBack) {
    paint();
    settle();
    const double painted_mm3 = volume_mm3();
    open_another();
    parts().start.welcome();
    ASSERT_TRUE(page_is_shown()) << "and no dialog asks for the same";
    ASSERT_TRUE(find<QPushButton>("recover").isVisible());
    press_key(Qt::Key_Escape);
    EXPECT_THAT(journal::unfinished_paintings(journal::journals_path()), SizeIs(1))
        << "nothing is lost to a painter who looks away";
    show_page();
    click("recover");
    EXPECT_FALSE(page_is_shown());
    EXPECT_NEAR(volume_mm3(), painted_mm3, 1e-6 * painted_mm3);
    EXPECT_TRUE(window().isWindowModified());
    EXPECT_THAT(journal::unfinished_paintings(journal::journals_path()), IsEmpty());
    show_page();
    EXPECT_EQ(window().findChild<QPushButton*>("recover"), nullptr);
}

TEST_F(StartWindow, UnfinishedPaintingsCanBeDiscardedFromThePage) {
    paint();
    settle();
    open_another();
    show_page();
    when_asked<dialogs::RecoveryDialog>([](dialogs::RecoveryDialog& dialog) {
        // As soon as the question's own loop handles events: the question stands by then.
        QTimer::singleShot(0, [] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box != nullptr) box->button(QMessageBox::Discard)->click();
        });
        dialog.discard_button()->click();
    });
    click("all_unfinished");
    EXPECT_EQ(asked_, 1);
    EXPECT_TRUE(page_is_shown());
    EXPECT_THAT(journal::unfinished_paintings(journal::journals_path()), IsEmpty());
    EXPECT_FALSE(find<QPushButton>("all_unfinished").isVisible());
}

TEST_F(StartWindow, ThatItIsNotWantedAtTheStartIsRemembered) {
    parts().start.welcome();
    auto& box = find<QCheckBox>("show_at_start");
    EXPECT_TRUE(box.isChecked());
    box.click();
    start_again();
    parts().start.welcome();
    EXPECT_FALSE(page_is_shown());
    action(Command::StartPage)->trigger();
    EXPECT_TRUE(page_is_shown());
    EXPECT_FALSE(find<QCheckBox>("show_at_start").isChecked());
    find<QCheckBox>("show_at_start").click();
    start_again();
    parts().start.welcome();
    EXPECT_TRUE(page_is_shown());
}

TEST_F(StartWindow, ThePageStaysWithinTheCanvasWhateverItsSize) {
    show_page();
    for (const QSize size : {QSize(1000, 560), QSize(1500, 900)}) {
        window().resize(size);
        wait_for([&] { return canvas().geometry().contains(page().geometry()); });
    }
    action(Command::CanvasOnly)->trigger();
    EXPECT_FALSE(page_is_shown());
    action(Command::CanvasOnly)->trigger();
    EXPECT_FALSE(page_is_shown());
}

TEST_F(StartWindow, APaintingDraggedOntoTheWindowOpens) {
    paint();
    settle();
    const auto file = saved("harbour.pastoso");
    const std::uint64_t painted = state();
    start_again_paused();
    drop(file);
    EXPECT_EQ(state(), painted);

    paint();
    settle();
    const std::uint64_t changed = state();
    when_asked<QMessageBox>([](QMessageBox& box) { box.button(QMessageBox::Cancel)->click(); });
    drop(file);
    EXPECT_EQ(asked_, 1);
    EXPECT_EQ(state(), changed);
}

TEST_F(StartWindow, OfADraggedPictureThePainterSaysWhatBecomesOfIt) {
    const std::filesystem::path file = picture_file("red.png", QColor(200, 30, 20));
    drop(file);
    answer(0);
    EXPECT_EQ(session().snapshot()->layers->layers.size(), 2U);
    drop(file);
    answer(1);
    EXPECT_NE(session().snapshot()->tracing, nullptr);
    drop(file);
    answer(2);
    EXPECT_NE(session().snapshot()->references, nullptr);
    EXPECT_EQ(size_on_easel(), "60 x 40, linen");

    const std::filesystem::path text = folder_.path() / "letter.txt";
    core::write_text_file(text, "Dear painter");
    drop(text);
    EXPECT_EQ(told(), "letter.txt is no painting and no picture that can be opened.");
}

TEST_F(StartWindow, APictureWithoutAFileIsTakenAsOneWith) {
    QImage plain(30, 20, QImage::Format_RGB32);
    plain.fill(QColor(200, 30, 20));
    const auto drop_picture = [&](int choice) {
        QMimeData data;
        data.setUrls({QUrl(QStringLiteral("https://example.org/red.png"))});
        data.setImageData(plain);
        drop_data(data);
        answer(choice);
    };
    drop_picture(0);
    ASSERT_EQ(session().snapshot()->layers->layers.size(), 2U);
    EXPECT_EQ(session().snapshot()->layers->layers[1].look.name, "Picture");
    drop_picture(1);
    ASSERT_NE(session().snapshot()->tracing, nullptr);
    EXPECT_EQ(session().snapshot()->tracing->picture->width, 30);
    drop_picture(2);
    EXPECT_NE(session().snapshot()->references, nullptr);
}

TEST_F(StartWindow, OfPicturesDraggedTogetherThePainterSaysItOnce) {
    const std::filesystem::path broken = folder_.path() / "broken.png";
    core::write_text_file(broken, "no picture");
    const std::vector<std::filesystem::path> files = {picture_file("red.png", QColor(200, 30, 20)),
                                                      broken,
                                                      picture_file("blue.png", QColor(20, 30, 200))};
    drop_all(files);
    answer(0);
    const auto layers = session().snapshot()->layers;
    ASSERT_EQ(layers->layers.size(), 3U);
    EXPECT_EQ(layers->layers[1].look.name, "red");
    EXPECT_EQ(layers->layers[2].look.name, "blue");
    EXPECT_THAT(told(), HasSubstr("broken.png"));
    settle();
    action(Command::Undo)->trigger();
    session().wait_until_applied();
    EXPECT_EQ(session().snapshot()->layers->layers.size(), 1U) << "one step for all";

    drop_all(files);
    answer(1);
    ASSERT_NE(session().snapshot()->references, nullptr);
    EXPECT_EQ(session().snapshot()->references->references.size(), 2U);
    drop_all(files);
    ASSERT_NE(question(), nullptr);
    EXPECT_EQ(question()->actions().size(), 4) << "only one is traced, or becomes a canvas";
    question()->close();
}

TEST_F(StartWindow, OfPaintingsDraggedTogetherEachHasAWindow) {
    paint();
    settle();
    const auto first = saved("harbour.pastoso"), second = saved("quay.pastoso");
    const std::uint64_t painted = state();
    start_again_paused();
    const std::filesystem::path told = told_to_others();
    drop_all({first, second});
    EXPECT_EQ(state(), painted);
    wait_for([&] { return std::filesystem::exists(told); });
    EXPECT_EQ(core::read_text_file(told), second.string() + "\n");
}

TEST_F(StartWindow, ManyWindowsAreOpenedOnlyOnceThePainterAgrees) {
    paint();
    settle();
    const std::uint64_t painted = state();
    std::vector<std::filesystem::path> files = {saved("harbour.pastoso")};
    std::set<std::string> others;
    for (int i = 0; i < 6; ++i) {
        files.push_back(folder_.path() / ("quay " + std::to_string(i) + ".pastoso"));
        others.insert(files.back().string());
    }
    const std::filesystem::path told = folder_.path() / "others", program = folder_.path() / "program";
    core::write_text_file(program, "#!/bin/sh\necho \"$@\" >> '" + told.string() + "'\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);

    start_again_paused();
    parts().new_window.start_with(QString::fromStdString(program.string()));
    when_asked<QMessageBox>([](QMessageBox& box) { box.button(QMessageBox::Cancel)->click(); });
    drop_all(files);
    EXPECT_EQ(asked_, 1) << "once for all";
    EXPECT_EQ(state(), painted) << "the first opens here all the same";
    when_asked<QMessageBox>([](QMessageBox& box) {
        for (QAbstractButton* button : box.buttons())
            if (box.buttonRole(button) == QMessageBox::AcceptRole) return button->click();
    });
    drop_all(files);
    EXPECT_EQ(asked_, 1);
    const auto lines = [&] {
        std::vector<std::string> read;
        std::ifstream file(told);
        for (std::string line; std::getline(file, line);)
            read.push_back(line);
        return read;
    };
    wait_for([&] { return lines().size() >= others.size(); });
    EXPECT_THAT(lines(), testing::UnorderedElementsAreArray(others)) << "none of those refused";
}

TEST_F(StartWindow, PicturesAreForTheCanvasThatTheyAreDroppedOn) {
    paint();
    settle();
    const auto painting = saved("harbour.pastoso");
    start_again_paused();
    const std::filesystem::path told = told_to_others();
    drop_all({painting, picture_file("red.png", QColor(200, 30, 20))});
    wait_for([&] { return std::filesystem::exists(told); });
    EXPECT_EQ(core::read_text_file(told), painting.string() + "\n");
    EXPECT_EQ(volume_mm3(), 0.0) << "the bare canvas stays";
    answer(0);
    EXPECT_EQ(session().snapshot()->layers->layers.size(), 2U);
}

}  // namespace
}  // namespace pastoso::tests
