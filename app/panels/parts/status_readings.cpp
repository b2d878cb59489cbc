#include "panels/parts/status_readings.hpp"

#include "appearance/shown_number.hpp"
#include "core/memory.hpp"
#include "document/canvas.hpp"

#include <cmath>

#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLabel>

namespace pastoso::panels {

StatusReadings::StatusReadings(QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    pointer_ = add(17, tr("The pen's place on the canvas, from its upper left corner"));
    activity_ = add(26, tr("Whether paint still moves, and how much of its time this computer works "
                           "on it"));
    activity_->setObjectName(QStringLiteral("activity"));
    speed_ = add(
        13, tr("Paint time against the clock: less than you set where there is more wet paint than this "
               "computer can move in time"));
    selection_ = add(0, tr("Tools keep to what is outlined; Ctrl+A ends the selection, Esc goes back to "
                           "painting"));
    selection_->setObjectName(QStringLiteral("selection"));
    selection_->setIndent(selection_->fontMetrics().averageCharWidth() * 3);
    show_selection({}, std::nullopt);
    memory_ = add(9, tr("Memory that the program holds: the painting, its history and its pictures"));
    memory_->setObjectName(QStringLiteral("memory"));
    canvas_ = add(32, tr("Size of the canvas and of its saved picture"));
    look_ = add(0, tr("What the canvas shows; Alt+1 shows it in its light again"));
    look_->setObjectName(QStringLiteral("look"));
    look_->hide();
    turn_ = add(0, tr("How the canvas stands on the screen; 5 puts it upright, M mirrors it"));
    turn_->setObjectName(QStringLiteral("turn"));
    turn_->hide();
    zoom_ = add(7, tr("Screen pixels for a pixel of the saved picture"));
    constexpr int kMemoryInterval_ms = 2000;
    connect(&memory_looked_at_, &QTimer::timeout, this, &StatusReadings::show_memory);
    memory_looked_at_.start(kMemoryInterval_ms);
    show_memory();
}

QLabel* StatusReadings::add(int width_characters, const QString& hint) {
    auto* label = new QLabel;
    label->setMinimumWidth(label->fontMetrics().averageCharWidth() * width_characters);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setToolTip(hint);
    layout()->addWidget(label);
    return label;
}

void StatusReadings::show_canvas(const document::CanvasSettings& canvas) {
    const grid::Shape shape = document::canvas_shape(canvas);
    canvas_->setText(tr("%1 × %2 mm   %3 × %4 px")
                         .arg(appearance::shown_number(canvas.width_mm))
                         .arg(appearance::shown_number(canvas.height_mm))
                         .arg(shape.width)
                         .arg(shape.height));
}

void StatusReadings::show_view(double zoom, double angle_deg, bool mirrored) {
    QStringList turn;
    const double shown_deg = 0.1 * std::round(10.0 * angle_deg);
    if (mirrored) turn += tr("mirrored");
    if (shown_deg != 0.0) turn += tr("turned %1°").arg(appearance::shown_number(shown_deg));
    turn_->setText(turn.join(QStringLiteral(", ")));
    turn_->setVisible(!turn.isEmpty());
    const double percent = 100.0 * zoom;
    zoom_->setText(appearance::shown_number(percent, percent < 10.0 ? 1 : 0) + " %");
}

void StatusReadings::show_look(const QString& words) {
    look_->setText(words);
    look_->setVisible(!words.isEmpty());
}

void StatusReadings::show_pointer(std::optional<QPointF> position_mm) {
    pointer_->setText(position_mm ? tr("%1, %2 mm")
                                        .arg(appearance::shown_number(position_mm->x(), 1))
                                        .arg(appearance::shown_number(position_mm->y(), 1))
                                  : QString());
}

void StatusReadings::show_status(const session::Status& status) {
    if (status.paused) {
        activity_->setText(tr("paused"));
        speed_->clear();
        return;
    }
    activity_->setText(status.awake_tiles == 0
                           ? tr("paint at rest")
                           : tr("paint moving, %1 % busy").arg(std::lround(100.0 * status.load)));
    const double speed = status.paint_per_wall;
    speed_->setText(tr("%1 × time").arg(appearance::shown_number(speed, speed < 0.095 ? 3 : 2)));
}

void StatusReadings::show_speed(bool shown) {
    speed_->setVisible(shown);
}

void StatusReadings::show_memory() {
    const double GiB = static_cast<double>(core::resident_memory_bytes()) / (1 << 30);
    memory_->setText(GiB < 1.0 ? tr("%1 MB").arg(std::lround(1024.0 * GiB))
                               : tr("%1 GB").arg(appearance::shown_number(GiB, 1)));
}

void StatusReadings::show_selection(const QString& drawing, std::optional<double> share) {
    QStringList parts;
    if (!drawing.isEmpty()) parts += drawing;
    const double percent = 100.0 * share.value_or(0.0);
    if (share)
        parts += tr("%1 % selected").arg(appearance::shown_number(percent, percent < 9.95 ? 1 : 0));
    selection_->setText(parts.join(QStringLiteral(", ")));
    selection_->setVisible(!parts.isEmpty());
}

}  // namespace pastoso::panels
