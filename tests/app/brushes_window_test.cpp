// The painter's own brushes: curves changed in hand, kept, renamed, thrown away, read again; loads.
#include "app/window_fixture.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "core/user_data.hpp"
#include "document/actions/actions.hpp"
#include "main/window_parts.hpp"
#include "panels/layers/layer_tree.hpp"
#include "panels/paint/load_bar.hpp"
#include "panels/pen/brush_list.hpp"
#include "panels/pen/brush_panel.hpp"
#include "panels/pen/curve_editor.hpp"

#include <algorithm>
#include <cstdlib>
#include <functional>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using document::TakeBrush;
using testing::HasSubstr;

class BrushesWindow : public WindowTest {
  protected:
    void SetUp() override {
        ::setenv("XDG_DATA_HOME", home_.path().c_str(), 1);
        write_files();
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        give(Command::Pause);
    }
    void TearDown() override {
        WindowTest::TearDown();
        ::unsetenv("XDG_DATA_HOME");
    }
    virtual void write_files() {}

    std::filesystem::path file(const char* name) const {
        return home_.path() / "pastoso" / "brushes" / name;
    }
    void write(const char* name, const std::string& text) const {
        std::filesystem::create_directories(file(name).parent_path());
        core::write_text_file(file(name), text);
    }
    static std::string own_preset(const std::string& name, double film_mm = 0.4) {
        brush::Preset preset = brush::find_preset("filbert");
        preset.name = name;
        preset.paint.film_mm = film_mm;
        return brush::preset_to_json(preset);
    }

    void give(Command command) { studio().commands().action(command)->trigger(); }
    const tools::Hand& hand() { return studio().easel().hand(); }

    panels::BrushList& list() { return *window().findChild<panels::BrushList*>(); }
    QListWidgetItem* listed(const QString& name) {
        const auto found = list().findItems(name, Qt::MatchExactly);
        return found.isEmpty() ? nullptr : found.front();
    }
    void click(const QString& name) {
        QListWidgetItem* item = listed(name);
        ASSERT_NE(item, nullptr) << name.toStdString();
        list().scrollToItem(item);
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(item).center());
    }

    /// Calls `answer` once, as soon as a dialog of that kind has come up.
    template <class Dialog>
    void when_asked(const std::function<void(Dialog&)>& answer) {
        auto* poll = new QTimer(&window());
        QObject::connect(poll, &QTimer::timeout, &window(), [poll, answer] {
            auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr) return;
            poll->deleteLater();
            poll->stop();
            answer(*dialog);
        });
        poll->start(10);
    }
    void answer_name(const QString& name) {
        when_asked<QInputDialog>([name](QInputDialog& dialog) {
            dialog.findChild<QLineEdit*>()->setText(name);
            dialog.accept();
        });
    }
    void answer_question(bool consent) {
        when_asked<QMessageBox>([consent](QMessageBox& box) {
            for (QAbstractButton* button : box.buttons()) {
                const bool cancels = box.buttonRole(button) == QMessageBox::RejectRole;
                if (cancels != consent) return button->click();
            }
        });
    }

    void stroke() { mouse_stroke(line_mm({15.0, 20.0}, {45.0, 20.0})); }

    TakeBrush last_taken() {
        session().wait_until_applied();
        TakeBrush taken;
        for (const document::Event& event : session().recording().events) {
            if (const auto* take = std::get_if<TakeBrush>(&event.action)) taken = *take;
        }
        return taken;
    }
    document::LoadPaint last_load() {
        session().wait_until_applied();
        document::LoadPaint last;
        for (const document::Event& event : session().recording().events) {
            if (const auto* load = std::get_if<document::LoadPaint>(&event.action)) last = *load;
        }
        return last;
    }

    TemporaryFolder home_;
};

// ---- curves

class CurvesWindow : public BrushesWindow {
  protected:
    panels::CurveEditor& editor() { return *window().findChild<panels::CurveEditor*>(); }
    void drag(const QPointF& from, const QPointF& to) {
        QTest::mousePress(&editor(), Qt::LeftButton, {}, from.toPoint());
        QMouseEvent event(QEvent::MouseMove, to, editor().mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                          {});
        QApplication::sendEvent(&editor(), &event);
        QTest::mouseRelease(&editor(), Qt::LeftButton, {}, to.toPoint());
    }
    /// The entry of a submenu, as it is when the menu opens.
    static QAction* addable(QMenu& menu, const QString& input, const QString& target) {
        Q_EMIT menu.aboutToShow();
        for (QAction* entry : menu.actions()) {
            if (entry->text() != input) continue;
            for (QAction* action : entry->menu()->actions())
                if (action->text() == target) return action;
        }
        return nullptr;
    }
    static void add_curve(QMenu& menu, const QString& input, const QString& target) {
        QAction* action = addable(menu, input, target);
        ASSERT_NE(action, nullptr);
        action->trigger();
    }
};

TEST_F(CurvesWindow, AChangedCurveIsPaintedWithFromTheNextStrokeOnAndRecorded) {
    const auto before = last_taken();
    EXPECT_EQ(before.definition, "");
    // The flat's pressure curve: (0, 0), (0.3, 0.22), (1, 1). Its last point is dragged to the ground.
    ASSERT_EQ(editor().points().size(), 3U);
    drag(editor().position_of({1.0, 1.0}), editor().position_of({1.0, 0.1}));
    ASSERT_TRUE(hand().own_preset.has_value());
    EXPECT_EQ(last_taken(), before) << "not before the next stroke";
    stroke();
    const TakeBrush taken = last_taken();
    const brush::Preset painted = brush::parse_preset(taken.definition, "recorded");
    // The mouse hits whole pixels; the editor is some 100 high.
    EXPECT_NEAR(painted.dynamics[0].points[2].output, 0.1, 0.02);
    EXPECT_EQ(painted.dynamics[0].points[1], (brush::CurvePoint{0.3, 0.22}));
    EXPECT_EQ(taken.seed, before.seed) << "the same piece";
    EXPECT_GT(volume_mm3(), 0.0);
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(CurvesWindow, ResetReturnsToTheBundledBrush) {
    auto* reset = window().findChild<QToolButton*>(QStringLiteral("curve_reset"));
    EXPECT_FALSE(reset->isEnabled());
    drag(editor().position_of({0.3, 0.22}), editor().position_of({0.5, 0.9}));
    EXPECT_TRUE(reset->isEnabled());
    QTest::mouseClick(reset, Qt::LeftButton);
    EXPECT_FALSE(hand().own_preset.has_value());
    EXPECT_EQ(editor().points(), brush::find_preset("flat").dynamics[0].points);
    stroke();
    EXPECT_EQ(last_taken().definition, "");
}

TEST_F(CurvesWindow, PointsComeAndGoByMouseAndByKeys) {
    const QPointF empty = editor().position_of({0.7, 0.2});
    QTest::mouseClick(&editor(), Qt::LeftButton, {}, empty.toPoint());
    ASSERT_EQ(editor().points().size(), 4U);
    EXPECT_EQ(editor().chosen_point(), 2);
    QTest::keyClick(&editor(), Qt::Key_Delete);
    EXPECT_EQ(editor().points(), brush::find_preset("flat").dynamics[0].points);

    for (int i = 0; i < 5; ++i)
        QTest::keyClick(&editor(), Qt::Key_PageUp);
    EXPECT_EQ(editor().chosen_point(), 0);
    QTest::keyClick(&editor(), Qt::Key_Insert);
    ASSERT_EQ(editor().points().size(), 4U);
    EXPECT_EQ(editor().points()[1], (brush::CurvePoint{0.15, 0.11}));
    QTest::keyClick(&editor(), Qt::Key_Right);
    QTest::keyClick(&editor(), Qt::Key_Up, Qt::ControlModifier);
    EXPECT_NEAR(editor().points()[1].input, 0.17, 1e-12);
    EXPECT_NEAR(editor().points()[1].output, 0.112, 1e-12);
    QTest::mouseClick(&editor(), Qt::RightButton, {},
                      editor().position_of(editor().points()[1]).toPoint());
    EXPECT_EQ(editor().points(), brush::find_preset("flat").dynamics[0].points);
}

TEST_F(CurvesWindow, TheReadingTellsTheCurvesValue) {
    auto* reading = window().findChild<QLabel*>(QStringLiteral("curve_reading"));
    QTest::keyClick(&editor(), Qt::Key_PageDown);
    QTest::keyClick(&editor(), Qt::Key_PageDown);
    EXPECT_EQ(reading->text().toStdString(), "30 % pressure → 22 %");
    auto* choice = window().findChild<QComboBox*>(QStringLiteral("curve_choice"));
    ASSERT_EQ(choice->count(), 4);
    choice->setCurrentIndex(3);
    EXPECT_EQ(editor().points(), brush::find_preset("flat").dynamics[3].points);
    // Half of the frame's 500 mm/s, on the line from (0, 1) to (400, 0.6).
    EXPECT_EQ(reading->text().toStdString(), "250 mm/s → × 0.75");
}

TEST_F(CurvesWindow, ACurveIsAddedBentAndPaintedWith) {
    auto& menu = *window().findChild<QMenu*>(QStringLiteral("curve_addable"));
    auto& which = *window().findChild<QComboBox*>(QStringLiteral("curve_choice"));
    const int before = which.count();
    add_curve(menu, QStringLiteral("Speed"), QStringLiteral("film that it leaves"));
    ASSERT_EQ(which.count(), before + 1);
    EXPECT_EQ(which.currentText(), QStringLiteral("Speed: film that it leaves"));
    drag(editor().position_of({500.0, 1.0}), editor().position_of({500.0, 0.2}));
    stroke();
    const auto preset = document::preset_of(last_taken());
    ASSERT_EQ(preset.dynamics.size(), static_cast<std::size_t>(before) + 1);
    EXPECT_EQ(preset.dynamics.back().target, brush::DynamicsTarget::Film);
    EXPECT_NEAR(preset.dynamics.back().points.back().output, 0.2, 0.02);  // a pixel of the editor
    EXPECT_TRUE(session().take_errors().empty());
    EXPECT_FALSE(
        addable(menu, QStringLiteral("Speed"), QStringLiteral("film that it leaves"))->isEnabled());
}

TEST_F(CurvesWindow, ARemovedCurveIsGoneAndComesBackAsItWasKept) {
    auto& menu = *window().findChild<QMenu*>(QStringLiteral("curve_addable"));
    auto& which = *window().findChild<QComboBox*>(QStringLiteral("curve_choice"));
    auto& remove = *window().findChild<QToolButton*>(QStringLiteral("curve_remove"));
    const auto kept = tools::preset_in_hand(hand()).dynamics;
    ASSERT_EQ(kept[0].target, brush::DynamicsTarget::Press);
    which.setCurrentIndex(0);
    remove.click();
    EXPECT_EQ(tools::preset_in_hand(hand()).dynamics.size(), kept.size() - 1);
    while (remove.isEnabled())
        remove.click();
    EXPECT_EQ(which.count(), 0);
    stroke();
    EXPECT_TRUE(document::preset_of(last_taken()).dynamics.empty());
    EXPECT_GT(volume_mm3(), 0.0);
    add_curve(menu, QStringLiteral("Pressure"), QStringLiteral("how far it is pressed"));
    EXPECT_EQ(editor().points(), kept[0].points);
    EXPECT_TRUE(session().take_errors().empty());
}

// ---- the painter's own

TEST_F(BrushesWindow, ShiftAndF10OpenTheMenuOfAList) {
    const auto offered = [&](QWidget& of) {
        QStringList words;
        QTimer closing;
        QObject::connect(&closing, &QTimer::timeout, &closing, [&words] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            if (menu == nullptr) return;
            for (const QAction* choice : menu->actions())
                words += choice->text();
            menu->close();
        });
        closing.start(5);
        QTest::keyClick(&of, Qt::Key_F10, Qt::ShiftModifier);
        return words;
    };
    list().setCurrentRow(1);
    EXPECT_TRUE(offered(list()).contains(QStringLiteral("New tag...")));
    EXPECT_TRUE(
        offered(*window().findChild<panels::LayerTree*>()).contains(action(Command::AddLayer)->text()));
    EXPECT_TRUE(offered(canvas()).isEmpty()) << "it has the pop-up palette";
}

TEST_F(BrushesWindow, TheBrushInHandIsInView) {
    settle();
    ASSERT_EQ(list().currentItem(), listed(QStringLiteral("Flat bristle 20")));
    EXPECT_TRUE(list().viewport()->rect().contains(list().visualItemRect(list().currentItem())));
}

TEST_F(BrushesWindow, ThumbnailsAreWantedOnceTheirRowsAreSeen) {
    std::vector<panels::BrushEntry> entries;
    for (int i = 0; i < 60; ++i)
        entries.push_back({QString::number(i), QStringLiteral("Family")});
    panels::BrushList many;
    std::vector<int> wanted;
    QObject::connect(&many, &panels::BrushList::thumbnail_wanted, &many,
                     [&](int entry) { wanted.push_back(entry); });
    many.show_entries(entries);
    many.resize(200, 300);
    many.show();
    EXPECT_TRUE(wanted.empty()) << "it does not stand on the screen yet";
    wait_for([&] { return !wanted.empty(); });
    EXPECT_EQ(wanted.front(), 0);
    EXPECT_LT(wanted.size(), 20U);
    many.scrollToBottom();
    wait_for([&] { return wanted.back() == 59; });
    EXPECT_LT(wanted.size(), 40U);
}

TEST_F(BrushesWindow, TheWidthMayBeTypedInOtherUnits) {
    auto* width = window().findChild<QDoubleSpinBox*>(QStringLiteral("brush_width"));
    ASSERT_NE(width, nullptr);
    width->setFocus();
    width->selectAll();
    QTest::keyClicks(width, QStringLiteral("1.5 cm"));
    QTest::keyClick(width, Qt::Key_Return);
    EXPECT_EQ(hand().brush_width_mm, 15.0);
}

TEST_F(BrushesWindow, AKeptBrushIsListedAndTakenAndComesBackWithTheProgram) {
    EXPECT_FALSE(studio().commands().action(Command::RenameBrush)->isEnabled());
    studio().easel().set_brush_width(12.0);
    answer_name(QStringLiteral("Evening flat"));
    give(Command::SaveBrush);
    EXPECT_TRUE(std::filesystem::exists(file("evening-flat.json")));
    ASSERT_NE(listed(QStringLiteral("Evening flat")), nullptr);
    EXPECT_TRUE(studio().commands().action(Command::RenameBrush)->isEnabled());
    click(QStringLiteral("Filbert 14"));
    EXPECT_EQ(hand().brush, "Filbert 14");
    click(QStringLiteral("Evening flat"));
    EXPECT_EQ(hand().brush, "Evening flat");
    EXPECT_EQ(hand().brush_width_mm, 12.0);
    stroke();
    EXPECT_EQ(brush::parse_preset(last_taken().definition, "recorded").name, "Evening flat");
    EXPECT_TRUE(session().take_errors().empty());
    main::MainWindow another(canvas_settings());
    const auto* there = another.findChild<panels::BrushList*>();
    EXPECT_EQ(there->findItems(QStringLiteral("Evening flat"), Qt::MatchExactly).size(), 1);
}

class OwnBrush : public BrushesWindow {
  protected:
    void write_files() override {
        write("mine.json", own_preset("Mine"));
        write("broken.json", "{\"version\": 2, \"kind\": \"broom\"}");
    }
};

TEST_F(OwnBrush, StandsInItsFamilyAndAFaultyFileIsListedAndNeverTaken) {
    const int mine = list().row(listed(QStringLiteral("Mine")));
    EXPECT_GT(mine, list().row(listed(QStringLiteral("Mop 30"))) - 3);
    EXPECT_LT(mine, list().row(listed(QStringLiteral("Knives and combs"))));
    QListWidgetItem* broken = listed(QStringLiteral("broken.json"));
    ASSERT_NE(broken, nullptr);
    EXPECT_THAT(broken->toolTip().toStdString(), HasSubstr("broken.json: kind is \"broom\""));
    click(QStringLiteral("Mine"));
    click(QStringLiteral("broken.json"));
    EXPECT_THAT(told(), HasSubstr("broken.json: kind is \"broom\""));
    EXPECT_EQ(hand().brush, "Mine");
    EXPECT_EQ(list().currentItem(), listed(QStringLiteral("Mine")));
    for (int i = 0; i < 40; ++i) {
        give(Command::NextBrush);
        EXPECT_NE(hand().brush, "broken.json");
    }
}

TEST_F(OwnBrush, IsOverwrittenOnlyWithConsent) {
    const std::string before = core::read_text_file(file("mine.json"));
    answer_name(QStringLiteral("Mine"));
    answer_question(false);
    give(Command::SaveBrush);
    EXPECT_EQ(core::read_text_file(file("mine.json")), before);
    EXPECT_EQ(hand().brush, "Flat bristle 20");
    answer_name(QStringLiteral("mine"));
    answer_question(true);
    give(Command::SaveBrush);
    EXPECT_NE(core::read_text_file(file("mine.json")), before);
    EXPECT_EQ(list().findItems(QStringLiteral("mine"), Qt::MatchFixedString).size(), 1);
    EXPECT_EQ(hand().brush, "mine");
}

TEST_F(OwnBrush, IsRenamedAndThrownAway) {
    click(QStringLiteral("Mine"));
    answer_name(QStringLiteral("Filbert 14"));
    give(Command::RenameBrush);
    EXPECT_THAT(told(), HasSubstr("There is already a brush \"Filbert 14\""));
    EXPECT_EQ(hand().brush, "Mine");
    answer_name(QStringLiteral("Yours"));
    give(Command::RenameBrush);
    EXPECT_EQ(hand().brush, "Yours");
    EXPECT_EQ(listed(QStringLiteral("Mine")), nullptr);
    EXPECT_TRUE(std::filesystem::exists(file("yours.json")));
    answer_question(true);
    give(Command::DeleteBrush);
    EXPECT_FALSE(std::filesystem::exists(file("yours.json")));
    EXPECT_EQ(listed(QStringLiteral("Yours")), nullptr);
    EXPECT_EQ(hand().brush, "Yours") << "what is in hand stays";
    stroke();
    EXPECT_GT(volume_mm3(), 0.0);
}

TEST_F(OwnBrush, IsNamedByF2InTheListAndNoLayerIs) {
    click(QStringLiteral("Mine"));
    answer_name(QStringLiteral("Yours"));
    QTest::keyClick(&list(), Qt::Key_F2);
    EXPECT_EQ(hand().brush, "Yours");
    click(QStringLiteral("Fan 26"));
    QTest::keyClick(&list(), Qt::Key_F2);
    EXPECT_EQ(hand().brush, "Fan 26") << "what ships keeps its name";
    EXPECT_EQ(window().findChild<panels::LayerTree*>()->viewport()->findChild<QLineEdit*>(), nullptr);
}

TEST_F(OwnBrush, IsThrownAwayByKeysInTheListWhichClearNoLayer) {
    stroke();
    const double painted_mm3 = volume_mm3();
    ASSERT_GT(painted_mm3, 0.0);
    QApplication::setActiveWindow(&window());
    click(QStringLiteral("Mine"));
    ASSERT_TRUE(list().hasFocus());
    answer_question(false);
    QTest::keyClick(&list(), Qt::Key_Delete);
    EXPECT_TRUE(std::filesystem::exists(file("mine.json")));
    click(QStringLiteral("Fan 26"));
    for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_Backspace})
        QTest::keyClick(&list(), key);
    EXPECT_NE(listed(QStringLiteral("Fan 26")), nullptr) << "what ships stays";
    click(QStringLiteral("Mine"));
    answer_question(true);
    QTest::keyClick(&list(), Qt::Key_Backspace);
    EXPECT_FALSE(std::filesystem::exists(file("mine.json")));
    EXPECT_EQ(volume_mm3(), painted_mm3);
}

TEST_F(OwnBrush, IsFoundByTheDigitsOfItsNameToo) {
    write("large.json", own_preset("Filbert 140"));
    parts().brushes.read();
    QApplication::setActiveWindow(&window());
    click(QStringLiteral("Fan 26"));
    const int interval_ms = QApplication::keyboardInputInterval();
    QApplication::setKeyboardInputInterval(60'000);
    QTest::keyClicks(&list(), QStringLiteral("filbert 14"));
    EXPECT_EQ(hand().brush, "Filbert 14");
    QTest::keyClick(&list(), Qt::Key_0);
    EXPECT_EQ(hand().brush, "Filbert 140");
    QApplication::setKeyboardInputInterval(interval_ms);
}

TEST_F(OwnBrush, FollowsItsFileAndSurvivesABadOne) {
    click(QStringLiteral("Mine"));
    write("mine.json", own_preset("Mine", 0.9));
    wait_for([&] { return tools::preset_in_hand(hand()).paint.film_mm == 0.9; });
    write("mine.json", "{");
    wait_for([&] { return listed(QStringLiteral("Mine")) == nullptr; });
    EXPECT_THAT(told(), HasSubstr("this is not valid JSON"));
    EXPECT_EQ(tools::preset_in_hand(hand()).paint.film_mm, 0.9);
    stroke();
    EXPECT_EQ(brush::parse_preset(last_taken().definition, "recorded").paint.film_mm, 0.9);
    write("mine.json", own_preset("Mine", 0.2));
    wait_for([&] { return listed(QStringLiteral("Mine")) != nullptr; });
}

TEST_F(OwnBrush, IsReplayedFromItsRecording) {
    click(QStringLiteral("Mine"));
    stroke();
    session().wait_until_applied();
    const document::Recording recording = session().recording();
    click(QStringLiteral("Filbert 14"));
    window().replay(recording);
    EXPECT_EQ(hand().brush, "Mine");
    EXPECT_EQ(tools::preset_in_hand(hand()).paint.film_mm, 0.4);
}

TEST_F(BrushesWindow, WhileARecordingIsPlayedTheBrushIsInAnotherHand) {
    stroke();
    session().wait_until_applied();
    document::Recording recording = session().recording();
    constexpr std::int64_t kLater = 20;
    recording.events.push_back({recording.end_tick + kLater, document::UseMedium{"house paint"}});
    window().replay(recording);
    session().wait_until_applied();
    const auto strokes = [&] {
        const auto events = session().recording().events;
        return std::count_if(events.begin(), events.end(), [](const auto& event) {
            return std::holds_alternative<document::PenDown>(event.action);
        });
    };
    stroke();
    session().wait_until_applied();
    EXPECT_LE(strokes(), 2);
    give(Command::Pause);  // goes on
    wait_for([&] { return !session().status().replaying && !studio().easel().brush_is_lent(); });
    EXPECT_EQ(strokes(), 2);
    stroke();
    session().wait_until_applied();
    EXPECT_EQ(strokes(), 3);
}

// ---- the list

class BrushLibrary : public BrushesWindow {
  protected:
    void write_files() override { write("mine.json", own_preset("Mine")); }

    std::vector<std::string> names() {
        std::vector<std::string> tools;
        for (int row = 0; row < list().count(); ++row)
            if (list().item(row)->flags() != Qt::NoItemFlags)
                tools.push_back(list().item(row)->text().toStdString());
        return tools;
    }
    void choose_folder(const QString& words) {
        auto* box = window().findChild<QComboBox*>(QStringLiteral("brush_folder"));
        const int index = box->findText(words);
        ASSERT_GE(index, 0) << words.toStdString();
        box->setCurrentIndex(index);
        Q_EMIT box->activated(index);
    }
    QLineEdit& search() { return *window().findChild<QLineEdit*>(QStringLiteral("brush_search")); }
    QAction& favourite() { return *action(Command::FavouriteBrush); }
};

TEST_F(BrushLibrary, IsSearchedByAFewLetters) {
    const std::size_t all = names().size();
    search().setText(QStringLiteral("knife"));
    for (const std::string& name : names())
        EXPECT_THAT(name, HasSubstr("knife"));
    EXPECT_EQ(names().size(), 4U);
    EXPECT_EQ(list().currentItem(), nullptr) << "what is in hand is not among them";
    QTest::keyClick(&search(), Qt::Key_Return);
    EXPECT_EQ(hand().brush, names().front());
    EXPECT_EQ(list().currentItem()->text().toStdString(), names().front());
    search().clear();
    EXPECT_EQ(names().size(), all);
    EXPECT_EQ(list().currentItem()->text().toStdString(), hand().brush);
}

TEST_F(BrushLibrary, SaysWhatItIsForWhereNothingIsListed) {
    const auto said = [this] {
        const bool alone = names().empty() && list().count() == 1;
        return alone ? list().item(0)->text() : QStringLiteral("tools");
    };
    search().setText(QStringLiteral("no such tool"));
    EXPECT_EQ(said(), "No tool has such a name.");
    QTest::keyClick(&search(), Qt::Key_Return);
    EXPECT_EQ(list().current_entry(), -1) << "there is none to be taken";
    choose_folder(QStringLiteral("Favourites"));
    EXPECT_EQ(said(), "Tools that you mark with a star are listed here.");
    std::filesystem::remove(file("mine.json"));
    parts().brushes.read();
    choose_folder(QStringLiteral("My own"));
    EXPECT_EQ(said(), "Tools that you save as your own are listed here.");
    choose_folder(QStringLiteral("All"));
    EXPECT_EQ(said(), "tools");
}

TEST_F(BrushLibrary, AFamilyIsAFolderAndKeysStayInIt) {
    choose_folder(QStringLiteral("Knives and combs"));
    click(QStringLiteral("Comb 25"));
    for (int i = 0; i < 20; ++i) {
        give(Command::NextBrush);
        EXPECT_THAT(names(), testing::Contains(hand().brush));
    }
    choose_folder(QStringLiteral("My own"));
    EXPECT_EQ(names(), std::vector<std::string>{"Mine"});
}

TEST_F(BrushLibrary, FavouritesAreKeptAndFollowTheirNames) {
    click(QStringLiteral("Mine"));
    favourite().trigger();
    click(QStringLiteral("Fan 26"));
    EXPECT_FALSE(favourite().isChecked());
    favourite().trigger();
    choose_folder(QStringLiteral("Favourites"));
    EXPECT_EQ(names().size(), 2U);
    click(QStringLiteral("Mine \u2605"));
    EXPECT_TRUE(favourite().isChecked());
    answer_name(QStringLiteral("Yours"));
    give(Command::RenameBrush);
    start_again();
    choose_folder(QStringLiteral("Favourites"));
    ASSERT_EQ(names().size(), 2U);
    EXPECT_NE(listed(QStringLiteral("Yours \u2605")), nullptr);
    click(QStringLiteral("Fan 26 \u2605"));
    favourite().trigger();
    EXPECT_EQ(names().size(), 1U);
}

TEST_F(BrushLibrary, StandsInThePaintersOrderAtTheNextStartToo) {
    choose_folder(QStringLiteral("Knives and combs"));
    const std::vector<std::string> shipped = names();
    ASSERT_GE(shipped.size(), 2U);
    const auto move = [this](const std::string& name, Qt::Key key) {
        list().setCurrentItem(listed(QString::fromStdString(name)));
        QTest::keyClick(&list(), key, Qt::AltModifier);
        QApplication::processEvents();
    };
    move(shipped[1], Qt::Key_Up);
    std::vector<std::string> moved = shipped;
    std::swap(moved[0], moved[1]);
    EXPECT_EQ(names(), moved);
    start_again();
    choose_folder(QStringLiteral("Knives and combs"));
    EXPECT_EQ(names(), moved);
    choose_folder(QStringLiteral("All"));
    const std::vector<std::string> all = names();
    move(moved[0], Qt::Key_Up);
    EXPECT_EQ(names(), all) << "a tool stays in its family";
    for (const std::string& name : {shipped[0], shipped[1]}) {
        click(QString::fromStdString(name));
        favourite().trigger();
    }
    choose_folder(QStringLiteral("Favourites"));
    const std::vector<std::string> starred = names();
    move(starred[1], Qt::Key_Up);
    EXPECT_EQ(names(), (std::vector<std::string>{starred[1], starred[0]}));
}

TEST_F(BrushLibrary, WhatAnotherWindowHasStarredMeanwhileStaysSo) {
    const auto shelf_file = core::user_data_path("brush-shelf.json");
    click(QStringLiteral("Mine"));
    favourite().trigger();
    tools::BrushShelf theirs = tools::read_brush_shelf(shelf_file);
    tools::set_favourite("Fan 26", true, theirs);
    tools::set_tag("Fan 26", "grass", true, theirs);
    tools::write_brush_shelf(theirs, shelf_file);
    click(QStringLiteral("Filbert 14"));
    favourite().trigger();
    start_again();
    const tools::BrushShelf both = tools::read_brush_shelf(shelf_file);
    EXPECT_THAT(both.favourites, testing::UnorderedElementsAre("Mine", "Fan 26", "Filbert 14"));
    EXPECT_NE(tools::find_tag("grass", both), nullptr);
    choose_folder(QStringLiteral("Favourites"));
    click(QStringLiteral("Mine \u2605"));
    favourite().trigger();
    start_again();
    EXPECT_THAT(tools::read_brush_shelf(shelf_file).favourites,
                testing::UnorderedElementsAre("Fan 26", "Filbert 14"));
}

TEST_F(BrushLibrary, TagsAreFoldersThatAreFoundAgain) {
    auto* panel = window().findChild<panels::BrushPanel*>();
    Q_EMIT panel->tagged(QStringLiteral("Fan 26"), QStringLiteral("grass"), true);
    Q_EMIT panel->tagged(QStringLiteral("Mine"), QStringLiteral("grass"), true);
    choose_folder(QStringLiteral("grass"));
    EXPECT_EQ(names(), (std::vector<std::string>{"Fan 26", "Mine"}));
    start_again();
    panel = window().findChild<panels::BrushPanel*>();
    choose_folder(QStringLiteral("grass"));
    EXPECT_EQ(names(), (std::vector<std::string>{"Fan 26", "Mine"}));
    Q_EMIT panel->tagged(QStringLiteral("Fan 26"), QStringLiteral("grass"), false);
    EXPECT_EQ(names(), std::vector<std::string>{"Mine"});
    Q_EMIT panel->tagged(QStringLiteral("Mine"), QStringLiteral("grass"), false);
    const auto* box = window().findChild<QComboBox*>(QStringLiteral("brush_folder"));
    EXPECT_EQ(box->findText(QStringLiteral("grass")), -1);
    EXPECT_GT(names().size(), 10U) << "all tools are shown where there is no such tag any more";
    parts().brush_shelf.set_tag(QStringLiteral("Mine"), QStringLiteral(" "), true);
    EXPECT_EQ(told(), "A tag needs a name.");
}

TEST_F(BrushLibrary, TheLatestAreListedFirst) {
    click(QStringLiteral("Filbert 14"));
    click(QStringLiteral("Fan 26"));
    choose_folder(QStringLiteral("Recent"));
    EXPECT_EQ(names().at(0), "Fan 26");
    EXPECT_EQ(names().at(1), "Filbert 14");
    click(QStringLiteral("Filbert 14"));
    EXPECT_EQ(names().at(0), "Fan 26") << "none moves away under the pointer";
    start_again();
    choose_folder(QStringLiteral("Recent"));
    EXPECT_EQ(names().at(0), hand().brush);
    EXPECT_NE(listed(QStringLiteral("Fan 26")), nullptr);
}

TEST_F(BrushLibrary, ThumbnailsThatWerePaintedAreShownAgain) {
    const auto has_picture = [&] {
        const QListWidgetItem* item = listed(QStringLiteral("Flat bristle 20"));
        return !item->data(Qt::UserRole + 2).value<QImage>().isNull();
    };
    wait_for(has_picture);
    search().setText(QStringLiteral("flat"));
    wait_for(has_picture);
}

TEST_F(BrushLibrary, ABundleComesBackWithAllItsTools) {
    const auto bundle = home_.path() / "mine.zip";
    parts().brush_bundles.export_to(QString::fromStdString(bundle.string()));
    std::filesystem::remove(file("mine.json"));
    parts().brushes.read();
    ASSERT_EQ(listed(QStringLiteral("Mine")), nullptr);
    parts().brush_bundles.import_from(QString::fromStdString(bundle.string()));
    ASSERT_NE(listed(QStringLiteral("Mine")), nullptr);
    EXPECT_EQ(core::read_text_file(file("mine.json")), own_preset("Mine"));
    parts().brush_bundles.import_from(QString::fromStdString(bundle.string()));
    EXPECT_THAT(told(), HasSubstr("all tools of that bundle already"));
}

TEST_F(BrushLibrary, ABundleBringsItsTags) {
    const QString bundle = QString::fromStdString((home_.path() / "mine.zip").string());
    const auto tag = [&](const char* tool, const char* name, bool tagged) {
        parts().brush_shelf.set_tag(QString::fromLatin1(tool), QString::fromLatin1(name), tagged);
    };
    tag("Mine", "grass", true);
    tag("Fan 26", "grass", true);
    tag("Fan 26", "sky", true);
    parts().brush_bundles.export_to(bundle);
    for (const char* tool : {"Mine", "Fan 26"})
        tag(tool, "grass", false);
    tag("Fan 26", "sky", false);
    // Another tool has taken the name meanwhile.
    brush::Preset other = brush::find_preset("Fan 26");
    other.name = "Mine";
    core::write_text_file(file("mine.json"), brush::preset_to_json(other));
    parts().brushes.read();
    parts().brush_bundles.import_from(bundle);
    const std::vector<tools::BrushTag>& tags = parts().brush_shelf.tags();
    ASSERT_EQ(tags.size(), 1U) << "no tool of the painter's own was under the sky";
    EXPECT_EQ(tags[0].name, "grass");
    ASSERT_EQ(tags[0].tools.size(), 2U);
    EXPECT_NE(tags[0].tools[0], "Mine");
    EXPECT_NE(listed(QString::fromStdString(tags[0].tools[0])), nullptr);
    EXPECT_EQ(tags[0].tools[1], "Fan 26");
}

TEST_F(BrushLibrary, OfABadBundleNothingIsImported) {
    const auto bundle = home_.path() / "bad.zip";
    core::write_text_file(bundle, "no archive");
    const auto before = names();
    std::string sentence;
    when_asked<QMessageBox>([&](QMessageBox& box) {
        sentence = box.text().toStdString();
        box.accept();
    });
    parts().brush_bundles.import_from(QString::fromStdString(bundle.string()));
    EXPECT_THAT(sentence, HasSubstr("bad.zip"));
    EXPECT_EQ(names(), before);
}

// ---- loads

class Loads : public BrushesWindow {
  protected:
    void choose(tools::Dip::Way way) {
        auto* box = window().findChild<QComboBox*>(QStringLiteral("dip_way"));
        const int index = box->findData(static_cast<int>(way));
        box->setCurrentIndex(index);
        Q_EMIT box->activated(index);
    }
    const brush::LoadProfile& shown() {
        session().wait_until_applied();
        QApplication::processEvents();
        return window().findChild<panels::LoadBar*>()->load();
    }
};

TEST_F(Loads, EveryWayOfDippingReachesTheNextStroke) {
    using Way = tools::Dip::Way;
    stroke();
    EXPECT_TRUE(last_load().second.ingredients.empty());
    choose(Way::TwoSides);
    stroke();
    EXPECT_TRUE(last_load().side_by_side);
    EXPECT_EQ(last_load().second, hand().second_paint);
    choose(Way::HalfMixed);
    window().findChild<QDoubleSpinBox*>(QStringLiteral("dip_share"))->setValue(30.0);
    stroke();
    EXPECT_FALSE(last_load().side_by_side);
    EXPECT_EQ(last_load().second_share, 0.3);
    EXPECT_GT(last_load().share_variation, 0.0);
    choose(Way::Tip);
    window().findChild<QDoubleSpinBox*>(QStringLiteral("dip_fill"))->setValue(40.0);
    stroke();
    EXPECT_TRUE(last_load().tip_only);
    EXPECT_EQ(last_load().fill, 0.4);
    EXPECT_TRUE(last_load().second.ingredients.empty());
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(Loads, TheBarShowsWhatTheBrushHolds) {
    EXPECT_NEAR(shown().fill, 1.0, 1e-9);
    give(Command::BlotBrush);
    EXPECT_NEAR(shown().fill, 0.25, 1e-9);
    give(Command::TopUpBrush);
    EXPECT_NEAR(shown().fill, 1.0, 1e-9);
    give(Command::CleanBrush);
    EXPECT_EQ(shown().fill, 0.0);
    choose(tools::Dip::Way::TwoSides);
    give(Command::ReloadBrush);
    EXPECT_NE(shown().stripes.front().paint, shown().stripes.back().paint);
}

TEST_F(Loads, TheTwoPaintsChangePlaces) {
    const document::PaintRecipe first = hand().paint, second = hand().second_paint;
    give(Command::SwapPaints);
    EXPECT_EQ(last_load().paint, second);
    EXPECT_EQ(hand().second_paint, first);
    window().findChild<QPushButton*>(QStringLiteral("second_paint"))->click();
    EXPECT_EQ(last_load().paint, first);
}

TEST_F(Loads, WhatIsNotDippedCannotBeReloaded) {
    click(QStringLiteral("Rag 35"));
    EXPECT_FALSE(studio().commands().action(Command::ReloadBrush)->isEnabled());
    EXPECT_FALSE(studio().commands().action(Command::TopUpBrush)->isEnabled());
    EXPECT_TRUE(studio().commands().action(Command::CleanBrush)->isEnabled());
    click(QStringLiteral("Filbert 14"));
    EXPECT_TRUE(studio().commands().action(Command::ReloadBrush)->isEnabled());
}

}  // namespace
}  // namespace pastoso::tests
