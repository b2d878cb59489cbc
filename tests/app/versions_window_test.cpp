// Numbered versions of a painting, and closing it.
#include "app/window_fixture.hpp"
#include "core/file_size_limit.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "main/window_parts.hpp"
#include "start/start_page.hpp"

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

namespace fs = std::filesystem;
using commands::Command;
using testing::HasSubstr;
using testing::StartsWith;
using testing::UnorderedElementsAre;

class VersionsWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (!HasFatalFailure()) action(Command::Pause)->trigger();
    }

    fs::path path(const char* name) const { return folder_.path() / name; }
    void paint(double y_mm = 20.0) {
        mouse_stroke(line_mm({12.0, y_mm}, {48.0, y_mm + 4.0}));
        settle();
    }
    void save(const char* name) {
        parts().files.save_painting(QString::fromStdString(path(name).string()));
        written();
    }
    std::string written() {
        std::string fault = parts().files.saver().wait().toStdString();
        QApplication::processEvents();
        return fault;
    }
    std::string save_version() {
        action(Command::SaveVersion)->trigger();
        return written();
    }
    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder_.path()))
            found.push_back(entry.path().filename().string());
        return found;
    }
    std::string file() { return parts().files.path().toStdString(); }
    std::uint64_t state() { return document::state_hash(session().capture().painting); }
    void open(const char* name) {
        parts().files.open_painting(QString::fromStdString(path(name).string()));
        loaded();
        settle();
    }

    /// While `work` runs, a message box is answered by this button, a file dialog is left.
    void answered(QMessageBox::StandardButton button, const std::function<void()>& work) {
        asked_.clear();
        QTimer poll;
        QObject::connect(&poll, &QTimer::timeout, &poll, [this, button] {
            if (auto* files = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                asked_ += "file dialog";
                files->reject();
            } else if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                asked_ += box->text().toStdString();
                box->button(button)->click();
            }
        });
        poll.start(10);
        work();
    }
    bool page_is_shown() {
        const auto* page = window().findChild<start::StartPage*>();
        return page != nullptr && page->isVisible();
    }

    TemporaryFolder folder_;
    std::string asked_;
};

TEST_F(VersionsWindow, EachIsAFileOfItsOwnAndThePaintingGoesOnInTheLatest) {
    paint();
    save("rose.pastoso");
    const std::string first = core::read_text_file(path("rose.pastoso"));
    const std::uint64_t first_state = state();
    paint(28.0);
    EXPECT_EQ(save_version(), "");
    EXPECT_EQ(file(), path("rose_001.pastoso").string());
    EXPECT_THAT(window().windowTitle().toStdString(), StartsWith("rose_001.pastoso[*] "));
    EXPECT_FALSE(window().isWindowModified());
    const std::uint64_t second_state = state();
    paint(12.0);
    EXPECT_TRUE(window().isWindowModified());
    EXPECT_EQ(save_version(), "");
    EXPECT_THAT(names(), UnorderedElementsAre("rose.pastoso", "rose_001.pastoso", "rose_002.pastoso"));
    EXPECT_EQ(core::read_text_file(path("rose.pastoso")), first);
    open("rose_001.pastoso");
    EXPECT_EQ(state(), second_state);
    open("rose.pastoso");
    EXPECT_EQ(state(), first_state);
}

TEST_F(VersionsWindow, ReplacesNothing) {
    core::write_text_file(path("rose_001.pastoso"), "somebody's");
    paint();
    save("rose.pastoso");
    EXPECT_EQ(save_version(), "");
    EXPECT_EQ(file(), path("rose_002.pastoso").string());
    EXPECT_EQ(core::read_text_file(path("rose_001.pastoso")), "somebody's");
}

TEST_F(VersionsWindow, WithoutRoomThePaintingKeepsItsFile) {
    paint();
    save("rose.pastoso");
    const std::string old = core::read_text_file(path("rose.pastoso"));
    paint(28.0);
    {
        const FileSizeLimit limit(old.size() / 2);
        EXPECT_THAT(save_version(), HasSubstr("rose_001.pastoso: cannot be written"));
    }
    EXPECT_EQ(file(), path("rose.pastoso").string());
    EXPECT_TRUE(window().isWindowModified());
    EXPECT_THAT(names(), UnorderedElementsAre("rose.pastoso"));
    EXPECT_EQ(core::read_text_file(path("rose.pastoso")), old);
    EXPECT_EQ(save_version(), "");
    EXPECT_EQ(file(), path("rose_001.pastoso").string());
}

TEST_F(VersionsWindow, APaintingWithoutAFileIsGivenANameFirst) {
    paint();
    answered(QMessageBox::Cancel, [&] { save_version(); });
    EXPECT_EQ(asked_, "file dialog");
    EXPECT_EQ(file(), "");
    EXPECT_TRUE(window().isWindowModified());
}

TEST_F(VersionsWindow, ClosingASavedPaintingLeavesABareCanvasAndTheStartPage) {
    paint();
    save("rose.pastoso");
    action(Command::ClosePainting)->trigger();
    loaded();
    settle();
    EXPECT_EQ(file(), "");
    EXPECT_EQ(volume_mm3(), 0.0);
    EXPECT_EQ(session().canvas(), canvas_settings());
    EXPECT_FALSE(window().isWindowModified());
    EXPECT_TRUE(page_is_shown());
    EXPECT_TRUE(window().isVisible());
}

TEST_F(VersionsWindow, ClosingAsksForWhatIsNotSaved) {
    paint();
    const std::uint64_t before = state();
    answered(QMessageBox::Cancel, [&] { action(Command::ClosePainting)->trigger(); });
    EXPECT_THAT(asked_, HasSubstr("not saved"));
    loaded();
    EXPECT_EQ(state(), before);
    EXPECT_FALSE(page_is_shown());
}

}  // namespace
}  // namespace pastoso::tests
