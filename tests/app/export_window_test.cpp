// The dialog for exports, and what the window makes of it while it is painted on.
#include "app/window_fixture.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "dialogs/export_dialog.hpp"
#include "files/image.hpp"
#include "files/video_file.hpp"
#include "main/window_parts.hpp"
#include "panels/parts/work_progress.hpp"

#include <cstdlib>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QStatusBar>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using dialogs::ExportDialog;
using testing::HasSubstr;
using testing::StartsWith;
using tools::ExportForm;

class ExportWindow : public WindowTest {
  protected:
    void SetUp() override {
        search_path_ = std::getenv("PATH");
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        action(Command::Pause)->trigger();
        stroke(20.0);
    }
    void TearDown() override {
        ::setenv("PATH", search_path_.c_str(), 1);
        WindowTest::TearDown();
    }

    void stroke(double y_mm) {
        mouse_stroke(line_mm({12.0, y_mm}, {48.0, y_mm}));
        settle();
    }

    std::filesystem::path path(const char* name) const { return folder_.path() / name; }
    std::string text(const char* name) const { return core::read_text_file(path(name)); }

    // ---- the dialog

    ExportDialog* dialog() { return window().findChild<ExportDialog*>(); }
    void open() {
        action(Command::Export)->trigger();
        ASSERT_NE(dialog(), nullptr);
        QApplication::setActiveWindow(dialog());
    }
    template <class Widget>
    Widget& part(const char* name) {
        auto* found = dialog()->findChild<Widget*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    void choose(const char* box, int row) {
        part<QComboBox>(box).setCurrentIndex(row);
        Q_EMIT part<QComboBox>(box).activated(row);
    }
    void choose(ExportForm form) { choose("form", static_cast<int>(form)); }
    void type_name(const std::string& name) {
        auto& line = part<QLineEdit>("path");
        line.setFocus();
        line.selectAll();
        QTest::keyClicks(&line, QString::fromStdString(name));
    }
    std::string name() { return part<QLineEdit>("path").text().toStdString(); }
    std::string outcome() { return part<QLabel>("outcome").text().remove(QChar(0x200B)).toStdString(); }
    QPushButton& ok() { return *dialog()->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok); }
    bool shows(const char* name) { return part<QWidget>(name).isVisible(); }
    /// Of what stands in the dialog itself.
    void expect_no_overlap() {
        QApplication::processEvents();
        std::vector<QWidget*> seen;
        for (QWidget* one : dialog()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            if (!one->isVisible()) continue;
            const std::string name = one->objectName().toStdString();
            EXPECT_TRUE(dialog()->rect().contains(one->geometry())) << name;
            EXPECT_GE(one->height(), one->minimumSizeHint().height()) << name;
            for (const QWidget* other : seen)
                EXPECT_FALSE(one->geometry().intersects(other->geometry())) << name;
            seen.push_back(one);
        }
        EXPECT_GT(seen.size(), 6U);
    }
    void cancel() {
        dialog()->reject();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }

    // ---- the export

    void wait() {
        wait_for([this] { return !parts().exporting.exporter().busy(); });
    }
    tools::ExportSettings large_picture() const {
        tools::ExportSettings settings;
        settings.scale = 64.0;
        return settings;
    }
    QWidget& progress() {
        return *window().findChild<panels::WorkProgress*>(QStringLiteral("export_progress"));
    }
    QProgressBar& bar() { return *progress().findChild<QProgressBar*>(QStringLiteral("work_done")); }

    /// Answers the next message box by the button with these words, and keeps what it said.
    void answer_box(const char* words) {
        auto* poll = new QTimer(&window());
        QObject::connect(poll, &QTimer::timeout, &window(), [this, poll, words] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box == nullptr) return;
            poll->stop();
            poll->deleteLater();
            asked_ = box->text().toStdString();
            for (QAbstractButton* button : box->buttons())
                if (button->text().remove(QLatin1Char('&')) == QLatin1String(words))
                    return button->click();
            ADD_FAILURE() << "no button " << words;
            box->reject();
        });
        poll->start(10);
    }

    TemporaryFolder folder_;
    std::string asked_, search_path_;
};

// ---- what the dialog offers and says

TEST_F(ExportWindow, EveryKindHasItsOwnOptions) {
    open();
    const auto visible = [&](std::initializer_list<const char*> names) {
        for (const char* box : {"quality", "surface", "scale", "colours", "lit", "base_mm",
                                "exaggeration", "resolution_mm", "speed", "fps"}) {
            const bool wanted = std::find_if(names.begin(), names.end(), [&](const char* one) {
                                    return std::string(one) == box;
                                }) != names.end();
            EXPECT_EQ(shows(box), wanted) << box;
        }
        expect_no_overlap();
    };
    choose(ExportForm::Picture);
    choose("format", 0);
    visible({"surface", "scale", "colours", "lit"});
    choose("format", 2);
    visible({"quality", "surface", "scale", "colours", "lit"});
    choose(ExportForm::Layers);
    visible({"scale", "colours", "lit"});
    EXPECT_FALSE(shows("format")) << "there is no choice";
    choose(ExportForm::Maps);
    visible({"scale", "colours"});
    choose(ExportForm::Relief);
    visible({"base_mm", "exaggeration", "resolution_mm"});
    choose(ExportForm::Timelapse);
    choose("format", 0);
    visible({"scale", "colours", "lit", "speed", "fps"});
    choose(ExportForm::Picture);
    visible({"quality", "surface", "scale", "colours", "lit"});
    choose(ExportForm::Timelapse);
    choose("format", 2);
    visible({"scale", "lit", "speed", "fps"});
    for (const QWidget* box : dialog()->findChildren<QWidget*>()) {
        const bool chooses = qobject_cast<const QComboBox*>(box) != nullptr ||
                             qobject_cast<const QAbstractSpinBox*>(box) != nullptr;
        EXPECT_TRUE(!chooses || !box->toolTip().isEmpty()) << box->objectName().toStdString();
    }
}

TEST_F(ExportWindow, TheNameEndsAsTheFormatDoes) {
    open();
    type_name(path("sun").string());
    EXPECT_EQ(dialog()->path(), path("sun.png"));
    choose("format", 2);
    EXPECT_EQ(name(), path("sun.jpg").string());
    choose(ExportForm::Relief);
    EXPECT_EQ(name(), path("sun.stl").string());
    choose(ExportForm::Timelapse);
    EXPECT_EQ(name(), path("sun").string());
    choose(ExportForm::Picture);
    type_name(path("moon.tif").string());
    EXPECT_EQ(part<QComboBox>("format").currentText().toStdString(), "TIFF, 8 bits");
    EXPECT_EQ(dialog()->settings().format().depth_bits, 8);
    type_name("moon.webp");
    EXPECT_TRUE(dialog()->path().is_absolute());
    EXPECT_EQ(dialog()->path().filename(), "moon.webp");
}

TEST_F(ExportWindow, TheSizeIsToldInPixelsAndMillimetres) {
    open();
    type_name(path("a.png").string());
    EXPECT_EQ(outcome(), "240 × 160 pixels for 60 × 40 mm, which is 102 pixels per inch.");
    part<QDoubleSpinBox>("scale").setValue(2.5);
    EXPECT_EQ(part<QSpinBox>("width").value(), 600);
    EXPECT_THAT(outcome(), StartsWith("600 × 400 pixels for 60 × 40 mm"));
    part<QSpinBox>("width").setValue(1000);
    EXPECT_THAT(outcome(), StartsWith("1000 × 667 pixels"));
    EXPECT_DOUBLE_EQ(dialog()->settings().scale, 1000.0 / 240.0) << "not as it is rounded to be shown";
    choose("surface", 1);
    part<QDoubleSpinBox>("scale").setValue(1.0);
    EXPECT_THAT(outcome(), StartsWith("360 × 270 pixels for 120 × 90 mm, which is 76 "));
    choose(ExportForm::Maps);
    EXPECT_EQ(outcome(), "Four files of 240 × 160 pixels, a-basecolor.png to a-roughness.png.");
    choose(ExportForm::Relief);
    EXPECT_EQ(outcome(), "A solid of 60 × 40 mm; its front has 241 × 161 points, 0.25 mm apart.");
    choose(ExportForm::Timelapse);
    EXPECT_THAT(outcome(), HasSubstr(" of painting become "));
    EXPECT_THAT(outcome(), HasSubstr(" frames of 240 × 160 pixels."));
}

TEST_F(ExportWindow, WhatCannotBeIsToldAndNotExported) {
    open();
    type_name(path("a.png").string());
    EXPECT_TRUE(ok().isEnabled());
    type_name(path("none/a.png").string());
    EXPECT_EQ(outcome(), "There is no folder " + path("none").string() + ".");
    EXPECT_FALSE(ok().isEnabled());
    type_name(" ");
    EXPECT_EQ(outcome(), "The file needs a name.");
    EXPECT_FALSE(ok().isEnabled());
    std::filesystem::create_directory(path("b.png"));
    type_name(path("b.png").string());
    EXPECT_EQ(outcome(), "b.png: is a folder, not a file.");
    EXPECT_FALSE(ok().isEnabled());

    type_name(path("a.webp").string());
    part<QSpinBox>("width").setValue(15360);
    EXPECT_TRUE(ok().isEnabled());
    choose("surface", 1);
    part<QDoubleSpinBox>("scale").setValue(50.0);
    EXPECT_EQ(outcome(),
              "a.webp: .webp files hold at most 16383 pixels a side; this picture has 18000 x 13500.");
    EXPECT_FALSE(ok().isEnabled());
    choose("format", 0);
    EXPECT_TRUE(ok().isEnabled());
    choose("surface", 0);

    choose(ExportForm::Relief);
    part<QDoubleSpinBox>("resolution_mm").setValue(0.005);
    EXPECT_THAT(outcome(), HasSubstr("A relief of 12001 x 8001 points is more than the 25 million"));
    EXPECT_FALSE(ok().isEnabled());
    part<QDoubleSpinBox>("resolution_mm").setValue(0.0);
    EXPECT_TRUE(ok().isEnabled());
}

TEST_F(ExportWindow, VideosAreThereWhereFfmpegIs) {
    ::setenv("PATH", folder_.path().c_str(), 1);
    open();
    choose(ExportForm::Timelapse);
    type_name(path("film").string());
    EXPECT_TRUE(ok().isEnabled());
    choose("format", 2);
    EXPECT_THAT(outcome(), StartsWith("film.mp4: a video is made by the program ffmpeg, which is not "
                                      "installed"));
    EXPECT_FALSE(ok().isEnabled());
    cancel();
    core::write_text_file(path("ffmpeg"), "#!/bin/sh\n");
    std::filesystem::permissions(path("ffmpeg"), std::filesystem::perms::owner_all);
    open();
    choose(ExportForm::Timelapse);
    type_name(path("film.mp4").string());
    EXPECT_TRUE(ok().isEnabled());
}

TEST_F(ExportWindow, ATimeLapseOfNothingIsNotMade) {
    parts().files.new_canvas(canvas_settings());
    loaded();
    open();
    choose(ExportForm::Timelapse);
    type_name(path("film").string());
    EXPECT_EQ(outcome(), "Nothing has been painted yet that a film could show.");
    EXPECT_FALSE(ok().isEnabled());
}

TEST_F(ExportWindow, AFileThatIsThereIsReplacedOnDemandAlone) {
    core::write_text_file(path("a.png"), "old");
    std::filesystem::create_directory(path("film"));
    core::write_text_file(path("film/frame-00001.png"), "old");
    open();
    type_name(path("a.png").string());
    EXPECT_EQ(ok().text().toStdString(), "Replace");
    type_name(path("b.png").string());
    EXPECT_EQ(ok().text().toStdString(), "Export");
    choose(ExportForm::Timelapse);
    type_name(path("film").string());
    EXPECT_EQ(outcome(), "The folder film holds the frames of another time-lapse; name another one.");
    EXPECT_FALSE(ok().isEnabled());
}

// ---- the whole way

TEST_F(ExportWindow, KeysAloneMakeAPictureOfTheWantedSize) {
    QTest::keyClick(&canvas(), Qt::Key_E, Qt::ControlModifier | Qt::AltModifier);
    ASSERT_NE(dialog(), nullptr);
    wait_until_shown(*dialog());
    QApplication::setActiveWindow(dialog());
    const auto keys = [](const std::string& text) {
        QTest::keyClicks(QApplication::focusWidget(), QString::fromStdString(text));
    };
    const auto key = [](Qt::Key pressed, Qt::KeyboardModifiers with = {}) {
        QTest::keyClick(QApplication::focusWidget(), pressed, with);
    };
    key(Qt::Key_A, Qt::ControlModifier);
    keys(path("keys").string());
    key(Qt::Key_O, Qt::AltModifier);
    key(Qt::Key_Down);
    key(Qt::Key_S, Qt::AltModifier);
    key(Qt::Key_A, Qt::ControlModifier);
    keys("2");
    key(Qt::Key_Return);
    ASSERT_TRUE(parts().exporting.exporter().busy());
    wait();
    QFile file(QString::fromStdString(path("keys.png").string()));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray head = file.read(26);
    EXPECT_EQ(head.mid(16, 8), QByteArray::fromHex("000001e000000140")) << "480 × 320";
    EXPECT_EQ(head[24], 16) << "bits";
    EXPECT_EQ(told(), "Exported keys.png: 480 × 320 pixels.");
}

TEST_F(ExportWindow, PaintingGoesOnWhileAnExportIsWritten) {
    core::write_text_file(path("a.png"), "old");
    parts().exporting.start(large_picture(), path("a.png"));
    EXPECT_TRUE(action(Command::StopExport)->isEnabled());
    EXPECT_TRUE(progress().isVisible());
    const double volume = volume_mm3();
    stroke(10.0);
    EXPECT_GT(volume_mm3(), volume);
    ASSERT_TRUE(parts().exporting.exporter().busy()) << "157 million pixels take longer than a stroke";
    action(Command::Export)->trigger();
    EXPECT_EQ(dialog(), nullptr);
    EXPECT_EQ(told(), "a.png is still being written; wait for it, or stop it.");
    QTest::mouseClick(progress().findChild<QToolButton*>(QStringLiteral("stop_work")), Qt::LeftButton);
    wait();
    EXPECT_EQ(text("a.png"), "old");
    EXPECT_EQ(told(), "Stopped; a.png was not written.");
    EXPECT_FALSE(progress().isVisible());
    EXPECT_FALSE(action(Command::StopExport)->isEnabled());
}

TEST_F(ExportWindow, AnExportShowsThePaintingAsItWasThen) {
    tools::ExportSettings settings;
    parts().exporting.start(settings, path("before.png"));
    wait();
    settings.scale = 8.0;
    parts().exporting.start(settings, path("large.png"));
    stroke(36.0);
    wait();
    settings.scale = 1.0;
    parts().exporting.start(settings, path("after.png"));
    wait();
    EXPECT_NE(text("before.png"), text("after.png"));
    const auto at = [&](const char* name, int x, int y) {
        const files::GreyImage picture = files::read_grey_image(path(name));
        return picture.values[static_cast<std::size_t>(y * picture.width + x)];
    };
    EXPECT_LT(at("after.png", 120, 144), 0.7F * at("before.png", 120, 144));
    EXPECT_NEAR(at("large.png", 8 * 120, 8 * 144), at("before.png", 120, 144), 0.1);
}

TEST_F(ExportWindow, TheLookOfTheViewIsNotInTheFile) {
    stroke(10.0);
    const QImage lit_view = picture();
    const auto exported = [&](Command look, ExportForm form) {
        action(look)->trigger();
        EXPECT_EQ(difference(picture(), lit_view).largest > 30, look != Command::LookLit);
        tools::ExportSettings settings;
        settings.form = form;
        parts().exporting.start(settings, path(form == ExportForm::Relief ? "one.stl" : "one.png"));
        wait();
        return text(form == ExportForm::Relief ? "one.stl" : "one.png");
    };
    for (const ExportForm form : {ExportForm::Picture, ExportForm::Relief}) {
        const std::string lit = exported(Command::LookLit, form);
        ASSERT_FALSE(lit.empty());
        for (const Command look :
             {Command::LookWet, Command::LookHeight, Command::LookNormals, Command::LookFlat})
            EXPECT_TRUE(exported(look, form) == lit) << action(look)->text().toStdString();
    }
}

TEST_F(ExportWindow, ExportAgainNeedsNoDialog) {
    EXPECT_FALSE(action(Command::ExportAgain)->isEnabled());
    tools::ExportSettings settings;
    settings.scale = 0.5;
    parts().exporting.start(settings, path("a.png"));
    wait();
    const std::string first = text("a.png");
    stroke(10.0);
    QTest::keyClick(&canvas(), Qt::Key_R, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_EQ(dialog(), nullptr);
    wait();
    EXPECT_NE(text("a.png"), first);
    EXPECT_EQ(files::read_grey_image(path("a.png")).width, 120);
    open();
    EXPECT_EQ(name(), path("a.png").string());
    EXPECT_EQ(ok().text().toStdString(), "Replace");
    cancel();
    parts().files.new_canvas(canvas_settings());
    loaded();
    EXPECT_FALSE(action(Command::ExportAgain)->isEnabled()) << "that was another painting";
    open();
    EXPECT_EQ(name(), path("painting.png").string()) << "beside the last one";
}

TEST_F(ExportWindow, AFilmOfThePaintingIsMadeAgainIntoAFolderOfItsOwn) {
    tools::ExportSettings settings;
    settings.form = ExportForm::Timelapse;
    settings.fps = 2.0;
    parts().exporting.start(settings, path("film"));
    wait();
    EXPECT_THAT(told(), HasSubstr(" frames of 240 × 160 pixels."));
    EXPECT_TRUE(std::filesystem::exists(path("film/frame-00001.png")));
    action(Command::ExportAgain)->trigger();
    wait();
    EXPECT_TRUE(std::filesystem::exists(path("film-2/frame-00001.png")));
    action(Command::ExportAgain)->trigger();
    wait();
    EXPECT_TRUE(std::filesystem::exists(path("film-3/frame-00001.png")));
}

TEST_F(ExportWindow, WhatGoesWrongIsTold) {
    parts().exporting.start({}, path("none/a.png"));
    wait_for([this] { return !studio().messages().standing().empty(); });
    EXPECT_THAT(studio().messages().standing().front().sentence.toStdString(),
                HasSubstr(path("none/a.png").string() + ": cannot be written"));
    EXPECT_FALSE(parts().exporting.exporter().busy());
}

TEST_F(ExportWindow, TheLastChoicesAreThereAgain) {
    open();
    choose(ExportForm::Relief);
    type_name(path("a.obj").string());
    part<QDoubleSpinBox>("base_mm").setValue(4.5);
    dialog()->accept();
    wait();
    EXPECT_TRUE(std::filesystem::exists(path("a.obj")));
    open_another();
    open();
    EXPECT_EQ(dialog()->settings().form, ExportForm::Relief);
    EXPECT_EQ(part<QDoubleSpinBox>("base_mm").value(), 4.5);
    EXPECT_EQ(name(), path("painting.obj").string());
    cancel();

    const std::filesystem::path file = settings_file().parent_path() / "export.json";
    core::write_text_file(file, "{\"version\": 1, \"form\": 3}");
    open_another();
    EXPECT_THAT(told(), HasSubstr("export.json"));
    open();
    EXPECT_EQ(dialog()->settings(), tools::ExportSettings{});
}

// ---- closing

TEST_F(ExportWindow, ClosingMayWaitForTheExport) {
    parts().files.save_painting(QString::fromStdString(path("a.pastoso").string()));
    ASSERT_EQ(parts().files.saver().wait(), "");
    tools::ExportSettings settings;
    settings.scale = 8.0;
    parts().exporting.start(settings, path("a.png"));
    answer_box("Close when it is done");
    EXPECT_FALSE(window().close());
    EXPECT_EQ(asked_, "a.png is still being written.");
    EXPECT_TRUE(window().isVisible());
    EXPECT_EQ(told(), "The window closes as soon as a.png is written.");
    wait_for([this] { return !window().isVisible(); });
    EXPECT_EQ(files::read_grey_image(path("a.png")).width, 8 * 240);
}

TEST_F(ExportWindow, ClosingMayStopTheExportOrBeGivenUp) {
    parts().files.save_painting(QString::fromStdString(path("a.pastoso").string()));
    ASSERT_EQ(parts().files.saver().wait(), "");
    parts().exporting.start(large_picture(), path("a.png"));
    answer_box("Cancel");
    EXPECT_FALSE(window().close());
    EXPECT_TRUE(parts().exporting.exporter().busy());
    answer_box("Stop it");
    EXPECT_TRUE(window().close());
    wait();
    EXPECT_FALSE(std::filesystem::exists(path("a.png")));
}

// ---- copies in layers

TEST_F(ExportWindow, ACopyInLayersIsWrittenWhileOnePaintsOn) {
    action(Command::AddLayer)->trigger();
    stroke(30.0);
    for (const char* name : {"copy.ora", "copy.psd"}) {
        parts().exporting.start_copy(path(name));
        stroke(35.0);
        wait();
        EXPECT_THAT(told(), StartsWith("Saved " + std::string(name) + ": 3 layers of ")) << told();
        EXPECT_GT(std::filesystem::file_size(path(name)), 10000U);
    }
    EXPECT_EQ(files::read_colour_image(path("copy.psd")).width, session().snapshot()->film.shape.width);
    EXPECT_FALSE(action(Command::ExportAgain)->isEnabled()) << "that is of exports";
    EXPECT_TRUE(window().isWindowModified()) << "the painting itself is not saved";
}

TEST_F(ExportWindow, ACopyIsRefusedBeforeItIsMade) {
    answer_box("OK");
    parts().exporting.start_copy(path("missing") / "copy.ora");
    EXPECT_THAT(asked_, HasSubstr("copy.ora"));
    EXPECT_FALSE(parts().exporting.exporter().busy());
}

}  // namespace
}  // namespace pastoso::tests
