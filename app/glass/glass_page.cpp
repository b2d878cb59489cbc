#include "glass/glass_page.hpp"

#include "appearance/shown_number.hpp"
#include "glass/glass_view.hpp"
#include "panels/parts/section.hpp"

#include <algorithm>
#include <cmath>

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

namespace pastoso::glass {

namespace {

constexpr int kNoteRoom_px = 60;  ///< at the upper edge of the view, where the glass does not reach

}  // namespace

GlassPage::GlassPage(GlassView* view, QWidget* panel, const GlassActions& actions,
                     const TimelineWords& words, QWidget* parent)
    : QWidget(parent), note_(new QLabel), busy_(words.busy) {
    setObjectName(words.name + QStringLiteral("_page"));
    note_->setObjectName(QStringLiteral("canvas_note"));
    note_->setAttribute(Qt::WA_TransparentForMouseEvents);
    note_->setAlignment(Qt::AlignCenter);
    note_->hide();
    auto* left = new QGridLayout;
    left->setSpacing(0);
    left->addWidget(view, 0, 0, 2, 1);
    left->addWidget(note_, 0, 0, Qt::AlignCenter);
    left->addWidget(timeline(actions, words), 2, 0);
    left->setRowMinimumHeight(0, kNoteRoom_px);
    left->setRowStretch(1, 1);
    auto* scrolled = new QScrollArea;
    scrolled->setFrameShape(QFrame::NoFrame);
    scrolled->setFocusPolicy(Qt::NoFocus);
    scrolled->setWidgetResizable(true);
    scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scrolled->setWidget(panel);
    scrolled->setFixedWidth(std::max(
        330, panel->minimumSizeHint().width() + scrolled->verticalScrollBar()->sizeHint().width()));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addLayout(left, 1);
    row->addWidget(scrolled);
    setFocusProxy(view);
}

QWidget* GlassPage::timeline(const GlassActions& actions, const TimelineWords& words) {
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
    time_->setObjectName(words.name + QStringLiteral("_time"));
    time_->setAccessibleName(words.what);
    time_->setToolTip(words.hint);
    panels::keep_keys_for_canvas(time_);
    panels::keep_own_keys(time_, {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down});
    connect(time_, &QSlider::valueChanged, this, &GlassPage::step_wanted);
    time_words_ = new QLabel;
    time_words_->setObjectName(words.name + QStringLiteral("_time_words"));
    readings_ = new QLabel;
    readings_->setObjectName(QStringLiteral("reading"));
    readings_->setToolTip(words.readings_hint);
    row->addWidget(time_, 1);
    row->addWidget(time_words_);
    row->addWidget(readings_);
    return bar;
}

void GlassPage::show_time(const session::LiquidStatus& status, const QString& amount, int decimals,
                          const QString& note) {
    const QSignalBlocker quiet(time_);
    time_->setRange(0, std::max(status.last_step, 1));
    time_->setPageStep(std::max(1, status.last_step / 20));
    if (!time_->isSliderDown()) time_->setValue(status.step);
    time_words_->setText(status.busy ? busy_
                         : status.shows_last
                             ? tr("%1 s").arg(appearance::shown_number(status.last_s, decimals))
                             : tr("%1 of %2 s")
                                   .arg(appearance::shown_number(status.time_s, decimals))
                                   .arg(appearance::shown_number(status.last_s, decimals)));
    readings_->setText(status.paused ? tr("%1   paused").arg(amount)
                       : note.isEmpty()
                           ? tr("%1   %2 steps/s").arg(amount).arg(std::lround(status.steps_per_s))
                           : amount);
    const QString over = status.paused ? tr("Paused") : note;
    note_->setText(over);
    note_->setVisible(!over.isEmpty());
}

}  // namespace pastoso::glass
