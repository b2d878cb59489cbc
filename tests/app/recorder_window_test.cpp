// What is recorded, and watching it grow again beside the painting.
#include "app/window_fixture.hpp"
#include "dialogs/export_dialog.hpp"
#include "document/painting_state.hpp"
#include "help/topic.hpp"
#include "main/files/replay_window.hpp"
#include "main/window_parts.hpp"

#include <stdexcept>

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QTest>
#include <QToolButton>

namespace pastoso::tests {
namespace {

using commands::Command;

class RecorderWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (!HasFatalFailure()) action(Command::RecorderPanel)->trigger();
    }
    template <class Widget>
    Widget& find(const char* name, QWidget* within = nullptr) {
        QWidget* place = within != nullptr ? within : &window();
        auto* found = place->findChild<Widget*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    main::ReplayWindow* replay() { return window().findChild<main::ReplayWindow*>(); }
    void paint() {
        mouse_stroke(line_mm({12.0, 12.0}, {48.0, 12.0}));
        mouse_stroke(line_mm({12.0, 28.0}, {48.0, 28.0}));
        session().wait_until_applied();
    }
    void watch() {
        action(Command::Pause)->trigger();
        settle();
        action(Command::Play)->trigger();
        ASSERT_NE(replay(), nullptr);
        wait_until_shown(*replay());
    }
    std::uint64_t hash() { return document::state_hash(session().capture().painting); }
    std::uint64_t replayed() { return film::state_hash(replay()->replayer().snapshot()->film); }
    void wait_until_found() {
        wait_for([this] { return !replay()->replayer().status().seeking; });
    }
};

TEST_F(RecorderWindow, AKeyShowsIt) {
    find<QDockWidget>("recorder_panel").hide();
    QTest::keyClick(&window(), Qt::Key_F4, Qt::ShiftModifier);
    EXPECT_TRUE(find<QDockWidget>("recorder_panel").isVisible());
}

TEST_F(RecorderWindow, CountsStrokesAndTime) {
    EXPECT_EQ(find<QLabel>("recorded_strokes").text(), QStringLiteral("0"));
    paint();
    wait_for([this] { return find<QLabel>("recorded_strokes").text() == QStringLiteral("2"); });
    wait_for([this] { return find<QLabel>("recorded_time").text() != QStringLiteral("0:00"); });
}

TEST_F(RecorderWindow, APaintingThatIsOpenedBringsItsStrokes) {
    const TemporaryFolder folder;
    paint();
    const QString path = QString::fromStdString((folder.path() / "a.pastoso").string());
    parts().files.save_painting(path);
    ASSERT_TRUE(parts().files.saver().wait().isEmpty());
    parts().files.open_painting(path);
    loaded();
    mouse_stroke(line_mm({12.0, 20.0}, {48.0, 20.0}));
    session().wait_until_applied();
    wait_for([this] { return find<QLabel>("recorded_strokes").text() == QStringLiteral("3"); });
}

TEST_F(RecorderWindow, WatchingLeavesThePaintingAsItIs) {
    paint();
    watch();
    const std::uint64_t before = hash();
    const auto changes = session().status().changes;
    find<QComboBox>("replay_speed", replay()).setCurrentIndex(3);
    wait_for([this] {
        const auto status = replay()->replayer().status();
        return status.tick == status.end_tick && !status.playing;
    });
    EXPECT_EQ(replayed(), film::state_hash(session().snapshot()->film));
    QTest::mouseClick(&replay()->canvas(), Qt::LeftButton);
    replay()->close();
    wait_for([this] { return replay() == nullptr; });
    EXPECT_EQ(hash(), before);
    EXPECT_EQ(session().status().changes, changes);
    EXPECT_EQ(studio().easel().brush_is_lent(), false);
}

TEST_F(RecorderWindow, TheManualIsOpenedAtWatching) {
    paint();
    watch();
    const QString page = QStringLiteral("history-and-files#the-recorder");
    EXPECT_EQ(help::topic_of(&replay()->canvas()), page);
    EXPECT_EQ(help::topic_of(&find<QSlider>("replay_place", replay())), page);
}

TEST_F(RecorderWindow, ItIsStoppedAndSoughtBackAndForth) {
    paint();
    watch();
    auto& play = find<QToolButton>("replay_play", replay());
    auto& place = find<QSlider>("replay_place", replay());
    wait_for([&] { return replay()->replayer().snapshot() != nullptr; });
    find<QComboBox>("replay_speed", replay()).setCurrentIndex(0);
    replay()->replayer().set_playing(false);
    place.setValue(place.maximum());
    wait_until_found();
    const std::uint64_t end = replayed();
    EXPECT_EQ(end, film::state_hash(session().snapshot()->film));
    place.setValue(0);
    wait_until_found();
    EXPECT_NE(replayed(), end);
    EXPECT_EQ(film::totals(replay()->replayer().snapshot()->film).thickness, 0);
    place.setValue(place.maximum());
    wait_until_found();
    EXPECT_EQ(replayed(), end);
    wait_for([&] { return play.text() == QStringLiteral("Play"); });
    // Begins anew, and so slowly that its beginning cannot be missed.
    replay()->replayer().set_speed(0.001);
    play.click();
    wait_for([this] { return replay()->replayer().status().tick < 20; });
    EXPECT_TRUE(replay()->replayer().status().playing);
    play.click();
    EXPECT_FALSE(replay()->replayer().status().playing);
    EXPECT_EQ(play.text(), QStringLiteral("Play"));
}

TEST_F(RecorderWindow, NothingPaintedIsNothingToWatch) {
    action(Command::Play)->trigger();
    EXPECT_EQ(replay(), nullptr);
    EXPECT_EQ(told(), "Nothing has been painted yet that could be shown again.");
}

TEST_F(RecorderWindow, ATimeLapseIsAskedForWithItsCanvas) {
    paint();
    action(Command::MakeTimelapse)->trigger();
    auto* dialog = window().findChild<dialogs::ExportDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(dialog->settings().form, tools::ExportForm::Timelapse);
    auto& finer = find<QDoubleSpinBox>("film_px_per_mm", dialog);
    EXPECT_TRUE(finer.isVisible());
    EXPECT_EQ(finer.text(), QStringLiteral("as it was painted"));
    const QLabel& outcome = find<QLabel>("outcome", dialog);
    EXPECT_TRUE(outcome.text().contains(QStringLiteral("240 × 160"))) << outcome.text().toStdString();
    finer.setValue(6.0);
    EXPECT_TRUE(outcome.text().contains(QStringLiteral("360 × 240"))) << outcome.text().toStdString();
    EXPECT_EQ(tools::timelapse_choice(dialog->settings(), "film", {}).px_per_mm, 6.0);
    finer.setValue(64.0);
    EXPECT_EQ(dialog->settings().film_px_per_mm, 64.0);
    dialog->reject();
}

}  // namespace
}  // namespace pastoso::tests
