#include "panels/brush_panel.hpp"

#include "panels/section.hpp"
#include "tools/hand.hpp"

#include <cmath>
#include <utility>

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QListWidget>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

/// The slider is logarithmic: a millimetre counts for more on a small brush.
constexpr int kSliderSteps = 200;

int slider_from_width(double width_mm) {
    const double range = std::log(tools::kLargestBrush_mm / tools::kSmallestBrush_mm);
    return static_cast<int>(
        std::lround(kSliderSteps * std::log(width_mm / tools::kSmallestBrush_mm) / range));
}

double width_from_slider(int position) {
    const double share = static_cast<double>(position) / kSliderSteps;
    const double width =
        tools::kSmallestBrush_mm * std::pow(tools::kLargestBrush_mm / tools::kSmallestBrush_mm, share);
    return std::round(2.0 * width) / 2.0;
}

}  // namespace

BrushPanel::BrushPanel(std::vector<BrushEntry> brushes, QWidget* parent)
    : QWidget(parent), brushes_(std::move(brushes)), list_(new QListWidget) {
    for (const BrushEntry& brush : brushes_)
        list_->addItem(brush.name);
    keep_keys_for_canvas(list_);
    fit_to_rows(list_, static_cast<int>(brushes_.size()));
    connect(list_, &QListWidget::itemClicked, this, [this] { take_next(0); });
    auto* column = section(this, tr("Brush"));
    column->addWidget(list_);
    column->addWidget(make_width_row());
}

QWidget* BrushPanel::make_width_row() {
    slider_ = new QSlider(Qt::Horizontal);
    slider_->setRange(0, kSliderSteps);
    width_ = new QDoubleSpinBox;
    width_->setRange(tools::kSmallestBrush_mm, tools::kLargestBrush_mm);
    width_->setDecimals(1);
    width_->setSuffix(tr(" mm"));
    width_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    width_->setAlignment(Qt::AlignRight);
    width_->setFixedWidth(68);
    width_->setKeyboardTracking(false);
    width_->setFocusPolicy(Qt::ClickFocus);
    width_->setToolTip(tr("Width of the brush's tip  ([ and ])"));
    slider_->setToolTip(width_->toolTip());
    keep_keys_for_canvas(slider_);
    connect(slider_, &QSlider::valueChanged, this,
            [this](int position) { Q_EMIT width_chosen(width_from_slider(position)); });
    connect(width_, &QDoubleSpinBox::valueChanged, this, &BrushPanel::width_chosen);
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(slider_);
    layout->addWidget(width_);
    return row;
}

void BrushPanel::show_brush(const QString& name, double width_mm) {
    const QSignalBlocker no_slider_signal(slider_);
    const QSignalBlocker no_width_signal(width_);
    slider_->setValue(slider_from_width(width_mm));
    width_->setValue(width_mm);
    for (int row = 0; row < list_->count(); ++row) {
        if (list_->item(row)->text() == name) list_->setCurrentRow(row);
    }
}

void BrushPanel::take_next(int places) {
    const int count = list_->count();
    if (count == 0) return;
    const int row = ((list_->currentRow() + places) % count + count) % count;
    const BrushEntry& brush = brushes_[static_cast<std::size_t>(row)];
    Q_EMIT brush_taken(brush.name, brush.width_mm);
}

}  // namespace pastoso::panels
