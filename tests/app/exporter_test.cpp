// Exports of a painting on a thread of their own: what they write, and what they leave alone.
#include "commands/exporter.hpp"

#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "document/painting.hpp"
#include "files/image.hpp"
#include "files/video_file.hpp"
#include "patience.hpp"

#include <optional>

#include <QCoreApplication>
#include <QTest>
#include <gmock/gmock.h>

namespace pastoso::commands {
namespace {

using namespace document;
using testing::EndsWith;
using testing::HasSubstr;
using Path = std::filesystem::path;

constexpr const char* kNoVideos = "packaging/install.sh test installs ffmpeg, which makes videos";

CanvasSettings small_canvas() {
    CanvasSettings canvas;
    canvas.width_mm = 40.0;
    canvas.height_mm = 30.0;
    canvas.px_per_mm = 2.0;
    return canvas;
}

/// One stroke from left to right, and a second for it to run.
Recording recorded_stroke() {
    Recording recording;
    recording.canvas = small_canvas();
    LoadPaint dip;
    dip.paint.ingredients = {{"PB29", 1.0}};
    recording.events = {
        {0, UseMedium{"soft-body acrylic"}}, {0, TakeBrush{"Flat bristle 20", 8.0, 1}}, {0, dip}};
    const auto sample = [](double x_mm) {
        return brush::PenSample{.time_s = 0.01 * x_mm, .x_mm = x_mm, .y_mm = 15.0};
    };
    recording.events.push_back({1, PenDown{sample(6.0)}});
    for (int x = 7; x <= 34; ++x)
        recording.events.push_back({1, PenMove{sample(x)}});
    recording.events.push_back({1, PenUp{}});
    recording.end_tick = 60;
    return recording;
}

PaintingState painted(const Recording& recording) {
    core::ThreadPool pool(2);
    Painting painting(recording.canvas, pool);
    for (const Event& event : recording.events)
        painting.apply(event.action);
    return painting.state();
}

class ExporterTest : public ::testing::Test {
  protected:
    ExporterTest() {
        static int argc = 1;
        static char name[] = "app_commands_test";
        static char* argv[] = {name, nullptr};
        if (QCoreApplication::instance() == nullptr) new QCoreApplication(argc, argv);
        QObject::connect(&exporter_, &Exporter::finished, &exporter_,
                         [this](const ExportOutcome& outcome) { outcome_ = outcome; });
        QObject::connect(&exporter_, &Exporter::progressed, &exporter_,
                         [this](double done) { shares_.push_back(done); });
    }

    Path path(const char* name) const { return folder_.path() / name; }

    recordings::ExportChoice choice(recordings::ExportKind kind, const char* name) const {
        recordings::ExportChoice choice;
        choice.kind = kind;
        choice.path = path(name);
        return choice;
    }
    recordings::TimelapseChoice film(const char* name) const {
        recordings::TimelapseChoice choice;
        choice.path = path(name);
        choice.fps = 10.0;
        choice.speed = 1.0;
        return choice;
    }

    void start(const recordings::ExportChoice& choice) {
        exporter_.start({painted(stroke_), {}, choice});
    }
    void start(const recordings::TimelapseChoice& choice) {
        exporter_.start({{}, document::Recorder(stroke_), choice});
    }
    ExportOutcome ended() {
        constexpr int kPatience_ms = std::chrono::milliseconds(tests::kPatience).count();
        EXPECT_TRUE(QTest::qWaitFor([this] { return outcome_.has_value(); }, kPatience_ms));
        EXPECT_FALSE(exporter_.busy());
        return outcome_.value_or(ExportOutcome{});
    }
    template <class Choice>
    ExportOutcome exported(const Choice& choice) {
        outcome_.reset();
        start(choice);
        EXPECT_TRUE(exporter_.busy());
        EXPECT_EQ(exporter_.path(), choice.path);
        return ended();
    }
    template <class Choice>
    void expect_written(const Choice& choice) {
        const ExportOutcome outcome = exported(choice);
        EXPECT_EQ(outcome.error.text(), "");
        EXPECT_EQ(outcome.status(), files::ExportStatus::Written);
        EXPECT_EQ(outcome.path, choice.path);
    }

    std::ptrdiff_t files() const {
        return std::distance(std::filesystem::directory_iterator(folder_.path()), {});
    }

    tests::TemporaryFolder folder_;
    Recording stroke_ = recorded_stroke();
    Exporter exporter_;
    std::optional<ExportOutcome> outcome_;
    std::vector<double> shares_;
};

TEST_F(ExporterTest, PicturesAreReadableInEveryFormat) {
    for (const char* name : {"a.png", "a.jpg", "a.tif", "a.webp", "a.exr"}) {
        recordings::ExportChoice picture = choice(recordings::ExportKind::Picture, name);
        picture.scale = 1.5;
        expect_written(picture);
        const pigment::LinearImage back = files::read_colour_image(path(name));
        EXPECT_EQ(back.width, 120) << name;
        EXPECT_EQ(back.height, 90) << name;
        const auto at = [&](int x, int y) {
            return back.rgb[static_cast<std::size_t>(3 * (y * back.width + x))];
        };
        EXPECT_LT(at(60, 45), 0.5F * at(60, 5)) << name << ": ultramarine on a white ground";
    }
}

TEST_F(ExporterTest, LayersMapsAndReliefsAreWritten) {
    expect_written(choice(recordings::ExportKind::Layers, "layers.exr"));
    const std::string layers = core::read_text_file(path("layers.exr"));
    EXPECT_THAT(layers, testing::StartsWith("\x76\x2f\x31\x01")) << "OpenEXR's first bytes";
    EXPECT_THAT(layers, HasSubstr(".height_mm.V"));
    expect_written(choice(recordings::ExportKind::Maps, "set.png"));
    for (const char* name :
         {"set-basecolor.png", "set-normal.png", "set-height.png", "set-roughness.png"})
        EXPECT_EQ(files::read_grey_image(path(name)).height, 60) << name;
    for (const char* name : {"a.stl", "a.ply", "a.obj"}) {
        const ExportOutcome outcome = exported(choice(recordings::ExportKind::Relief, name));
        EXPECT_EQ(outcome.error.text(), "");
        const auto& report = std::get<recordings::ExportReport>(outcome.report);
        EXPECT_GT(report.triangles, 2U * 80U * 60U);
        EXPECT_GT(std::filesystem::file_size(path(name)), 12 * report.triangles) << name;
    }
}

TEST_F(ExporterTest, ATimeLapseIsPaintedOnceMore) {
    expect_written(film("frames"));
    const auto& report = std::get<recordings::TimelapseReport>(outcome_->report);
    EXPECT_EQ(report.frames, 11U);
    EXPECT_EQ(report.written, 11U);
    EXPECT_EQ(files::read_grey_image(path("frames/frame-00011.png")).width, 80);
    EXPECT_NE(core::read_text_file(path("frames/frame-00001.png")),
              core::read_text_file(path("frames/frame-00011.png")));
}

TEST_F(ExporterTest, AVideoIsMadeWhereFfmpegIs) {
    ASSERT_FALSE(files::find_program("ffmpeg").empty()) << kNoVideos;
    expect_written(film("film.mkv"));
    EXPECT_THAT(core::read_text_file(path("film.mkv")), HasSubstr("matroska"));
}

// ---- what is stopped, or fails

TEST_F(ExporterTest, WhatIsStoppedLeavesEveryFileAsItWas) {
    recordings::ExportChoice large[] = {choice(recordings::ExportKind::Picture, "a.png"),
                                        choice(recordings::ExportKind::Layers, "a.exr"),
                                        choice(recordings::ExportKind::Maps, "a.tif"),
                                        choice(recordings::ExportKind::Relief, "a.stl")};
    const char* files_of[] = {"a.png", "a.exr", "a-height.tif", "a.stl"};
    for (int i = 0; i < 4; ++i) {
        // Bands by the dozen, and millions of points.
        large[i].scale = 64.0;
        large[i].relief.resolution_mm = 0.01;
        core::write_text_file(path(files_of[i]), "old");
        const auto before = files();
        outcome_.reset();
        start(large[i]);
        exporter_.stop();
        const ExportOutcome outcome = ended();
        EXPECT_EQ(outcome.error.text(), "");
        EXPECT_EQ(outcome.status(), files::ExportStatus::Stopped) << files_of[i];
        EXPECT_EQ(core::read_text_file(path(files_of[i])), "old");
        EXPECT_EQ(files(), before) << files_of[i];
    }
}

TEST_F(ExporterTest, AStoppedVideoLeavesTheOldOne) {
    ASSERT_FALSE(files::find_program("ffmpeg").empty()) << kNoVideos;
    core::write_text_file(path("film.mp4"), "old");
    stroke_.end_tick = 100000;
    recordings::TimelapseChoice choice = film("film.mp4");
    choice.scale = 8.0;
    start(choice);
    exporter_.stop();
    EXPECT_EQ(ended().status(), files::ExportStatus::Stopped);
    EXPECT_EQ(core::read_text_file(path("film.mp4")), "old");
    EXPECT_EQ(files(), 1);
}

TEST_F(ExporterTest, WhatIsMidwayIsStoppedWithTheExporter) {
    core::write_text_file(path("a.png"), "old");
    {
        Exporter passing;
        recordings::ExportChoice picture = choice(recordings::ExportKind::Picture, "a.png");
        picture.scale = 64.0;
        passing.start({painted(stroke_), {}, picture});
    }
    EXPECT_EQ(core::read_text_file(path("a.png")), "old");
    EXPECT_EQ(files(), 1);
}

TEST_F(ExporterTest, WhatCannotBeWrittenIsToldWithItsPlace) {
    const ExportOutcome missing = exported(choice(recordings::ExportKind::Picture, "none/a.png"));
    EXPECT_THAT(missing.error.text(), HasSubstr(path("none/a.png").string() + ": "));
    EXPECT_THAT(missing.error.text(), EndsWith("."));
    const ExportOutcome named = exported(choice(recordings::ExportKind::Relief, "a.png"));
    EXPECT_THAT(named.error.text(), HasSubstr("a.png: a relief is saved as .stl, .ply or .obj"));
    stroke_.events.push_back({2, TakeBrush{"no such brush", 8.0, 2}});
    EXPECT_THAT(exported(film("frames")).error.text(), HasSubstr("the recording, "));
    stroke_.events.pop_back();
    EXPECT_EQ(exported(choice(recordings::ExportKind::Picture, "a.png")).error.text(), "")
        << "it can be used again";
}

TEST_F(ExporterTest, ProgressGoesOnToTheEnd) {
    recordings::ExportChoice picture = choice(recordings::ExportKind::Picture, "a.png");
    picture.scale = 48.0;
    EXPECT_EQ(exported(picture).error.text(), "");
    ASSERT_FALSE(shares_.empty());
    EXPECT_TRUE(std::is_sorted(shares_.begin(), shares_.end()));
    EXPECT_GE(shares_.front(), 0.0);
    EXPECT_LE(shares_.back(), 1.0);
    EXPECT_GT(shares_.back(), 0.0);
}

}  // namespace
}  // namespace pastoso::commands
