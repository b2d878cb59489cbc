// The board of references: in a panel of the window or above it, and kept with the painting.
#include "app/window_fixture.hpp"
#include "commands/command_registry.hpp"
#include "core/text_file.hpp"
#include "files/image.hpp"
#include "main/window_parts.hpp"
#include "panels/references/reference_panel.hpp"
#include "panels/references/reference_places.hpp"
#include "panels/references/reference_view.hpp"

#include <QAction>
#include <QClipboard>
#include <QDockWidget>
#include <QDropEvent>
#include <QGuiApplication>
#include <QMimeData>
#include <QScreen>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QUrl>
#include <QWheelEvent>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using document::Reference;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr pigment::Srgb8 kBlue = {20, 40, 200}, kGreen = {30, 160, 40};

class ReferenceWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        action(Command::Pause)->trigger();
        core::write_text_file(path("photo.png"), files::png_file(halves()));
        action(Command::ReferencesPanel)->trigger();
        wait_for([&] { return board().isVisible() && board().width() > 0; });
    }

    /// Left half blue, right half green.
    static pigment::Picture halves() {
        pigment::Picture picture{40, 20, {}};
        for (int i = 0; i < 800; ++i) {
            const pigment::Srgb8& colour = i % 40 < 20 ? kBlue : kGreen;
            picture.rgba.insert(picture.rgba.end(), {colour[0], colour[1], colour[2], 255});
        }
        return picture;
    }

    std::filesystem::path path(const char* name) const { return folder.path() / name; }
    QString name_of(const char* name) const { return QString::fromStdString(path(name).string()); }
    panels::ReferenceView& board() {
        return *window().findChild<panels::ReferenceView*>(QStringLiteral("reference_board"));
    }
    QDockWidget& dock() { return *window().findChild<QDockWidget*>(QStringLiteral("references_panel")); }
    QAction& button(const char* name) {
        return *window().findChild<QAction*>(QString::fromLatin1(name));
    }

    void add(int times = 1) {
        for (int i = 0; i < times; ++i) {
            parts().references.add_files({name_of("photo.png")});
            loaded();
            settle();
        }
    }
    document::ReferenceBoard kept() {
        settle();
        const auto kept = session().snapshot()->references;
        return kept ? *kept : document::ReferenceBoard{};
    }
    std::vector<document::ReferenceId> order() {
        std::vector<document::ReferenceId> ids;
        for (const Reference& reference : kept().references)
            ids.push_back(reference.id);
        return ids;
    }
    Reference first() { return kept().references.front(); }

    /// Of the first picture, by shares of its width and height.
    QPoint on_first(double x_share, double y_share) {
        const auto corners = panels::corners_mm(first());
        const QPointF place =
            corners[0] + x_share * (corners[1] - corners[0]) + y_share * (corners[3] - corners[0]);
        return board().widget_position(place).toPoint();
    }
    void drag(const QPoint& from, const QPoint& to, Qt::MouseButton button = Qt::LeftButton) {
        const auto send = [&](QEvent::Type type, const QPoint& at, Qt::MouseButtons buttons) {
            QMouseEvent event(type, at, board().mapToGlobal(at), button, buttons, {});
            QApplication::sendEvent(&board(), &event);
        };
        send(QEvent::MouseButtonPress, from, button);
        send(QEvent::MouseMove, 0.5 * (from + to), button);
        send(QEvent::MouseMove, to, button);
        send(QEvent::MouseButtonRelease, to, Qt::NoButton);
    }
    void turn_wheel(const QPoint& at, int notches, Qt::KeyboardModifiers modifiers = {}) {
        QWheelEvent event(at, board().mapToGlobal(at), {}, {0, 120 * notches}, {}, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&board(), &event);
    }
    auto steps() { return session().status().changes; }

    TemporaryFolder folder;
};

TEST_F(ReferenceWindow, APictureThatIsAddedIsShownAndChosen) {
    EXPECT_EQ(board().chosen(), nullptr);
    EXPECT_FALSE(button("remove_reference").isEnabled());
    add();
    ASSERT_EQ(kept().references.size(), 1U);
    EXPECT_EQ(first().name, "photo");
    EXPECT_EQ(first().picture->pixels, halves());
    ASSERT_NE(board().chosen(), nullptr);
    EXPECT_TRUE(button("remove_reference").isEnabled());
    board().grab();
    board().pictures().wait();
    QApplication::processEvents();
    const QImage seen = board().grab().toImage();
    const double ratio = board().devicePixelRatioF();
    const auto near = [&](const QPoint& at, const pigment::Srgb8& colour) {
        const QColor pixel = seen.pixelColor((ratio * QPointF(at)).toPoint());
        EXPECT_NEAR(pixel.red(), colour[0], 3);
        EXPECT_NEAR(pixel.green(), colour[1], 3);
        EXPECT_NEAR(pixel.blue(), colour[2], 3);
    };
    near(on_first(0.25, 0.5), kBlue);
    near(on_first(0.75, 0.5), kGreen);
}

TEST_F(ReferenceWindow, ManyComeBesideOneAnother) {
    core::write_text_file(path("none.png"), "none");
    parts().references.add_files({name_of("photo.png"), name_of("none.png"), name_of("photo.png")});
    loaded();
    const auto references = kept().references;
    ASSERT_EQ(references.size(), 2U);
    EXPECT_FALSE(panels::extent_mm(references[0]).intersects(panels::extent_mm(references[1])));
    EXPECT_THAT(told(), HasSubstr("none.png"));
    EXPECT_EQ(board().chosen()->id, references[1].id);
    action(Command::Undo)->trigger();
    EXPECT_TRUE(kept().references.empty()) << "they came in one step";
}

TEST_F(ReferenceWindow, ThePointerTellsWhatAPressDoes) {
    add();
    board().zoom_about({0.5 * board().width(), 0.5 * board().height()}, 0.5);
    const auto shape_at = [&](const QPoint& at, Qt::KeyboardModifiers keys = {}) {
        QMouseEvent event(QEvent::MouseMove, at, board().mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                          keys);
        QApplication::sendEvent(&board(), &event);
        return board().cursor().shape();
    };
    EXPECT_EQ(shape_at(on_first(0.25, 0.5)), Qt::SizeAllCursor);
    EXPECT_EQ(shape_at(on_first(0.25, 0.5), Qt::ControlModifier), Qt::CrossCursor);
    EXPECT_EQ(shape_at(QPoint(2, 2)), Qt::ArrowCursor);
    EXPECT_EQ(shape_at(on_first(1.0, 1.0)), shape_at(on_first(0.0, 0.0)));
    EXPECT_NE(shape_at(on_first(1.0, 1.0)), shape_at(on_first(1.0, 0.0)));
    EXPECT_EQ(shape_at(on_first(0.5, 0.0) - QPoint(0, 22)), Qt::BitmapCursor) << "the ring that turns";
    action(Command::PickColour)->trigger();
    EXPECT_EQ(shape_at(on_first(0.25, 0.5)), Qt::CrossCursor);
    action(Command::PickColour)->trigger();
    board().choose(0);
    EXPECT_EQ(shape_at(on_first(1.0, 1.0) - QPoint(2, 2)), Qt::SizeAllCursor) << "it has no handles";
}

TEST_F(ReferenceWindow, DraggingMovesAPictureByOneStep) {
    add();
    const Reference before = first();
    const auto changes = steps();
    drag(on_first(0.25, 0.5), on_first(0.25, 0.5) + QPoint(30, 20));
    const Reference after = first();
    EXPECT_GT(after.place.x_mm, before.place.x_mm);
    EXPECT_GT(after.place.y_mm, before.place.y_mm);
    EXPECT_EQ(after.place.width_mm, before.place.width_mm);
    EXPECT_EQ(steps(), changes + 1);
    action(Command::Undo)->trigger();
    EXPECT_EQ(first(), before);
    action(Command::Redo)->trigger();
    EXPECT_EQ(first(), after);
}

TEST_F(ReferenceWindow, AClickAloneChangesNothing) {
    add();
    const auto changes = steps();
    QTest::mouseClick(&board(), Qt::LeftButton, {}, on_first(0.25, 0.5));
    settle();
    EXPECT_EQ(steps(), changes);
    EXPECT_NE(board().chosen(), nullptr);
    board().zoom_about({0.5 * board().width(), 0.5 * board().height()}, 0.5);
    QTest::mouseClick(&board(), Qt::LeftButton, {}, QPoint(2, 2));
    EXPECT_EQ(board().chosen(), nullptr);
}

TEST_F(ReferenceWindow, ACornerScalesWhileTheOppositeOneStays) {
    add();
    board().zoom_about({0.5 * board().width(), 0.5 * board().height()}, 0.5);
    const Reference before = first();
    drag(on_first(1.0, 1.0), on_first(1.3, 1.3));
    const Reference after = first();
    EXPECT_GT(after.place.width_mm, 1.15 * before.place.width_mm);
    EXPECT_NEAR(panels::corners_mm(after)[0].x(), panels::corners_mm(before)[0].x(), 1e-9);
    EXPECT_NEAR(panels::corners_mm(after)[0].y(), panels::corners_mm(before)[0].y(), 1e-9);
}

TEST_F(ReferenceWindow, TheWheelZoomsAndWithShiftItTurnsByOneStep) {
    add();
    const auto changes = steps();
    const QPoint at = on_first(0.25, 0.5);
    const QPointF place_mm = board().board_mm(at);
    turn_wheel(at, 2);
    EXPECT_NEAR(board().board_mm(at).x(), place_mm.x(), 1e-9);
    EXPECT_NEAR(board().widget_position(place_mm).x(), at.x(), 1e-9);
    settle();
    EXPECT_EQ(steps(), changes);
    turn_wheel(at, 1, Qt::ShiftModifier);
    turn_wheel(at, 1, Qt::ShiftModifier);
    EXPECT_EQ(board().chosen()->place.turn_deg, 10.0) << "shown before it is said";
    wait_for([&] { return first().place.turn_deg == 10.0; });
    EXPECT_EQ(steps(), changes + 1);
}

TEST_F(ReferenceWindow, AClickWithControlTakesARecipeOfTubes) {
    add();
    const auto click = [&](double share) {
        QTest::mouseClick(&board(), Qt::LeftButton, Qt::ControlModifier, on_first(share, 0.5));
        return studio().easel().hand().paint.ingredients;
    };
    const auto blue = click(0.25), green = click(0.75);
    EXPECT_NE(blue, green);
    for (const auto& recipe : {blue, green})
        for (const document::Ingredient& ingredient : recipe)
            EXPECT_NE(ingredient.pigment.front(), '#') << "a tube";
    EXPECT_THAT(told(), HasSubstr("Picked from the reference"));
}

TEST_F(ReferenceWindow, TheEyedropperPicksFromTheBoardOnce) {
    add();
    const auto before = studio().easel().hand().paint.ingredients;
    action(Command::PickColour)->trigger();
    QTest::mouseClick(&board(), Qt::LeftButton, {}, on_first(0.25, 0.5));
    const auto picked = studio().easel().hand().paint.ingredients;
    EXPECT_NE(picked, before);
    EXPECT_FALSE(action(Command::PickColour)->isChecked());
    QTest::mouseClick(&board(), Qt::LeftButton, {}, on_first(0.75, 0.5));
    EXPECT_EQ(studio().easel().hand().paint.ingredients, picked);
}

TEST_F(ReferenceWindow, ColoursAreThoseThatAreShown) {
    add();
    EXPECT_EQ(board().colour_at(on_first(0.25, 0.5)), kBlue);
    EXPECT_EQ(board().colour_at(on_first(0.75, 0.5)), kGreen);
    EXPECT_EQ(board().colour_at({1, 1}), std::nullopt);
    button("mirror_reference").trigger();
    settle();
    EXPECT_EQ(board().colour_at(on_first(0.25, 0.5)), kGreen);
    button("grey_reference").trigger();
    settle();
    const auto grey = board().colour_at(on_first(0.25, 0.5));
    ASSERT_TRUE(grey);
    EXPECT_EQ((*grey)[0], (*grey)[1]);
    EXPECT_EQ((*grey)[1], (*grey)[2]);
    EXPECT_TRUE(first().place.mirrored);
    EXPECT_TRUE(first().look.grey);
}

TEST_F(ReferenceWindow, OpacityBecomesOneStepWhenTheSliderRests) {
    add();
    const auto changes = steps();
    auto& slider = *window().findChild<QSlider*>(QStringLiteral("reference_opacity_slider"));
    for (const int step : {180, 140, 100})
        slider.setValue(step);
    EXPECT_EQ(board().chosen()->look.opacity, 0.5);
    wait_for([&] { return first().look.opacity == 0.5; });
    EXPECT_EQ(steps(), changes + 1);
}

TEST_F(ReferenceWindow, KeysChooseMoveScaleOrderAndRemove) {
    QApplication::setActiveWindow(&window());
    add(2);
    board().setFocus();
    ASSERT_TRUE(board().hasFocus());
    const auto press = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&board(), key, modifiers);
        board().finish();
    };
    press(Qt::Key_Return);
    ASSERT_EQ(board().chosen()->id, 1U);
    const Reference before = first();
    press(Qt::Key_Right);
    EXPECT_GT(first().place.x_mm, before.place.x_mm);
    press(Qt::Key_Plus);
    EXPECT_NEAR(first().place.width_mm, 1.1 * before.place.width_mm, 1e-9);
    press(Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_EQ(first().place.turn_deg, 5.0);
    EXPECT_THAT(order(), ElementsAre(1, 2));
    press(Qt::Key_PageUp);
    EXPECT_THAT(order(), ElementsAre(2, 1));
    press(Qt::Key_PageDown);
    EXPECT_THAT(order(), ElementsAre(1, 2));
    press(Qt::Key_Delete);
    EXPECT_THAT(order(), ElementsAre(2));
}

TEST_F(ReferenceWindow, FilesAndPicturesAreDroppedWhereThePointerIs) {
    const auto drop = [&](QMimeData& data, const QPoint& at) {
        QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&board(), &enter);
        EXPECT_TRUE(enter.isAccepted());
        QDropEvent fall(at, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&board(), &fall);
        loaded();
    };
    const QPoint at(40, 30);
    const QPointF place_mm = board().board_mm(at);
    QMimeData file;
    file.setUrls({QUrl::fromLocalFile(name_of("photo.png"))});
    drop(file, at);
    ASSERT_EQ(kept().references.size(), 1U);
    EXPECT_NEAR(first().place.x_mm, place_mm.x(), 1e-9);
    EXPECT_NEAR(first().place.y_mm, place_mm.y(), 1e-9);
    QMimeData picture;
    QImage image(3, 2, QImage::Format_RGBA8888);
    image.fill(QColor(10, 20, 30));
    picture.setImageData(image);
    drop(picture, at);
    ASSERT_EQ(kept().references.size(), 2U);
    EXPECT_EQ(kept().references[1].picture->pixels.width, 3);
    QMimeData address;
    address.setUrls({QUrl(QStringLiteral("https://example.org/photo.png"))});
    drop(address, at);
    EXPECT_EQ(kept().references.size(), 2U);
    EXPECT_THAT(told(), HasSubstr("no picture in it"));
}

TEST_F(ReferenceWindow, ACopiedPictureIsPastedOntoTheBoardThatHasTheKeys) {
    QApplication::setActiveWindow(&window());
    QImage image(4, 4, QImage::Format_RGBA8888);
    image.fill(QColor(200, 20, 30));
    QGuiApplication::clipboard()->setImage(image);
    board().setFocus();
    QTest::keyClick(&board(), Qt::Key_V, Qt::ControlModifier);
    loaded();
    ASSERT_EQ(kept().references.size(), 1U);
    EXPECT_EQ(first().picture->pixels.rgba[0], 200);
    EXPECT_EQ(session().snapshot()->layers->layers.size(), 1U);
}

TEST_F(ReferenceWindow, ComesBackWithThePainting) {
    add(2);
    drag(on_first(0.25, 0.5), on_first(0.25, 0.5) + QPoint(30, 20));
    const document::ReferenceBoard before = kept();
    parts().files.save_painting(name_of("a.pastoso"));
    ASSERT_EQ(parts().files.saver().wait().toStdString(), "");
    board().remove_chosen();
    settle();
    ASSERT_EQ(kept().references.size(), 1U);
    parts().files.open_painting(name_of("a.pastoso"));
    loaded();
    EXPECT_EQ(kept(), before);
    EXPECT_EQ(board().board(), before);
}

TEST_F(ReferenceWindow, HasAWindowOfItsOwnAndComesBack) {
    action(Command::FloatReferences)->trigger();
    EXPECT_TRUE(dock().isFloating());
    EXPECT_TRUE(dock().isVisible());
    EXPECT_NE(QGuiApplication::screenAt(dock().geometry().center()), nullptr);
    EXPECT_GE(dock().height(), 150) << "there is something to see of the board";
    dock().setFloating(false);
    EXPECT_FALSE(action(Command::FloatReferences)->isChecked());
}

}  // namespace
}  // namespace pastoso::tests
