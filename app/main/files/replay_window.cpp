#include "main/files/replay_window.hpp"

#include "appearance/shown_message.hpp"
#include "main/queued_refresh.hpp"
#include "panels/history/recorder_panel.hpp"

#include <algorithm>
#include <utility>

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

namespace pastoso::main {
namespace {

struct Speed {
    const char* words;
    double speed;
};
constexpr Speed kSpeeds[] = {{QT_TR_NOOP("As it was painted"), 1.0},
                             {QT_TR_NOOP("4 times as fast"), 4.0},
                             {QT_TR_NOOP("16 times as fast"), 16.0},
                             {QT_TR_NOOP("As fast as possible"), session::kFullSpeed}};
constexpr int kFirstSpeed = 1;

QString time_of(std::int64_t tick) {
    return panels::time_words(static_cast<double>(tick) * document::kTick_s);
}

}  // namespace

ReplayWindow::ReplayWindow(document::Recording recording, const view::CanvasView& like, QWidget* parent)
    : WatchedWindow(tr("How it was painted"), like, parent) {
    add_controls(controls());
    connect(new QShortcut(Qt::Key_Space, this), &QShortcut::activated, play_, &QToolButton::click);
    replayer_ = std::make_unique<session::Replayer>(std::move(recording),
                                                    queued_refresh(this, [this] { show_published(); }));
    replayer_->set_speed(kSpeeds[kFirstSpeed].speed);
    show_published();
}

QWidget* ReplayWindow::controls() {
    auto* widget = new QWidget;
    auto* row = new QHBoxLayout(widget);
    row->setContentsMargins(12, 0, 12, 0);
    row->setSpacing(10);
    play_ = new QToolButton;
    play_->setObjectName(QStringLiteral("replay_play"));
    play_->setToolTip(tr("Play, or stop for a moment (Space)"));
    connect(play_, &QToolButton::clicked, this,
            [this] { replayer_->set_playing(!replayer_->status().playing); });
    connect(play_, &QToolButton::clicked, this, &ReplayWindow::show_published);
    place_ = new QSlider(Qt::Horizontal);
    place_->setObjectName(QStringLiteral("replay_place"));
    place_->setAccessibleName(tr("Moment of the painting"));
    place_->setToolTip(tr("Drag to any moment of the painting"));
    connect(place_, &QSlider::valueChanged, this, [this](int tick) { replayer_->seek(tick); });
    time_ = new QLabel;
    time_->setObjectName(QStringLiteral("replay_time"));
    time_->setMinimumWidth(time_->fontMetrics().averageCharWidth() * 22);
    time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    speed_ = new QComboBox;
    speed_->setObjectName(QStringLiteral("replay_speed"));
    speed_->setAccessibleName(tr("Speed"));
    for (const Speed& speed : kSpeeds)
        speed_->addItem(QCoreApplication::translate("pastoso::main", speed.words));
    speed_->setCurrentIndex(kFirstSpeed);
    connect(speed_, &QComboBox::currentIndexChanged, this,
            [this](int row_of_speed) { replayer_->set_speed(kSpeeds[row_of_speed].speed); });
    row->addWidget(play_);
    row->addWidget(place_, 1);
    row->addWidget(time_);
    row->addWidget(speed_);
    return widget;
}

void ReplayWindow::show_published() {
    const session::Replayer::Status status = replayer_->status();
    if (const auto painting = replayer_->snapshot()) canvas().show_snapshot(painting);
    play_->setText(status.playing ? tr("Pause") : tr("Play"));
    if (!status.error.empty()) {
        time_->setText(tr("It cannot be shown any further"));
        time_->setToolTip(appearance::shown_message(status.error));
    } else {
        time_->setText(tr("%1 of %2").arg(time_of(status.tick), time_of(status.end_tick)));
    }
    const QSignalBlocker quiet(place_);
    place_->setRange(0, static_cast<int>(status.end_tick));
    place_->setPageStep(std::max(1, static_cast<int>(status.end_tick / 20)));
    if (!place_->isSliderDown() && !status.seeking) place_->setValue(static_cast<int>(status.tick));
}

}  // namespace pastoso::main
