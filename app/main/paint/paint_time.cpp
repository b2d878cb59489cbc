#include "main/paint/paint_time.hpp"

#include "panels/parts/status_readings.hpp"

#include <algorithm>
#include <iterator>

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QStyle>

namespace pastoso::main {
namespace {

using commands::Command;

/// Of paint time against the clock.
constexpr double kSpeeds[] = {1.0, 2.0, 5.0, 10.0, session::kMostSpeed};
constexpr int kFastest = static_cast<int>(std::size(kSpeeds)) - 1;

constexpr int kNoteMargin_px = 12;

}  // namespace

PaintTime::PaintTime(Studio& studio, const PanelSet& panels)
    : studio_(studio), panels_(panels), note_(new QLabel(&studio.canvas())) {
    note_->setObjectName(QStringLiteral("canvas_note"));
    note_->setAttribute(Qt::WA_TransparentForMouseEvents);
    note_->move(kNoteMargin_px, kNoteMargin_px);
    connect_commands();
    fill_box();
    connect(panels_.time, &QComboBox::activated, this, &PaintTime::use);
    connect(&studio_, &Studio::session_begun, this,
            [this] { studio_.session().set_speed(kSpeeds[chosen_]); });
    connect(&studio_, &Studio::published, this, &PaintTime::show_note);
    show();
}

void PaintTime::connect_commands() {
    const commands::CommandRegistry& commands = studio_.commands();
    commands.on(Command::Pause, [this](bool paused) { pause(paused); });
    commands.on(Command::TimeFaster, [this](bool) { step(1); });
    commands.on(Command::TimeSlower, [this](bool) { step(-1); });
    commands.on(Command::TimeReal, [this](bool) { use(0); });
    connect(commands.action(Command::CanvasOnly), &QAction::toggled, this, &PaintTime::show_note,
            Qt::QueuedConnection);
}

void PaintTime::fill_box() {
    for (const double speed : kSpeeds)
        panels_.time->addItem(QStringLiteral("%1 ×").arg(speed));
}

void PaintTime::pause(bool paused) {
    studio_.session().set_paused(paused);
    panels_.readings->show_status(studio_.session().status());
}

void PaintTime::step(int steps) {
    use(std::clamp(chosen_ + steps, 0, kFastest));
}

void PaintTime::use(int index) {
    chosen_ = index;
    studio_.session().set_speed(kSpeeds[chosen_]);
    show();
}

void PaintTime::show() {
    QComboBox* box = panels_.time;
    box->setCurrentIndex(chosen_);
    box->setProperty("fast", chosen_ > 0);
    box->style()->polish(box);
    const commands::CommandRegistry& commands = studio_.commands();
    commands.action(Command::TimeFaster)->setEnabled(chosen_ < kFastest);
    commands.action(Command::TimeSlower)->setEnabled(chosen_ > 0);
    note_->setText(tr("%1 × time").arg(kSpeeds[chosen_]));
    note_->adjustSize();
    show_note();
}

void PaintTime::show_note() {
    note_->setVisible(chosen_ > 0 && !panels_.time->isVisible());
}

}  // namespace pastoso::main
