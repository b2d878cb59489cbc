#include "panels/brush_panel.hpp"

#include "panels/section.hpp"
#include "tools/hand.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
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

/// Enough for half a dozen tools; the others are scrolled to.
constexpr int kListHeight = 200;

/// Slider places per millisecond of smoothing and per millimetre of string.
constexpr int kMostSmoothing_ms = 400, kSmoothingStep_ms = 5;
constexpr int kLongestString_mm = 20;
constexpr int kPlacesPerMm = 2;

}  // namespace

BrushPanel::BrushPanel(const std::vector<QAction*>& own_actions, QWidget* parent)
    : QWidget(parent), list_(new BrushList) {
    keep_keys_for_canvas(list_);
    list_->setMinimumHeight(kListHeight);
    connect(list_, &BrushList::entry_clicked, this, [this] { take_next(0); });
    connect(list_, &BrushList::thumbnail_wanted, this, [this](int entry) {
        Q_EMIT thumbnail_wanted(brushes_[static_cast<std::size_t>(entry)].name);
    });
    auto* column = section(this, tr("Brush"));
    column->addWidget(list_, 1);
    column->addWidget(button_row(own_actions));
    column->addWidget(make_width_row());
    column->addWidget(make_stabiliser_rows());
}

void BrushPanel::show_brushes(std::vector<BrushEntry> brushes) {
    brushes_ = std::move(brushes);
    list_->show_entries(brushes_);
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
    width_->setFocusPolicy(Qt::StrongFocus);
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

QWidget* BrushPanel::make_stabiliser_rows() {
    auto* rows = new QWidget;
    auto* grid = new QGridLayout(rows);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    smoothing_ = add_slider(
        grid, tr("Steady"),
        tr("How far the brush lags behind to steady a trembling hand; 0 leaves it to the brush"),
        smoothing_reading_);
    smoothing_->setObjectName(QStringLiteral("smoothing"));
    smoothing_->setRange(0, kMostSmoothing_ms / kSmoothingStep_ms);
    string_ = add_slider(grid, tr("String"),
                         tr("Pulls the brush on a string of this length: wide curves without a tremor"),
                         string_reading_);
    string_->setObjectName(QStringLiteral("string"));
    string_->setRange(0, kLongestString_mm * kPlacesPerMm);
    write_readings();
    return rows;
}

QSlider* BrushPanel::add_slider(QGridLayout* grid, const QString& words, const QString& hint,
                                QLabel*& reading) {
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setToolTip(hint);
    keep_keys_for_canvas(slider);
    auto* label = new QLabel(words);
    label->setObjectName(QStringLiteral("reading"));
    reading = new QLabel;
    reading->setObjectName(QStringLiteral("reading"));
    reading->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    reading->setFixedWidth(54);
    const int row = grid->rowCount();
    grid->addWidget(label, row, 0);
    grid->addWidget(slider, row, 1);
    grid->addWidget(reading, row, 2);
    connect(slider, &QSlider::valueChanged, this, [this] {
        write_readings();
        Q_EMIT stabiliser_chosen(stabiliser());
    });
    return slider;
}

brush::Stabiliser BrushPanel::stabiliser() const {
    return {static_cast<double>(smoothing_->value() * kSmoothingStep_ms),
            static_cast<double>(string_->value()) / kPlacesPerMm};
}

void BrushPanel::write_readings() {
    const brush::Stabiliser shown = stabiliser();
    smoothing_reading_->setText(shown.smoothing_ms > 0.0 ? tr("%1 ms").arg(shown.smoothing_ms)
                                                         : tr("off"));
    string_reading_->setText(shown.string_mm > 0.0 ? tr("%1 mm").arg(shown.string_mm) : tr("off"));
}

void BrushPanel::show_stabiliser(const brush::Stabiliser& stabiliser) {
    const QSignalBlocker no_smoothing_signal(smoothing_);
    const QSignalBlocker no_string_signal(string_);
    smoothing_->setValue(static_cast<int>(std::lround(stabiliser.smoothing_ms / kSmoothingStep_ms)));
    string_->setValue(static_cast<int>(std::lround(stabiliser.string_mm * kPlacesPerMm)));
    write_readings();
}

void BrushPanel::show_brush(const QString& name, double width_mm) {
    const QSignalBlocker no_slider_signal(slider_);
    const QSignalBlocker no_width_signal(width_);
    slider_->setValue(slider_from_width(width_mm));
    width_->setValue(width_mm);
    const auto found = std::find_if(brushes_.begin(), brushes_.end(),
                                    [&](const BrushEntry& brush) { return brush.name == name; });
    list_->show_entry(static_cast<int>(found - brushes_.begin()));
}

void BrushPanel::take_next(int places) {
    const int count = static_cast<int>(brushes_.size());
    const int step = places < 0 ? -1 : 1;
    int entry = list_->current_entry() + places;
    for (int tried = 0; tried < count; ++tried, entry += step) {
        const BrushEntry& brush = brushes_[static_cast<std::size_t>((entry % count + count) % count)];
        if (brush.fault.isEmpty()) return void(Q_EMIT brush_taken(brush.name, brush.width_mm));
        if (places == 0) return void(Q_EMIT faulty_clicked(brush.fault));
    }
}

}  // namespace pastoso::panels
