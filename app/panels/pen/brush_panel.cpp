#include "panels/pen/brush_panel.hpp"

#include "appearance/shown_number.hpp"
#include "appearance/terms.hpp"
#include "appearance/unit_box.hpp"
#include "panels/parts/section.hpp"
#include "tools/hand.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
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

/// One tool on the lowest of screens; higher ones show more of them.
constexpr int kLeastListHeight = 38;

/// Six tools and the heading of a family on a screen 800 pixels high.
constexpr int kSpacing = 4;

/// Around the digits of a box and of a reading.
constexpr int kBoxEdges = 12, kReadingEdges = 6;

/// Places of the strength's slider.
constexpr int kSmoothingStep_ms = 5;
constexpr int kPlacesPerMm = 2;

using tools::SteadyMode;

}  // namespace

BrushPanel::BrushPanel(const std::vector<QAction*>& own_actions, QWidget* parent)
    : QWidget(parent), finder_(new BrushFinder), list_(new BrushList) {
    list_->setAccessibleName(tr("Brush"));
    list_->setMinimumHeight(kLeastListHeight);
    list_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);  // all that is left, no more
    connect(list_, &BrushList::entry_clicked, this, [this] { take_next(0); });
    connect(list_, &BrushList::thumbnail_wanted, this, &BrushPanel::want_thumbnail);
    connect(list_, &BrushList::rename_wanted, this, &BrushPanel::rename_wanted);
    connect(list_, &BrushList::removal_wanted, this, &BrushPanel::removal_wanted);
    // Only when the list is through with the drop may its entries be made anew.
    connect(list_, &BrushList::arranged, this, &BrushPanel::tell_arranged, Qt::QueuedConnection);
    connect(list_, &QWidget::customContextMenuRequested, this, &BrushPanel::offer_tags);
    connect(finder_, &BrushFinder::changed, this, &BrushPanel::list_chosen);
    connect(finder_, &BrushFinder::first_wanted, this, [this] {
        list_->show_entry(-1);
        take_next(1);
    });
    std::vector<QToolButton*> own_buttons;
    for (QAction* action : own_actions)
        own_buttons.push_back(small_button(action));
    auto* column = section(this, tr("Brush"), own_buttons);
    column->setSpacing(kSpacing);
    column->addWidget(finder_);
    column->addWidget(list_, 1);
    column->addWidget(make_width_row());
    column->addWidget(make_stabiliser_rows());
}

void BrushPanel::show_brushes(std::vector<BrushEntry> brushes) {
    brushes_ = std::move(brushes);
    asked_.clear();
    thumbnails_.clear();
    finder_->show_folders(brushes_, shelf_.tags);
    list_chosen();
}

void BrushPanel::show_shelf(const tools::BrushShelf& shelf) {
    tools::BrushShelf unlisted = shelf_;
    unlisted.recent = shelf.recent;
    const bool same = unlisted == shelf;
    shelf_ = shelf;
    if (same) return;
    finder_->show_folders(brushes_, shelf_.tags);
    list_chosen();
}

/// Listed anew first: a tool that was dropped among another family is back in its own.
void BrushPanel::tell_arranged() {
    const QStringList names = list_->names();
    list_chosen();
    Q_EMIT arranged(finder_->choice(), names);
}

/// Of the tool under the pointer.
void BrushPanel::offer_tags(const QPoint& place) {
    const QString tool = list_->name_at(place);
    if (tool.isEmpty()) return;
    QMenu menu;
    menu.addSection(tr("Tags"));
    for (const tools::BrushTag& tag : shelf_.tags) {
        const auto name = QString::fromStdString(tag.name);
        QAction* choice =
            menu.addAction(QString(name).replace('&', QLatin1String("&&")), this,
                           [this, tool, name](bool has) { Q_EMIT tagged(tool, name, has); });
        choice->setCheckable(true);
        choice->setChecked(std::ranges::find(tag.tools, tool.toStdString()) != tag.tools.end());
    }
    menu.addAction(tr("New tag..."), this, [this, tool] { Q_EMIT new_tag_wanted(tool); });
    menu.exec(list_->viewport()->mapToGlobal(place));
}

void BrushPanel::list_chosen() {
    listed_ = chosen_brushes(brushes_, shelf_, finder_->choice());
    if (listed_.empty())
        list_->show_none(finder_->words_of_none());
    else
        list_->show_entries(listed_);
    mark_in_hand();
}

void BrushPanel::mark_in_hand() {
    const auto found = std::find_if(listed_.begin(), listed_.end(),
                                    [this](const BrushEntry& brush) { return brush.name == in_hand_; });
    list_->show_entry(static_cast<int>(found - listed_.begin()));
}

void BrushPanel::show_thumbnail(const QString& name, const QImage& image) {
    thumbnails_[name] = image;
    list_->set_thumbnail(name, image);
}

/// One that was painted before is shown again.
void BrushPanel::want_thumbnail(int entry) {
    const QString& name = listed_[static_cast<std::size_t>(entry)].name;
    const auto known = thumbnails_.find(name);
    if (known != thumbnails_.end()) list_->set_thumbnail(name, known->second);
    if (asked_.insert(name).second) Q_EMIT thumbnail_wanted(name);
}

QWidget* BrushPanel::make_width_row() {
    slider_ = new QSlider(Qt::Horizontal);
    slider_->setRange(0, kSliderSteps);
    width_ =
        new appearance::UnitBox(appearance::read_length_mm, QStringLiteral("brush_width"), tr(" mm"));
    width_->setRange(tools::kSmallestBrush_mm, tools::kLargestBrush_mm);
    width_->setDecimals(1);
    width_->setStepType(QAbstractSpinBox::DefaultStepType);
    width_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    width_->setAlignment(Qt::AlignRight);
    width_->setFixedWidth(fontMetrics().horizontalAdvance(tr("%1 mm").arg(QStringLiteral("200.0"))) +
                          kBoxEdges);
    width_->setKeyboardTracking(false);
    width_->setFocusPolicy(Qt::StrongFocus);
    width_->setToolTip(tr("Width of the brush's tip  ([ and ])"));
    slider_->setToolTip(width_->toolTip());
    for (QWidget* control : {static_cast<QWidget*>(slider_), static_cast<QWidget*>(width_)})
        control->setAccessibleName(tr("Width of the brush's tip"));
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
    auto* label = new QLabel(tr("Steady"));
    label->setObjectName(QStringLiteral("reading"));
    appearance::explain(label, appearance::Term::Steadying);
    steady_mode_ = new QComboBox;
    steady_mode_->setObjectName(QStringLiteral("steady_mode"));
    steady_mode_->setAccessibleName(tr("How the hand is steadied"));
    appearance::explain(steady_mode_, appearance::Term::Steadying);
    steady_mode_->addItem(tr("off"), static_cast<int>(SteadyMode::Off));
    steady_mode_->addItem(tr("lags behind"), static_cast<int>(SteadyMode::Time));
    steady_mode_->addItem(tr("pulled on a string"), static_cast<int>(SteadyMode::String));
    let_shrink(steady_mode_);
    keep_keys_for_canvas(steady_mode_);
    strength_ = new QSlider(Qt::Horizontal);
    strength_->setObjectName(QStringLiteral("steady_strength"));
    strength_->setAccessibleName(tr("How much the hand is steadied"));
    strength_->setToolTip(strength_->accessibleName());
    keep_keys_for_canvas(strength_);
    strength_reading_ = new QLabel;
    strength_reading_->setObjectName(QStringLiteral("reading"));
    strength_reading_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    strength_reading_->setFixedWidth(
        fontMetrics().horizontalAdvance(tr("%1 mm").arg(QStringLiteral("00.0"))) + kReadingEdges);
    grid->addWidget(label, 0, 0);
    grid->addWidget(steady_mode_, 0, 1, 1, 2);
    grid->addWidget(strength_, 1, 0, 1, 2);
    grid->addWidget(strength_reading_, 1, 2);
    grid->setColumnStretch(1, 1);
    connect(steady_mode_, &QComboBox::activated, this, [this] {
        steadying_.mode = static_cast<SteadyMode>(steady_mode_->currentData().toInt());
        write_steadying();
        Q_EMIT stabiliser_chosen(tools::stabiliser_of(steadying_));
    });
    connect(strength_, &QSlider::valueChanged, this, &BrushPanel::take_strength);
    write_steadying();
    return rows;
}

void BrushPanel::take_strength(int place) {
    if (steadying_.mode == SteadyMode::Time) steadying_.smoothing_ms = place * kSmoothingStep_ms;
    if (steadying_.mode == SteadyMode::String)
        steadying_.string_mm = static_cast<double>(place) / kPlacesPerMm;
    write_steadying();
    Q_EMIT stabiliser_chosen(tools::stabiliser_of(steadying_));
}

/// The slider measures what the mode has: milliseconds or millimetres.
void BrushPanel::write_steadying() {
    const QSignalBlocker no_mode_signal(steady_mode_);
    const QSignalBlocker no_strength_signal(strength_);
    steady_mode_->setCurrentIndex(steady_mode_->findData(static_cast<int>(steadying_.mode)));
    strength_->setEnabled(steadying_.mode != SteadyMode::Off);
    strength_->setVisible(steadying_.mode != SteadyMode::Off);
    strength_reading_->setVisible(steadying_.mode != SteadyMode::Off);
    if (steadying_.mode == SteadyMode::String) {
        strength_->setRange(1, static_cast<int>(tools::kLongestString_mm) * kPlacesPerMm);
        strength_->setValue(static_cast<int>(std::lround(steadying_.string_mm * kPlacesPerMm)));
        strength_->setToolTip(tr("Length of the string: wide curves without a tremor"));
        strength_reading_->setText(tr("%1 mm").arg(appearance::shown_number(steadying_.string_mm)));
    } else {
        strength_->setRange(1, static_cast<int>(tools::kMostSmoothing_ms) / kSmoothingStep_ms);
        strength_->setValue(static_cast<int>(std::lround(steadying_.smoothing_ms / kSmoothingStep_ms)));
        strength_->setToolTip(tr("How far the brush lags behind the hand"));
        strength_reading_->setText(
            steadying_.mode == SteadyMode::Off ? QString() : tr("%1 ms").arg(steadying_.smoothing_ms));
    }
}

void BrushPanel::show_steadying(const tools::Steadying& steadying) {
    steadying_ = steadying;
    write_steadying();
}

void BrushPanel::show_stabiliser(const brush::Stabiliser& stabiliser) {
    if (stabiliser == tools::stabiliser_of(steadying_)) return;
    show_steadying(tools::with_stabiliser(steadying_, stabiliser));
}

void BrushPanel::show_brush(const QString& name, double width_mm) {
    const QSignalBlocker no_slider_signal(slider_);
    const QSignalBlocker no_width_signal(width_);
    slider_->setValue(slider_from_width(width_mm));
    width_->setValue(width_mm);
    in_hand_ = name;
    mark_in_hand();
}

void BrushPanel::take_next(int places) {
    const int count = static_cast<int>(listed_.size());
    const int step = places < 0 ? -1 : 1;
    int entry = list_->current_entry() + places;
    for (int tried = 0; tried < count; ++tried, entry += step) {
        const BrushEntry& brush = listed_[static_cast<std::size_t>((entry % count + count) % count)];
        if (brush.fault.isEmpty()) return void(Q_EMIT brush_taken(brush.name, brush.width_mm));
        if (places == 0) return void(Q_EMIT faulty_clicked(brush.fault));
    }
}

}  // namespace pastoso::panels
