// Painting the painting again on finer cells, in a window of its own.
#include "main/files/repaint_window.hpp"

#include "app/window_fixture.hpp"
#include "core/thread_pool.hpp"
#include "dialogs/repaint_dialog.hpp"
#include "document/painting_state.hpp"
#include "files/image.hpp"
#include "main/window_parts.hpp"
#include "project/project.hpp"

#include <stdexcept>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

namespace pastoso::tests {
namespace {

using commands::Command;

class RepaintWindowTest : public WindowTest {
  protected:
    template <class Widget>
    Widget& find(QWidget& place, const char* name) {
        auto* found = place.findChild<Widget*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    main::RepaintWindow* repaint() { return parts().again.window(); }
    QPushButton& button(const char* name) { return find<QPushButton>(*repaint(), name); }
    /// What is asked in a box is answered by its button of that role.
    void answer(QMessageBox::ButtonRole role) {
        QTimer::singleShot(0, &window(), [this, role] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box == nullptr) return answer(role);
            for (QAbstractButton* button : box->buttons())
                if (box->buttonRole(button) == role) return button->click();
        });
    }

    /// Two strokes, and the dialog.
    dialogs::RepaintDialog& asked() {
        mouse_stroke(line_mm({12.0, 12.0}, {48.0, 12.0}));
        mouse_stroke(line_mm({12.0, 28.0}, {48.0, 20.0}));
        session().wait_until_applied();
        action(Command::Pause)->trigger();
        settle();
        action(Command::PaintAgain)->trigger();
        auto* dialog = window().findChild<dialogs::RepaintDialog*>();
        if (dialog == nullptr) throw std::runtime_error("no dialog");
        return *dialog;
    }
    void start(double px_per_mm) {
        dialogs::RepaintDialog& dialog = asked();
        find<QDoubleSpinBox>(dialog, "px_per_mm").setValue(px_per_mm);
        dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
        ASSERT_NE(repaint(), nullptr);
    }
    void wait_until_whole() {
        wait_for([this] { return repaint()->repainter().painted() != nullptr; });
        wait_for([this] { return button("repaint_put_up").isVisible(); });
    }
    std::uint64_t hash() { return document::state_hash(session().capture().painting); }
};

TEST_F(RepaintWindowTest, OnTheSameCellsItIsTheSamePainting) {
    start(canvas_settings().px_per_mm);
    wait_until_whole();
    EXPECT_EQ(document::state_hash(repaint()->repainter().painted()->painting), hash());
}

TEST_F(RepaintWindowTest, FinerItComesOntoTheEaselWhenItIsWanted) {
    start(2.0 * canvas_settings().px_per_mm);
    const std::uint64_t before = hash();
    wait_until_whole();
    EXPECT_EQ(hash(), before) << "the painting on the easel stays as it is";
    EXPECT_FALSE(button("repaint_pause").isVisible());
    const std::uint64_t painted = document::state_hash(repaint()->repainter().painted()->painting);
    answer(QMessageBox::DestructiveRole);  // what is on the easel stands in no file
    button("repaint_put_up").click();
    wait_for([this] { return repaint() == nullptr; });
    EXPECT_EQ(session().canvas().px_per_mm, 2.0 * canvas_settings().px_per_mm);
    EXPECT_EQ(hash(), painted);
    EXPECT_TRUE(window().isWindowModified());
    EXPECT_EQ(session().record().strokes(), 2);
}

TEST_F(RepaintWindowTest, ItIsSavedAsAPaintingOrAPicture) {
    const TemporaryFolder folder;
    start(6.0);
    wait_until_whole();
    const auto painted = repaint()->repainter().painted();
    for (const char* name : {"finer.pastoso", "finer.png"}) {
        parts().again.save(painted, QString::fromStdString((folder.path() / name).string()));
        wait_for([this] { return !parts().again.is_saving(); });
    }
    core::ThreadPool pool;
    const project::Project saved = project::load_project(folder.path() / "finer.pastoso", pool);
    EXPECT_EQ(document::state_hash(saved.painting), document::state_hash(painted->painting));
    EXPECT_EQ(saved.strokes.canvas.px_per_mm, 6.0);
    EXPECT_EQ(files::read_grey_image(folder.path() / "finer.png").width, 360);
    parts().again.save(painted, QStringLiteral("/nowhere/finer.png"));
    wait_for([this] { return told().find("/nowhere/finer.png") != std::string::npos; });
    repaint()->close();  // without a question: it stands in a file
    wait_for([this] { return repaint() == nullptr; });
}

TEST_F(RepaintWindowTest, TheMainWindowAsksBeforeItCloses) {
    start(30.0);
    answer(QMessageBox::NoRole);
    window().close();
    EXPECT_TRUE(window().isVisible());
    ASSERT_NE(repaint(), nullptr);
    repaint()->let_go();
}

TEST_F(RepaintWindowTest, ItWaitsAndIsGivenUp) {
    start(30.0);
    button("repaint_pause").click();
    EXPECT_EQ(button("repaint_pause").text(), QStringLiteral("Go on"));
    EXPECT_EQ(find<QLabel>(*repaint(), "repaint_time").text(), QStringLiteral("Paused"));
    // The tick that it was at ends; then nothing goes on.
    wait_for([this] {
        const double done = repaint()->repainter().status().done;
        QTest::qWait(300);
        return repaint()->repainter().status().done == done;
    });
    const double done = repaint()->repainter().status().done;
    button("repaint_pause").click();
    wait_for([&] { return repaint()->repainter().status().done > done; });
    button("repaint_pause").click();
    const auto* open = repaint();
    action(Command::PaintAgain)->trigger();
    EXPECT_EQ(repaint(), open) << "one at a time";
    answer(QMessageBox::NoRole);
    button("repaint_cancel").click();
    ASSERT_NE(repaint(), nullptr);
    EXPECT_TRUE(repaint()->isVisible());
    answer(QMessageBox::YesRole);
    button("repaint_cancel").click();
    wait_for([this] { return repaint() == nullptr; });
}

TEST_F(RepaintWindowTest, TheDialogSaysWhatItTakes) {
    dialogs::RepaintDialog& dialog = asked();
    auto& cells = find<QDoubleSpinBox>(dialog, "px_per_mm");
    EXPECT_EQ(cells.value(), 2.0 * canvas_settings().px_per_mm);
    cells.setValue(16.0);
    const QString words = find<QLabel>(dialog, "summary").text();
    EXPECT_TRUE(
        words.startsWith(QStringLiteral("960 × 640 pixels, which take about 0.2 GB of memory; ")))
        << words.toStdString();
    cells.selectAll();
    QTest::keyClicks(&cells, QStringLiteral("508 dpi"));
    EXPECT_DOUBLE_EQ(cells.value(), 20.0);
    dialog.reject();
}

TEST_F(RepaintWindowTest, NothingPaintedIsNothingToPaintAgain) {
    action(Command::PaintAgain)->trigger();
    EXPECT_EQ(told(), "Nothing has been painted yet that could be painted again.");
    EXPECT_EQ(repaint(), nullptr);
}

}  // namespace
}  // namespace pastoso::tests
