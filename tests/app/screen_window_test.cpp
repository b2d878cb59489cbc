// The canvas on drivers that hold little, fail or are lost.
#include "app/gl_faults.hpp"
#include "app/window_fixture.hpp"
#include "interactions/on_canvas.hpp"

#include <QAction>
#include <QOpenGLContext>
#include <QOpenGLWidget>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using screen::Look;
using ::testing::HasSubstr;

constexpr std::pair<Look, Command> kLooks[] = {{Look::Lit, Command::LookLit},
                                               {Look::Wet, Command::LookWet},
                                               {Look::Height, Command::LookHeight},
                                               {Look::Normals, Command::LookNormals},
                                               {Look::Flat, Command::LookFlat}};

/// Of 255 levels: the processor looks at thicknesses in the middle of a pixel, draws no soft edge of a
/// canvas and smooths a turned one. Steps of colour (Look::Height) differ most.
constexpr double kMean = 0.75;

class ScreenTest : public WindowTest {
  protected:
    screen::DrawnBy drawn_by() const override { return screen::DrawnBy::OpenGl; }

    void TearDown() override {
        gl_faults() = {};
        WindowTest::TearDown();
    }

    void give(Command command) { action(command)->trigger(); }

    /// Two strokes across each other that lie still.
    void paint() {
        give(Command::Pause);
        mouse_stroke(line_mm({8.0, 6.0}, {48.0, 33.0}));
        mouse_stroke(line_mm({50.0, 10.0}, {12.0, 28.0}));
    }

    /// The same painting in another context, as the driver is now: in a window of its own and back.
    void begin_anew() {
        bool ended = false;
        QObject::connect(canvas().opengl()->context(), &QOpenGLContext::aboutToBeDestroyed, &canvas(),
                         [&ended] { ended = true; });
        QWidget* home = canvas().parentWidget();
        const QSize size = canvas().size();
        QWidget other;
        put_canvas_into(other);
        put_canvas_back(*home, size);
        ASSERT_TRUE(ended);
    }

    /// From far, from near, turned, mirrored.
    std::vector<screen::ViewTransform> some_views() {
        screen::ViewTransform far = canvas().view_transform(), near = far, turned = far, mirrored = far;
        far.zoom = 0.4;
        near = screen::zoomed(far, {150.0, 120.0}, 14.0);
        turned = screen::turned(canvas().view_transform(), 0.5 * canvas().window_px(), 23.0);
        mirrored = screen::mirrored(turned, canvas().window_px());
        return {canvas().view_transform(), far, near, turned, mirrored};
    }

    std::vector<QImage> pictures(const std::vector<screen::ViewTransform>& views) {
        std::vector<QImage> seen;
        for (const auto& [look, command] : kLooks) {
            give(command);
            for (const screen::ViewTransform& view : views) {
                canvas().set_view(view);
                seen.push_back(picture());
            }
        }
        give(Command::LookLit);
        canvas().set_view(views.front());
        return seen;
    }

    std::vector<panels::StandingMessage> messages() { return studio().messages().standing(); }
    std::string sentence() { return messages().front().sentence.toStdString(); }

    void expect_processor_draws() {
        wait_for([&] { return canvas().opengl() == nullptr; });
        ASSERT_EQ(messages().size(), 1U);
        EXPECT_EQ(messages().front().matter, panels::Matter::Screen);
    }
};

/// In a small window: every page is drawn anew in every picture.
class PagesTest : public ScreenTest {
  protected:
    void SetUp() override {
        ScreenTest::SetUp();
        home_ = canvas().parentWidget();
        home_size_ = canvas().size();
        stand_ = std::make_unique<QWidget>();
        put_canvas_into(*stand_);
        stand_->resize(320, 240);
        wait_for([&] { return canvas().size() == stand_->size(); });
        canvas().fit();
    }

    void TearDown() override {
        put_canvas_back(*home_, home_size_);
        ScreenTest::TearDown();
    }

  private:
    std::unique_ptr<QWidget> stand_;
    QWidget* home_ = nullptr;
    QSize home_size_;
};

TEST_F(PagesTest, ACanvasInPagesIsTheOneInOne) {
    paint();
    const auto views = some_views();
    const std::vector<QImage> in_one = pictures(views);
    for (const int largest : {64, 101}) {
        gl_faults().largest_texture = largest;
        begin_anew();
        canvas().set_view(views.front());
        const std::vector<QImage> in_pages = pictures(views);
        for (std::size_t i = 0; i < in_one.size(); ++i)
            EXPECT_EQ(difference(in_one[i], in_pages[i]).largest, 0) << largest << ", picture " << i;
    }
    EXPECT_NE(canvas().opengl(), nullptr);
}

TEST_F(PagesTest, PaintCrossesTheBordersOfPages) {
    gl_faults().largest_texture = 77;
    begin_anew();
    paint();
    const auto views = some_views();
    const std::vector<QImage> painted = pictures(views);
    gl_faults().largest_texture = 0;
    begin_anew();
    canvas().set_view(views.front());
    const std::vector<QImage> anew = pictures(views);
    for (std::size_t i = 0; i < anew.size(); ++i)
        EXPECT_EQ(difference(painted[i], anew[i]).largest, 0) << "picture " << i;
}

TEST(DrawnBy, TheProcessorDrawsWhereThatIsFasterOrTheOnlyWay) {
    using screen::DrawnBy;
    const graphics::OpenGlSupport card{}, software{.software = true}, none{.problem = "none"};
    constexpr double kOrdinary = 4e6, kHuge = 8192.0 * 8192.0;
    EXPECT_FALSE(drawn_by_processor(DrawnBy::Fastest, card, kOrdinary));
    EXPECT_TRUE(drawn_by_processor(DrawnBy::Fastest, card, kHuge));
    EXPECT_FALSE(drawn_by_processor(DrawnBy::OpenGl, card, kHuge));
    EXPECT_TRUE(drawn_by_processor(DrawnBy::Fastest, software, kOrdinary));
    EXPECT_FALSE(drawn_by_processor(DrawnBy::OpenGl, software, kHuge));
    EXPECT_TRUE(drawn_by_processor(DrawnBy::OpenGl, none, kOrdinary));
    EXPECT_TRUE(drawn_by_processor(DrawnBy::Processor, card, kOrdinary));
}

TEST_F(ScreenTest, WithoutMemoryTheProcessorDrawsTheSame) {
    paint();
    const auto views = some_views();
    const std::vector<QImage> by_card = pictures(views);
    gl_faults().out_of_memory = true;
    begin_anew();
    expect_processor_draws();
    EXPECT_THAT(sentence(), HasSubstr("memory does not suffice"));
    canvas().set_view(views.front());
    const std::vector<QImage> by_processor = pictures(views);
    for (std::size_t i = 0; i < by_card.size(); ++i)
        EXPECT_LT(difference(by_card[i], by_processor[i]).mean, kMean) << "picture " << i;
}

TEST_F(ScreenTest, PaintingGoesOnWhereTheProcessorDraws) {
    gl_faults().out_of_memory = true;
    begin_anew();
    expect_processor_draws();
    const QImage bare = picture();
    paint();
    const QImage painted = picture();
    EXPECT_GT(difference(bare, painted).mean, 1.0);
    canvas().look_from(screen::zoomed(canvas().view_transform(), {100.0, 100.0}, 1.7));
    canvas().fit();
    EXPECT_EQ(difference(picture(), painted).largest, 0);
    give(Command::Undo);
    give(Command::Undo);
    EXPECT_EQ(difference(picture(), bare).largest, 0);
}

TEST_F(ScreenTest, ACardThatWasResetIsLeft) {
    paint();
    const QImage before = picture();
    gl_faults().reset = true;
    canvas().refresh();
    expect_processor_draws();
    EXPECT_THAT(sentence(), HasSubstr("reset"));
    EXPECT_LT(difference(picture(), before).mean, kMean);
}

}  // namespace
}  // namespace pastoso::tests
