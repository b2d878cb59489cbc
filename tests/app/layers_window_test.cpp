// The layers panel of the real window: paint on several layers, hide, lock, fade, move, group and name
// them, by mouse and by keys.
#include "app/window_fixture.hpp"
#include "layers/apart.hpp"
#include "main/window_parts.hpp"
#include "panels/layers/layer_delegate.hpp"
#include "panels/layers/layer_panel.hpp"
#include "panels/layers/layer_tree.hpp"
#include "recordings/paint_piece.hpp"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QHelpEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QPainter>
#include <QSlider>
#include <QStatusBar>
#include <QTest>
#include <QToolTip>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using panels::LayerModel;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using tools::LayerRow;

class LayersWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        give(Command::Pause);
    }

    void give(Command command) {
        QAction* action = studio().commands().action(command);
        ASSERT_TRUE(action->isEnabled()) << action->text().toStdString();
        action->trigger();
        follow();
    }

    /// Until the panel shows what the painting is.
    void follow() {
        session().wait_until_applied();
        wait_for([this] {
            document::LayerStack shown = panel().stack();
            return shown == *session().snapshot()->layers;
        });
    }

    panels::LayerPanel& panel() { return *window().findChild<panels::LayerPanel*>(); }
    panels::LayerTree& tree() { return *window().findChild<panels::LayerTree*>(); }
    const document::LayerStack& stack() { return panel().stack(); }

    std::vector<std::string> names_from_below() {
        std::vector<std::string> names;
        for (const document::Layer& layer : stack().layers)
            names.push_back(layer.look.name);
        return names;
    }
    std::string active_name() { return stack().layers[stack().active].look.name; }
    static LayerRow layer(document::LayerId id) { return {.layer = id}; }
    QRect place_of(const LayerRow& row, LayerModel::Column column) {
        tree().scrollTo(tree().layers().index_of(row, column));  // the window may be low
        return tree().visualRect(tree().layers().index_of(row, column));
    }
    void click(const LayerRow& row, LayerModel::Column column, Qt::KeyboardModifiers keys = {}) {
        QTest::mouseClick(tree().viewport(), Qt::LeftButton, keys, place_of(row, column).center());
        follow();
    }
    void press_key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
        follow();
    }
    /// What the pointer is told that rests on its name.
    std::string hint(const LayerRow& row) {
        const QPoint place = place_of(row, LayerModel::kName).center();
        QHelpEvent rests(QEvent::ToolTip, place, tree().viewport()->mapToGlobal(place));
        QApplication::sendEvent(tree().viewport(), &rests);
        return QToolTip::text().toStdString();
    }
    /// Lets a row fall at a place in the list.
    void drop(const LayerRow& row, const QPoint& place) {
        const std::unique_ptr<QMimeData> data = tree().dragged(tree().layers().index_of(row));
        QWidget* list = tree().viewport();
        QDragEnterEvent enter(place, Qt::MoveAction, data.get(), Qt::LeftButton, {});
        QApplication::sendEvent(list, &enter);
        QDragMoveEvent drag(place, Qt::MoveAction, data.get(), Qt::LeftButton, {});
        QApplication::sendEvent(list, &drag);
        QDropEvent fall(place, Qt::MoveAction, data.get(), Qt::LeftButton, {});
        QApplication::sendEvent(list, &fall);
        follow();
    }
    void name_by_typing(const char* name) {
        auto* editor = tree().viewport()->findChild<QLineEdit*>();
        ASSERT_NE(editor, nullptr);
        editor->setText(QString::fromUtf8(name));
        QTest::keyClick(editor, Qt::Key_Return);
        QApplication::processEvents();  // Qt takes the name once the key is handled
        follow();
    }
    /// On all layers, wet and dry.
    double paint_mm3() {
        session().wait_until_applied();
        const auto painting = session().snapshot();
        double sum_mm3 = 0.0;
        const auto add = [&](const film::FilmState& film) {
            const auto quanta = film::totals(film).thickness + film::dried_totals(film.strata).thickness;
            sum_mm3 += film::volume_mm3(quanta, film.cell_mm);
        };
        add(painting->active != nullptr ? *painting->active : painting->film);
        for (const document::Layer& layer : painting->layers->layers)
            if (layer.inactive != nullptr) add(*layer.inactive);
        return sum_mm3;
    }
    void paint_upper_half() { mouse_stroke(line_mm({8.0, 10.0}, {52.0, 10.0})); }
    void paint_lower_half() { mouse_stroke(line_mm({8.0, 30.0}, {52.0, 30.0})); }
};

TEST_F(LayersWindow, ADraggedRowCarriesItsPaintToOtherWindowsAndPrograms) {
    const auto dragged = [this](document::LayerId id) {
        return tree().dragged(tree().layers().index_of(layer(id)));
    };
    const QString paint_format = QStringLiteral("application/x-pastoso-paint");
    paint_upper_half();
    settle();
    give(Command::AddLayer);
    const document::LayerId bare = stack().layers[1].id;
    EXPECT_FALSE(dragged(bare)->hasImage()) << "there is nothing to see of it";
    EXPECT_FALSE(dragged(bare)->hasFormat(paint_format));
    paint_lower_half();
    settle();

    const auto upper_half = dragged(stack().layers[0].id);
    const QByteArray bytes = upper_half->data(paint_format);
    const recordings::PaintPiece piece = recordings::piece_of(
        {bytes.constData(), static_cast<std::size_t>(bytes.size())}, "the dragged row");
    const film::FilmState& kept = *session().snapshot()->layers->layers[0].inactive;
    EXPECT_EQ(film::totals(*piece.paint).thickness, film::totals(kept).thickness);
    const grid::Rect painted = layers::painted_area(kept);
    EXPECT_EQ(layers::painted_area(*piece.paint), painted);
    const auto picture = qvariant_cast<QImage>(upper_half->imageData());
    EXPECT_EQ(picture.size(), QSize(painted.width(), painted.height()));
    EXPECT_TRUE(picture.hasAlphaChannel()) << "without the canvas";

    const QByteArray active = dragged(stack().layers[1].id)->data(paint_format);
    const recordings::PaintPiece lower_half = recordings::piece_of(
        {active.constData(), static_cast<std::size_t>(active.size())}, "the dragged row");
    EXPECT_EQ(film::totals(*lower_half.paint).thickness,
              film::totals(*session().snapshot()->active).thickness)
        << "so does the one that is painted on";
    EXPECT_EQ(session().snapshot()->copied, nullptr) << "nothing is copied by that";
}

TEST_F(LayersWindow, StartsWithOneLayerThatIsPaintedOn) {
    follow();
    EXPECT_THAT(names_from_below(), ElementsAre("Paint"));
    EXPECT_EQ(tree().current(), layer(1));
    EXPECT_TRUE(action(Command::AddLayer)->isEnabled());
    for (const Command command : {Command::RemoveLayer, Command::MergeDown, Command::FlattenLayers,
                                  Command::UngroupLayers, Command::LayerAbove, Command::LayerBelow})
        EXPECT_FALSE(action(command)->isEnabled()) << action(command)->text().toStdString();
    EXPECT_TRUE(tree().isVisible());
}

TEST_F(LayersWindow, PaintOfAHiddenLayerIsNotSeenUntilItIsShownAgain) {
    paint_upper_half();
    const QImage one = picture();
    give(Command::AddLayer);
    EXPECT_THAT(names_from_below(), ElementsAre("Paint", "Layer 2"));
    EXPECT_EQ(active_name(), "Layer 2");
    EXPECT_EQ(tree().current(), layer(2));
    paint_lower_half();
    const QImage both = picture();
    EXPECT_GT(difference(one, both).largest, 40);
    click(layer(2), LayerModel::kEye);
    EXPECT_EQ(difference(one, picture()).largest, 0);
    EXPECT_FALSE(action(Command::ShowLayer)->isChecked());
    click(layer(2), LayerModel::kEye);
    EXPECT_EQ(difference(both, picture()).largest, 0);
}

TEST_F(LayersWindow, ALockedOrHiddenLayerSaysSoAndKeepsEverything) {
    paint_upper_half();
    session().wait_until_applied();
    const QImage before = picture();
    const double painted_mm3 = paint_mm3();
    click(layer(1), LayerModel::kLock);
    EXPECT_TRUE(action(Command::LockLayer)->isChecked());
    paint_lower_half();
    wait_for([this] { return !told().empty(); });
    EXPECT_THAT(told(), HasSubstr("The layer \"Paint\" is locked"));
    EXPECT_EQ(paint_mm3(), painted_mm3);
    EXPECT_EQ(difference(before, picture()).largest, 0);
    click(layer(1), LayerModel::kLock);
    click(layer(1), LayerModel::kEye);
    paint_lower_half();
    wait_for([this] { return told().find("is hidden") != std::string::npos; });
    click(layer(1), LayerModel::kEye);
    EXPECT_EQ(paint_mm3(), painted_mm3);
    paint_lower_half();
    EXPECT_GT(paint_mm3(), painted_mm3) << "it is painted on again";
}

TEST_F(LayersWindow, AClickChoosesTheLayerThatIsPaintedOn) {
    give(Command::AddLayer);
    click(layer(1), LayerModel::kName);
    EXPECT_EQ(active_name(), "Paint");
    EXPECT_EQ(session().snapshot()->layers->active, 0U);
    click(layer(2), LayerModel::kEye);
    EXPECT_EQ(active_name(), "Paint") << "the eye does not choose";
    EXPECT_EQ(QApplication::focusWidget(), &canvas()) << "the keys stay with the canvas";
}

TEST_F(LayersWindow, RowsAreDragged) {
    give(Command::AddLayer);
    give(Command::AddLayer);
    drop(layer(1), place_of(layer(3), LayerModel::kName).topLeft() + QPoint(30, 1));
    EXPECT_THAT(names_from_below(), ElementsAre("Layer 2", "Layer 3", "Paint"));
    drop(layer(3), tree().viewport()->rect().bottomLeft() + QPoint(30, -2));
    EXPECT_THAT(names_from_below(), ElementsAre("Layer 3", "Layer 2", "Paint"));
    EXPECT_EQ(active_name(), "Layer 3") << "it stays the one that is painted on";
    give(Command::Undo);
    EXPECT_THAT(names_from_below(), ElementsAre("Layer 2", "Layer 3", "Paint"));
}

TEST_F(LayersWindow, AGroupHoldsLayersAndHidesThemTogether) {
    paint_upper_half();
    const QImage one = picture();
    give(Command::AddLayer);
    paint_lower_half();
    give(Command::GroupLayers);
    ASSERT_EQ(stack().groups.size(), 1U);
    const LayerRow group{.group = stack().groups[0].id};
    EXPECT_EQ(stack().layers[1].group, group.group);
    click(group, LayerModel::kEye);
    EXPECT_EQ(difference(one, picture()).largest, 0);
    drop(layer(1), place_of(group, LayerModel::kName).center());
    EXPECT_EQ(stack().layers[0].group + stack().layers[1].group, 2 * group.group);
    EXPECT_THAT(names_from_below(), ElementsAre("Layer 2", "Paint"));
    drop(layer(2), place_of(group, LayerModel::kName).bottomLeft() + QPoint(30, -1));
    EXPECT_THAT(names_from_below(), ElementsAre("Paint", "Layer 2")) << "the uppermost of the group";
    EXPECT_EQ(stack().layers[1].group, group.group);
    click(group, LayerModel::kName);
    EXPECT_EQ(panel().chosen(), group);
    EXPECT_FALSE(action(Command::DuplicateLayer)->isEnabled());
    EXPECT_FALSE(action(Command::RemoveLayer)->isEnabled()) << "it has the last layer";
    give(Command::UngroupLayers);
    EXPECT_TRUE(stack().groups.empty());
    EXPECT_EQ(panel().chosen(), layer(2));
}

TEST_F(LayersWindow, AClippedLayerShowsOnlyOverTheOneBelow) {
    paint_upper_half();
    EXPECT_FALSE(action(Command::ClipLayer)->isEnabled()) << "nothing lies below";
    const QImage one = picture();
    give(Command::AddLayer);
    paint_lower_half();
    const QImage both = picture();
    const double painted_mm3 = paint_mm3();
    EXPECT_GT(difference(one, both).largest, 40);
    give(Command::ClipLayer);
    EXPECT_TRUE(action(Command::ClipLayer)->isChecked());
    EXPECT_TRUE(stack().layers[1].look.clipped);
    const auto beside = [](const QImage& seen) {
        return seen.copy(0, seen.height() * 5 / 8, seen.width(), seen.height() * 3 / 8);
    };
    EXPECT_GT(difference(beside(one), beside(both)).largest, 40);
    EXPECT_EQ(difference(beside(one), beside(picture())).largest, 0);
    EXPECT_EQ(paint_mm3(), painted_mm3) << "what is hidden is kept";
    const QModelIndex row = tree().layers().index_of(layer(2));
    EXPECT_THAT(row.data(Qt::AccessibleTextRole).toString().toStdString(),
                HasSubstr("clipped to the layer below"));
    EXPECT_THAT(hint(layer(2)),
                AllOf(HasSubstr("You paint on this layer"), HasSubstr("Clipped to the layer below")));
    give(Command::Undo);
    EXPECT_FALSE(action(Command::ClipLayer)->isChecked());
    EXPECT_EQ(difference(both, picture()).largest, 0);
    give(Command::Redo);
    click(layer(2), LayerModel::kName);
    give(Command::ClipLayer);
    EXPECT_FALSE(stack().layers[1].look.clipped);
    EXPECT_EQ(difference(both, picture()).largest, 0);
}

TEST_F(LayersWindow, ClippedLayersStandBehindAMark) {
    const auto left_of_row = [](bool clipped) {
        document::LayerStack stack = document::single_layer();
        stack.layers[0].look.clipped = clipped;
        LayerModel model;
        model.show(stack);
        QImage image(200, 44, QImage::Format_RGB32);
        image.fill(Qt::blue);
        QStyleOptionViewItem row;
        row.rect = image.rect();
        QPainter painter(&image);
        panels::LayerDelegate(&model, nullptr).paint(&painter, row, model.index_of(layer(1)));
        painter.end();
        return image.copy(0, 0, 16, 44);
    };
    EXPECT_NE(left_of_row(true), left_of_row(false));
}

TEST_F(LayersWindow, ARowKnowsWhatItIsClippedTo) {
    document::LayerStack stack = document::single_layer();
    stack.layers[0].look.clipped = true;
    stack.layers.push_back({.id = 2, .look = {.clipped = true}});
    LayerModel model;
    const auto row = [&](document::LayerId id) { return model.index_of(layer(id)); };
    const auto words = [&](document::LayerId id) {
        return row(id).data(Qt::AccessibleTextRole).toString().toStdString();
    };
    model.show(stack);
    EXPECT_THAT(words(1), Not(HasSubstr("clipped"))) << "nothing lies below, and all of it shows";
    EXPECT_THAT(words(2), Not(HasSubstr("clipped"))) << "nor anything that is not clipped";
    stack.layers[0].look.clipped = false;
    model.show(stack);
    EXPECT_THAT(words(2), HasSubstr("clipped"));
    EXPECT_TRUE(model.item(row(2)).seen);
    stack.layers[0].look.visible = false;
    model.show(stack);
    EXPECT_FALSE(model.item(row(2)).seen) << "hidden with what it is clipped to";
}

TEST_F(LayersWindow, GroupsAreNotClipped) {
    give(Command::AddLayer);
    give(Command::GroupLayers);
    click(LayerRow{.group = stack().groups[0].id}, LayerModel::kName);
    EXPECT_FALSE(action(Command::ClipLayer)->isEnabled());
    click(layer(2), LayerModel::kName);
    EXPECT_FALSE(action(Command::ClipLayer)->isEnabled()) << "the lowest of its group";
}

TEST_F(LayersWindow, ChosenRowsAreGroupedTogether) {
    give(Command::AddLayer);
    give(Command::AddLayer);
    click(layer(3), LayerModel::kName);
    click(layer(2), LayerModel::kName, Qt::ShiftModifier);
    give(Command::GroupLayers);
    EXPECT_EQ(stack().layers[0].group, 0U);
    EXPECT_NE(stack().layers[1].group, 0U);
    EXPECT_EQ(stack().layers[1].group, stack().layers[2].group);
}

TEST_F(LayersWindow, NamesAreEditedInPlace) {
    give(Command::AddLayer);
    const QPoint name = place_of(layer(2), LayerModel::kName).center();
    QTest::mouseClick(tree().viewport(), Qt::LeftButton, {}, name);
    QTest::mouseDClick(tree().viewport(), Qt::LeftButton, {}, name);
    name_by_typing("Sky");
    EXPECT_THAT(names_from_below(), ElementsAre("Paint", "Sky"));
    EXPECT_EQ(QApplication::focusWidget(), &canvas()) << "the keys go back to the canvas";
    give(Command::Undo);
    EXPECT_THAT(names_from_below(), ElementsAre("Paint", "Layer 2"));
    give(Command::Redo);
    EXPECT_THAT(names_from_below(), ElementsAre("Paint", "Sky"));
    give(Command::RenameLayer);
    name_by_typing("  ");
    EXPECT_THAT(names_from_below(), ElementsAre("Paint", "Sky")) << "no name is no name";
}

TEST_F(LayersWindow, ANameBeingTypedStaysWhenItsRowChanges) {
    give(Command::AddLayer);
    give(Command::RenameLayer);
    auto* editor = tree().viewport()->findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    editor->setText(QStringLiteral("Sky"));
    const QModelIndex row = tree().currentIndex();
    Q_EMIT tree().model()->dataChanged(row, row);
    EXPECT_EQ(editor->text(), QStringLiteral("Sky"));
    name_by_typing("Sea");
    EXPECT_THAT(names_from_below(), ElementsAre("Paint", "Sea"));
    give(Command::RenameLayer);
    EXPECT_EQ(tree().viewport()->findChild<QLineEdit*>()->text(), QStringLiteral("Sea"));
}

TEST_F(LayersWindow, TheOpacityFadesTheChosenLayerAndIsUndoneAtOnce) {
    paint_upper_half();
    give(Command::AddLayer);
    paint_lower_half();
    const QImage opaque = picture();
    auto& slider = *window().findChild<QSlider*>(QStringLiteral("layer_opacity_slider"));
    for (const int step : {150, 120, 80})
        slider.setValue(step);
    wait_for([this] { return session().snapshot()->layers->layers[1].look.opacity < 1.0; });
    follow();
    EXPECT_EQ(stack().layers[1].look.opacity, 0.4);
    EXPECT_EQ(stack().layers[0].look.opacity, 1.0);
    EXPECT_GT(difference(opaque, picture()).largest, 20);
    give(Command::Undo);
    EXPECT_EQ(stack().layers[1].look.opacity, 1.0);
    EXPECT_EQ(slider.value(), slider.maximum());
    EXPECT_EQ(difference(opaque, picture()).largest, 0);
}

TEST_F(LayersWindow, AnOpacityUnderWayGoesToTheLayerItWasMeantFor) {
    give(Command::AddLayer);
    window().findChild<QDoubleSpinBox*>(QStringLiteral("layer_opacity"))->setValue(30.0);
    click(layer(1), LayerModel::kName);
    EXPECT_EQ(stack().layers[1].look.opacity, 0.3);
    EXPECT_EQ(stack().layers[0].look.opacity, 1.0);
}

TEST_F(LayersWindow, LayersAreDuplicatedClearedMergedAndRemoved) {
    paint_upper_half();
    const double painted_mm3 = paint_mm3();
    give(Command::DuplicateLayer);
    EXPECT_EQ(stack().layers.size(), 2U);
    give(Command::ClearLayer);
    EXPECT_EQ(paint_mm3(), painted_mm3);
    paint_lower_half();
    const double all_mm3 = paint_mm3();
    EXPECT_GT(all_mm3, painted_mm3);
    give(Command::MergeDown);
    EXPECT_THAT(names_from_below(), ElementsAre("Paint"));
    EXPECT_NEAR(paint_mm3(), all_mm3, 1e-9 * all_mm3);
    give(Command::Undo);
    EXPECT_EQ(stack().layers.size(), 2U);
    give(Command::RemoveLayer);
    EXPECT_EQ(stack().layers.size(), 1U);
    EXPECT_EQ(paint_mm3(), painted_mm3);
    give(Command::AddLayer);
    give(Command::AddLayer);
    give(Command::FlattenLayers);
    EXPECT_EQ(stack().layers.size(), 1U);
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(LayersWindow, UndoAndRedoAreSeenInTheList) {
    give(Command::AddLayer);
    give(Command::AddLayer);
    give(Command::Undo);
    EXPECT_THAT(names_from_below(), ElementsAre("Paint", "Layer 2"));
    EXPECT_EQ(tree().layers().rowCount(), 2);
    EXPECT_EQ(tree().current(), layer(2));
    give(Command::Redo);
    EXPECT_EQ(tree().layers().rowCount(), 3);
}

TEST_F(LayersWindow, KeysAloneDoEverything) {
    press_key(Qt::Key_Insert);
    press_key(Qt::Key_J, Qt::ControlModifier);
    EXPECT_EQ(stack().layers.size(), 3U);
    press_key(Qt::Key_PageDown);
    press_key(Qt::Key_PageDown);
    EXPECT_EQ(active_name(), "Paint");
    press_key(Qt::Key_PageUp, Qt::ControlModifier);
    EXPECT_THAT(names_from_below(), ElementsAre("Layer 2", "Paint", "Layer 2"));
    press_key(Qt::Key_E, Qt::ControlModifier);
    EXPECT_EQ(stack().layers.size(), 2U);
    press_key(Qt::Key_F8);
    EXPECT_EQ(QApplication::focusWidget(), &tree());
    press_key(Qt::Key_Up);
    EXPECT_EQ(stack().active, 1U);
    press_key(Qt::Key_Space);
    EXPECT_FALSE(stack().layers[1].look.visible);
    press_key(Qt::Key_Slash, Qt::ControlModifier);
    EXPECT_TRUE(stack().layers[1].look.locked);
    press_key(Qt::Key_Slash, Qt::ControlModifier);
    const std::string before = active_name();
    QTest::keyClick(&tree(), Qt::Key_F2);
    EXPECT_EQ(tree().viewport()->findChild<QLineEdit*>()->selectedText().toStdString(), before)
        << "what is typed takes the old name's place";
    name_by_typing("Glaze");
    EXPECT_EQ(active_name(), "Glaze");
    EXPECT_EQ(QApplication::focusWidget(), &tree());
    press_key(Qt::Key_G, Qt::ControlModifier);
    EXPECT_EQ(stack().groups.size(), 1U);
    press_key(Qt::Key_Delete, Qt::ShiftModifier);
    EXPECT_EQ(stack().layers.size(), 1U);
}

TEST_F(LayersWindow, PicturesShowThePaintOfEachLayer) {
    paint_upper_half();
    give(Command::AddLayer);
    const auto picture_of = [this](document::LayerId id) {
        return tree().layers().picture(tree().layers().index_of(layer(id)));
    };
    const auto covered = [&](document::LayerId id, int y) {
        const QImage picture = picture_of(id);
        return !picture.isNull() &&
               qAlpha(picture.pixel(picture.width() / 2, y * picture.height() / 40)) > 200;
    };
    wait_for([&] { return covered(1, 10) && !picture_of(2).isNull(); });
    EXPECT_FALSE(covered(1, 30));
    EXPECT_FALSE(covered(2, 10));
    EXPECT_TRUE(tree().layers().item(tree().layers().index_of(layer(1))).inactive_wet);
    paint_lower_half();
    wait_for([&] { return covered(2, 30); });
    EXPECT_FALSE(covered(2, 10));
}

TEST_F(LayersWindow, APictureIsDrawnAnewWhereItStands) {
    QImage green(panels::kLayerPicture, QImage::Format_ARGB32_Premultiplied);
    green.fill(QColor(0, 200, 0));
    const QPoint middle = place_of(layer(1), LayerModel::kName).topLeft() +
                          QPoint(panels::kLayerPicture.width() / 2, panels::kLayerPicture.height() / 2);
    bool drawn = false;
    QObject::connect(&tree().layers(), &QAbstractItemModel::dataChanged, &tree(),
                     [&](const QModelIndex& first, const QModelIndex& last) {
                         const QRect changed = tree().visualRect(first).united(tree().visualRect(last));
                         drawn = drawn || changed.contains(middle);
                     });
    tree().layers().set_picture(1, green, true);
    EXPECT_TRUE(drawn);
}

TEST_F(LayersWindow, ThePanelIsRememberedAndTakesUpAnotherCanvas) {
    give(Command::AddLayer);
    parts().files.new_canvas(canvas_settings());
    loaded();
    follow();
    EXPECT_THAT(names_from_below(), ElementsAre("Paint"));
    const auto dock = [this] {
        return window().findChild<QDockWidget*>(QStringLiteral("layers_panel"));
    };
    dock()->hide();
    start_again();
    EXPECT_TRUE(dock()->isHidden());
    give(Command::ResetPanels);
    EXPECT_TRUE(dock()->isVisible());
}

}  // namespace
}  // namespace pastoso::tests
