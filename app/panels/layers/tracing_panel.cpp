#include "panels/layers/tracing_panel.hpp"

#include "appearance/picture_view.hpp"
#include "appearance/unit_box.hpp"
#include "document/actions/actions.hpp"
#include "panels/colour/picture_board.hpp"
#include "panels/parts/section.hpp"
#include "panels/parts/value_row.hpp"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr int kRest_ms = 250;

constexpr double kNarrowest_mm = 1.0;

QImage image_of(const pigment::Picture& picture) {
    return appearance::view_of_rgba(picture.rgba, picture.width, picture.height);
}

}  // namespace

TracingPanel::TracingPanel(const std::vector<QAction*>& picture, const std::vector<QAction*>& place,
                           QWidget* parent)
    : QWidget(parent), board_(new PictureBoard) {
    board_->setObjectName(QStringLiteral("tracing_board"));
    board_->setAccessibleName(tr("Picture to trace"));
    board_->setToolTip(
        tr("Click: paint of that colour\nWheel: closer, farther\nDrag: move the picture\n0: all of it"));
    auto* column = new QVBoxLayout(this);
    column->setSpacing(6);
    column->addWidget(board_, 1);
    column->addWidget(button_row(picture));
    auto* values = new QWidget;
    make_rows(values);
    column->addWidget(values);
    column->addWidget(button_row(place));
    resting_.setSingleShot(true);
    resting_.setInterval(kRest_ms);
    connect(&resting_, &QTimer::timeout, this, [this] { Q_EMIT rested(chosen()); });
    connect(board_, &PictureBoard::colour_picked, this, &TracingPanel::colour_picked);
    show_values();
}

void TracingPanel::make_rows(QWidget* parent) {
    auto* grid = new QGridLayout(parent);
    grid->setContentsMargins(0, 0, 0, 0);
    opacity_ = new ValueRow(grid, QStringLiteral("tracing_opacity"), tr("Opacity"),
                            tr("How strongly it shows below the paint"), {0.0, 100.0, 0, tr(" %")});
    connect(opacity_, &ValueRow::chosen, this, &TracingPanel::value_chosen);
    const auto number = [&](const QString& words, const QString& hint, double least_mm,
                            const char* name) {
        auto* box =
            new appearance::UnitBox(appearance::read_length_mm, QString::fromLatin1(name), tr(" mm"));
        box->setAccessibleName(words);
        box->setToolTip(hint);
        box->setRange(least_mm, document::kMaxPenPosition_mm);
        box->setDecimals(1);
        box->setStepType(QAbstractSpinBox::DefaultStepType);
        box->setKeyboardTracking(false);
        box->setAlignment(Qt::AlignRight);
        auto* label = new QLabel(words);
        label->setObjectName(QStringLiteral("reading"));
        const int line = grid->rowCount();
        grid->addWidget(label, line, 0);
        grid->addWidget(box, line, 1, 1, 2);
        connect(box, &QDoubleSpinBox::valueChanged, this, &TracingPanel::value_chosen);
        return box;
    };
    const double farthest_mm = document::kMaxPenPosition_mm;
    x_ = number(tr("From the left"), tr("Where its left edge lies on the canvas"), -farthest_mm,
                "tracing_x");
    y_ = number(tr("From above"), tr("Where its upper edge lies on the canvas"), -farthest_mm,
                "tracing_y");
    width_ = number(tr("Width"), tr("Its height follows in proportion"), kNarrowest_mm, "tracing_width");
}

void TracingPanel::show_tracing(const std::shared_ptr<const layers::Tracing>& tracing) {
    if (tracing == shown_) return;
    const bool same_picture =
        tracing != nullptr && shown_ != nullptr && tracing->picture == shown_->picture;
    shown_ = tracing;
    if (!same_picture) board_->show_picture(shown_ ? image_of(*shown_->picture) : QImage());
    if (!resting_.isActive()) show_values();
}

void TracingPanel::show_values() {
    opacity_->setEnabled(shown_ != nullptr);
    for (QDoubleSpinBox* box : {x_, y_, width_})
        box->setEnabled(shown_ != nullptr);
    if (shown_ == nullptr) return;
    opacity_->show_value(100.0 * shown_->opacity);
    show_number(x_, shown_->place.x_mm);
    show_number(y_, shown_->place.y_mm);
    show_number(width_, shown_->place.width_mm);
}

void TracingPanel::value_chosen() {
    if (shown_ == nullptr) return;
    resting_.start();
    Q_EMIT moved(chosen());
}

void TracingPanel::finish() {
    if (!resting_.isActive()) return;
    resting_.stop();
    Q_EMIT rested(chosen());
}

document::SetTracing TracingPanel::chosen() const {
    if (shown_ == nullptr) return {};
    const double proportion = shown_->place.height_mm / shown_->place.width_mm;
    return {{x_->value(), y_->value(), width_->value(), proportion * width_->value()},
            0.01 * opacity_->value()};
}

}  // namespace pastoso::panels
