#include "main/paint/keeping_up.hpp"

#include "panels/messages/pace_notice.hpp"
#include "panels/parts/status_readings.hpp"

#include <QAction>
#include <QMainWindow>
#include <QStatusBar>

namespace pastoso::main {

using commands::Command;

KeepingUp::KeepingUp(Studio& studio, panels::StatusReadings* readings)
    : studio_(studio), readings_(readings), notice_(make_notice()) {
    QStatusBar* bar = studio_.window().statusBar();
    bar->insertPermanentWidget(0, notice_, 1);
    connect(bar, &QStatusBar::messageChanged, this, &KeepingUp::show);
    connect(notice_, &panels::PaceNotice::sentence_changed, this, &KeepingUp::show);
    constexpr int kInterval_ms = 250;
    connect(&looked_at_, &QTimer::timeout, this, &KeepingUp::look);
    looked_at_.setInterval(kInterval_ms);
    connect(&studio_, &Studio::published, this, [this](const auto&, const session::Status& status) {
        if (status.awake_tiles > 0 && !looked_at_.isActive()) looked_at_.start();
    });
    clock_.start();
}

panels::PaceNotice* KeepingUp::make_notice() const {
    using Choice = panels::PaceNotice::Choice;
    const auto choice = [this](Command command, const QString& words) {
        return Choice{.action = studio_.commands().action(command), .words = words};
    };
    Choice real_time = choice(Command::TimeReal, tr("Real time"));
    real_time.real_time = false;
    Choice thin_less = choice(Command::MorePaint, tr("Thin less"));
    thin_less.faster_time = false;
    return new panels::PaceNotice(
        {real_time, choice(Command::Pause, tr("Pause")), choice(Command::DryNow, tr("Dry")), thin_less});
}

void KeepingUp::look() {
    const session::Status status = studio_.session().status();
    notice_->look(status, 1e-3 * static_cast<double>(clock_.elapsed()));
    if (status.awake_tiles == 0 && notice_->sentence().isEmpty()) looked_at_.stop();
}

/// Messages pass in the same place, and have it first; readings that would cut one give way.
void KeepingUp::show() {
    constexpr int kEdges_px = 60;  // the message's, and the button beside it
    const QStatusBar* bar = studio_.window().statusBar();
    const QString message = bar->currentMessage();
    const bool free = message.isEmpty();
    const int needed_px = bar->fontMetrics().horizontalAdvance(message) + kEdges_px;
    readings_->setVisible(free || needed_px + readings_->sizeHint().width() <= bar->width());
    const bool tells = free && !notice_->sentence().isEmpty();
    readings_->show_speed(!tells);
    notice_->setVisible(tells);
}

}  // namespace pastoso::main
