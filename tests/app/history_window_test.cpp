// The panel of what was done.
#include "app/canvas_mouse.hpp"
#include "app/window_fixture.hpp"
#include "panels/history/step_words.hpp"

#include <stdexcept>

#include <QAbstractItemModel>
#include <QAction>
#include <QListView>
#include <QTest>

namespace pastoso::tests {
namespace {

using commands::Command;

class HistoryWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        action(Command::Pause)->trigger();
        action(Command::HistoryPanel)->trigger();
    }
    QListView& list() {
        auto* found = window().findChild<QListView*>(QStringLiteral("history_list"));
        if (found == nullptr) throw std::runtime_error("history_list");
        return *found;
    }
    QStringList rows() {
        QStringList rows;
        for (int row = 0; row < list().model()->rowCount(); ++row)
            rows += list().model()->index(row, 0).data().toString();
        return rows;
    }
    void click(int row) {
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {},
                          list().visualRect(list().model()->index(row, 0)).center());
        settle();
    }
    void stroke(double y_mm) {
        mouse_stroke(line_mm({10, y_mm}, {30, y_mm}));
        settle();
    }
};

TEST_F(HistoryWindow, StepsAreNamedAndTheLatestIsMarked) {
    stroke(8);
    action(Command::AddLayer)->trigger();
    settle();
    action(Command::DryNow)->trigger();
    settle();
    EXPECT_EQ(rows(), (QStringList{"As far back as is kept", "Stroke", "New layer", "Dry now"}));
    EXPECT_EQ(list().currentIndex().row(), 3);
}

TEST_F(HistoryWindow, AClickGoesBackAndAnotherForthAgain) {
    std::vector<double> volumes_mm3{volume_mm3()};
    for (const double y_mm : {6.0, 12.0, 18.0}) {
        stroke(y_mm);
        volumes_mm3.push_back(volume_mm3());
    }
    click(1);
    EXPECT_EQ(list().currentIndex().row(), 1);
    EXPECT_DOUBLE_EQ(volume_mm3(), volumes_mm3[1]);
    click(3);
    EXPECT_EQ(list().currentIndex().row(), 3);
    EXPECT_DOUBLE_EQ(volume_mm3(), volumes_mm3[3]);
    click(0);
    EXPECT_EQ(list().currentIndex().row(), 0);
    EXPECT_EQ(volume_mm3(), 0.0);
    EXPECT_EQ(rows().size(), 4) << "what was undone can still be done again";
    stroke(10);
    EXPECT_EQ(rows().size(), 2);
}

TEST_F(HistoryWindow, APressBesideTheCanvasIsNoStepUntilItTouches) {
    const auto drag = [&](const glm::dvec2& from_mm, const glm::dvec2& to_mm) {
        send_mouse(canvas(), QEvent::MouseButtonPress, from_mm, {});
        for (const glm::dvec2& place_mm : line_mm(from_mm, to_mm))
            send_mouse(canvas(), QEvent::MouseMove, place_mm, {});
        send_mouse(canvas(), QEvent::MouseButtonRelease, to_mm, {});
        settle();
    };
    const std::int64_t changes = session().status().changes;
    drag({-200, 8}, {-190, 8});
    EXPECT_FALSE(session().status().can_undo);
    EXPECT_EQ(session().status().changes, changes);
    drag({-200, 8}, {15, 8});
    EXPECT_EQ(rows(), (QStringList{"As far back as is kept", "Stroke"}));
    EXPECT_EQ(session().status().changes, changes + 1);
}

}  // namespace
}  // namespace pastoso::tests
