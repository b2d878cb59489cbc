#include "panels/paint/load_panel.hpp"

#include "appearance/terms.hpp"
#include "panels/paint/load_bar.hpp"
#include "panels/paint/paint_swatch.hpp"
#include "panels/paint/paint_words.hpp"
#include "panels/paint/swatch_colours.hpp"
#include "panels/parts/section.hpp"
#include "panels/parts/value_row.hpp"
#include "tools/colour_paint.hpp"

#include <cmath>

#include <QAction>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

using Way = tools::Dip::Way;

bool takes_two(Way way) {
    return way == Way::TwoSides || way == Way::HalfMixed;
}

}  // namespace

LoadPanel::LoadPanel(const std::vector<QAction*>& actions, QAction* swap, QWidget* parent)
    : QWidget(parent), bar_(new LoadBar), fullness_(new QLabel), way_(new QComboBox) {
    auto* column = section(this, tr("On the brush"));
    fullness_->setObjectName(QStringLiteral("reading"));
    appearance::explain(fullness_, appearance::Term::Load);
    way_->setObjectName(QStringLiteral("dip_way"));
    way_->setToolTip(tr("How the brush is dipped, from the next time on"));
    way_->addItem(tr("Full, in one paint"), static_cast<int>(Way::Full));
    way_->addItem(tr("Only the tip"), static_cast<int>(Way::Tip));
    way_->addItem(tr("One paint on each side"), static_cast<int>(Way::TwoSides));
    way_->addItem(tr("Half mixed from two"), static_cast<int>(Way::HalfMixed));
    way_->setAccessibleName(way_->toolTip());
    keep_keys_for_canvas(way_);
    auto* values = new QWidget;
    auto* grid = new QGridLayout(values);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    fill_ = new ValueRow(grid, QStringLiteral("dip_fill"), tr("Fill"),
                         tr("How full the brush is dipped; little leaves a dry brush"),
                         {5.0, 120.0, 0, tr(" %")});
    share_ =
        new ValueRow(grid, QStringLiteral("dip_share"), tr("Second"),
                     tr("The second paint's share of a half-mixed load"), {0.0, 100.0, 0, tr(" %")});
    column->addWidget(bar_);
    column->addWidget(fullness_);
    column->addWidget(button_row(actions));
    column->addWidget(way_);
    column->addWidget(paints_row(swap));
    column->addWidget(values);
    connect(way_, &QComboBox::activated, this, &LoadPanel::emit_dip);
    connect(fill_, &ValueRow::chosen, this, &LoadPanel::emit_dip);
    connect(share_, &ValueRow::chosen, this, &LoadPanel::emit_dip);
    show_load({});
}

QWidget* LoadPanel::paints_row(QAction* swap) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    first_ = new PaintSwatch;
    second_ = new PaintSwatch;
    first_->setObjectName(QStringLiteral("first_paint"));
    second_->setObjectName(QStringLiteral("second_paint"));
    layout->addWidget(first_, 1);
    layout->addWidget(action_button(swap));
    layout->addWidget(second_, 1);
    connect(second_, &QPushButton::clicked, swap, &QAction::trigger);
    return row;
}

void LoadPanel::emit_dip() {
    const tools::Dip dip{static_cast<Way>(way_->currentData().toInt()), fill_->value() / 100.0,
                         share_->value() / 100.0};
    show_way(dip.way);
    Q_EMIT dip_chosen(dip);
}

void LoadPanel::show_way(Way way) {
    way_->setCurrentIndex(way_->findData(static_cast<int>(way)));
    share_->setEnabled(way == Way::HalfMixed);
}

void LoadPanel::show_hand(const tools::Hand& hand) {
    const bool dips = tools::preset_in_hand(hand).dips;
    way_->setEnabled(dips);
    fill_->setEnabled(dips);
    show_way(hand.dip.way);
    share_->setEnabled(dips && hand.dip.way == Way::HalfMixed);
    fill_->show_value(100.0 * hand.dip.fill);
    share_->show_value(100.0 * hand.dip.second_share);
    paint_ = hand.paint;
    second_paint_ = hand.second_paint;
    show_paints();
}

void LoadPanel::show_swatches(const tools::SwatchView& view) {
    view_ = view;
    bar_->show_swatches(view);
    show_paints();
}

void LoadPanel::show_paints() {
    const auto show = [this](PaintSwatch* swatch, const QString& words,
                             const document::PaintRecipe& paint) {
        const tools::Drawdown drawn = tools::drawdown(paint, view_);
        swatch->show_paint(shown_colour(paint, view_), words.arg(paint_words(paint, drawn.hiding)));
        swatch->show_drawdown(drawn);
    };
    const bool two = takes_two(static_cast<Way>(way_->currentData().toInt()));
    show(first_, tr("In hand: %1"), paint_);
    show(second_,
         two ? tr("The second paint of the load: %1") : tr("The second paint, laid out for later: %1"),
         second_paint_);
}

void LoadPanel::show_load(const brush::LoadProfile& load) {
    bar_->show_load(load);
    const long percent = std::lround(100.0 * load.fill);
    fullness_->setText(load.fill <= 0.0 ? tr("empty")
                       : percent == 0   ? tr("all but empty")
                                        : tr("%1 % full").arg(percent));
}

}  // namespace pastoso::panels
