#include "panels/history/recorder_panel.hpp"

#include "panels/parts/section.hpp"

#include <cmath>

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace pastoso::panels {

QString time_words(double seconds) {
    const auto whole = static_cast<qint64>(std::floor(seconds));
    const auto two = [](qint64 number) { return QString::number(number).rightJustified(2, '0'); };
    const QString rest = two(whole % 60);
    if (whole < 3600) return QStringLiteral("%1:%2").arg(whole / 60).arg(rest);
    return QStringLiteral("%1:%2:%3").arg(whole / 3600).arg(two(whole / 60 % 60), rest);
}

RecorderPanel::RecorderPanel(const std::vector<QAction*>& actions, QWidget* parent)
    : QWidget(parent), strokes_(new QLabel), time_(new QLabel) {
    auto* column = new QVBoxLayout(this);
    column->setSpacing(12);
    auto* recorded = new QWidget;
    auto* grid_widget = new QWidget;
    auto* grid = new QGridLayout(grid_widget);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    const auto add = [&](const QString& words, const char* name, QLabel* number) {
        auto* label = new QLabel(words);
        label->setObjectName(QStringLiteral("reading"));
        number->setObjectName(QString::fromLatin1(name));
        number->setAlignment(Qt::AlignRight);
        grid->addWidget(label, grid->rowCount(), 0);
        grid->addWidget(number, grid->rowCount() - 1, 1);
    };
    add(tr("Strokes"), "recorded_strokes", strokes_);
    add(tr("Painting time"), "recorded_time", time_);
    section(recorded, tr("Recorded so far"))->addWidget(grid_widget);
    column->addWidget(recorded);
    auto* uses = new QWidget;
    auto* buttons = new QVBoxLayout(uses);
    buttons->setContentsMargins(0, 0, 0, 0);
    buttons->setSpacing(4);
    for (QAction* action : actions)
        buttons->addWidget(button_row({action}));
    column->addWidget(uses);
    column->addStretch(1);
    show_recorded(0, 0.0);
}

void RecorderPanel::show_recorded(std::int64_t strokes, double painted_s) {
    strokes_->setText(QString::number(strokes));
    time_->setText(time_words(painted_s));
}

}  // namespace pastoso::panels
