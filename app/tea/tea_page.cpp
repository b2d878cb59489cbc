#include "tea/tea_page.hpp"

#include "panels/section.hpp"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

namespace pastoso::tea {

TeaPage::TeaPage(const TeaActions& actions, QWidget* parent)
    : QWidget(parent), view_(new TeaView), panel_(new TeaPanel(actions)) {
    setObjectName(QStringLiteral("tea_page"));
    auto* left = new QVBoxLayout;
    left->setSpacing(0);
    left->addWidget(view_, 1);
    left->addWidget(timeline(actions));
    auto* scrolled = new QScrollArea;
    scrolled->setFrameShape(QFrame::NoFrame);
    scrolled->setFocusPolicy(Qt::NoFocus);
    scrolled->setWidgetResizable(true);
    scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scrolled->setWidget(panel_);
    scrolled->setFixedWidth(std::max(
        330, panel_->minimumSizeHint().width() + scrolled->verticalScrollBar()->sizeHint().width()));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addLayout(left, 1);
    row->addWidget(scrolled);
    setFocusProxy(view_);
}

QWidget* TeaPage::timeline(const TeaActions& actions) {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(10, 6, 10, 6);
    row->setSpacing(8);
    for (QAction* action : {actions.pause, actions.full_speed, actions.front}) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        panels::keep_keys_for_canvas(button);
        row->addWidget(button);
    }
    time_ = new QSlider(Qt::Horizontal);
    time_->setObjectName(QStringLiteral("tea_time"));
    time_->setAccessibleName(tr("Moment of the tea"));
    time_->setToolTip(tr("Drag to any moment of the glass; going on goes on from its last"));
    panels::keep_keys_for_canvas(time_);
    panels::keep_own_keys(time_, {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down});
    connect(time_, &QSlider::valueChanged, this, &TeaPage::step_wanted);
    time_words_ = new QLabel;
    time_words_->setObjectName(QStringLiteral("tea_time_words"));
    readings_ = new QLabel;
    readings_->setObjectName(QStringLiteral("reading"));
    readings_->setToolTip(tr("Milk poured so far, and how many steps of 1/30 s a second are computed"));
    row->addWidget(time_, 1);
    row->addWidget(time_words_);
    row->addWidget(readings_);
    return bar;
}

void TeaPage::show_status(const session::TeaStatus& status) {
    const QSignalBlocker quiet(time_);
    time_->setRange(0, std::max(status.last_step, 1));
    time_->setPageStep(std::max(1, status.last_step / 20));
    if (!time_->isSliderDown()) time_->setValue(status.step);
    time_words_->setText(
        status.busy ? tr("Filling the glass...")
        : status.shows_last
            ? tr("%1 s").arg(status.last_s, 0, 'f', 1)
            : tr("%1 of %2 s").arg(status.time_s, 0, 'f', 1).arg(status.last_s, 0, 'f', 1));
    readings_->setText(tr("%1 ml of milk   %2 steps/s")
                           .arg(1e6 * status.milk_m3, 0, 'f', 1)
                           .arg(std::lround(status.steps_per_s)));
}

}  // namespace pastoso::tea
