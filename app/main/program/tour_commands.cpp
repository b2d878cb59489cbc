#include "main/program/tour_commands.hpp"

#include "commands/command_words.hpp"
#include "help/tour_bubble.hpp"
#include "panels/paint/paint_panel.hpp"

#include <array>

#include <QAction>
#include <QEvent>
#include <QMainWindow>

namespace pastoso::main {
namespace {

using commands::Command;

constexpr int kSteps = 3;

/// Its key, as the painter has it; the name of a command that has none.
QString how_to(const commands::CommandRegistry& commands, Command command) {
    const QKeySequence key = commands.action(command)->shortcut();
    if (!key.isEmpty()) return key.toString(QKeySequence::NativeText);
    return QStringLiteral("\"%1\"").arg(commands::plain_words(commands::text_of(command).words));
}

help::TourStep step(const commands::CommandRegistry& commands, int number) {
    const std::array<help::TourStep, kSteps> steps = {
        help::TourStep{
            TourCommands::tr("Paint"),
            TourCommands::tr("Press on the canvas and drag: the brush lays wet paint, and drags "
                             "along what is wet already. A pen that presses harder bends the "
                             "hairs further.")},
        help::TourStep{
            TourCommands::tr("Move the canvas, and pick paint from it"),
            TourCommands::tr("Hold Space and drag to move the canvas; the wheel goes nearer. "
                             "Ctrl and a click put the paint under the pointer on your brush.")},
        help::TourStep{
            TourCommands::tr("Take another paint, and take a stroke back"),
            TourCommands::tr("Choose a paint here. %1 loads the brush anew, %2 takes the last "
                             "stroke back.")
                .arg(how_to(commands, Command::ReloadBrush), how_to(commands, Command::Undo))}};
    help::TourStep found = steps[static_cast<std::size_t>(number)];
    found.number = number + 1;
    found.of = kSteps;
    return found;
}

}  // namespace

TourCommands::TourCommands(Studio& studio, const PanelSet& panels) : studio_(studio), panels_(panels) {
    studio_.commands().on(Command::Tour, [this](bool) { begin(); });
    connect(&studio_.canvas(), &view::CanvasView::escaped, this, &TourCommands::end);
    studio_.canvas().installEventFilter(this);
}

void TourCommands::begin() {
    end();
    bubble_ = new help::TourBubble(&studio_.window());
    connect(bubble_, &help::TourBubble::next_wanted, this, &TourCommands::go_on);
    connect(bubble_, &help::TourBubble::left, this, &TourCommands::end);
    seen_ = true;
    step_ = 0;
    show_step();
}

void TourCommands::begin_at_first_start(bool canvas_is_free) {
    waits_ = !seen_;
    if (canvas_is_free) canvas_freed();
}

/// What freed it, a key or a press, is done with first.
void TourCommands::canvas_freed() {
    if (waits_) QMetaObject::invokeMethod(this, &TourCommands::begin, Qt::QueuedConnection);
    waits_ = false;
}

/// The canvas takes the keys, as if the tour had never been there.
void TourCommands::end() {
    if (bubble_ == nullptr) return;
    bubble_->hide();
    bubble_->deleteLater();
    bubble_.clear();
    studio_.canvas().setFocus();
}

void TourCommands::go_on() {
    ++step_;
    if (step_ < kSteps)
        show_step();
    else
        end();
}

void TourCommands::show_step() {
    bubble_->show_step(step(studio_.commands(), step_), target());
}

/// In the window. Of a panel that is not there, the canvas.
QRect TourCommands::target() const {
    const QWidget& canvas = studio_.canvas();
    const QPoint middle = canvas.mapTo(&studio_.window(), canvas.rect().center());
    const QRect in_middle(middle, QSize(1, 1));
    const QWidget* paints = panels_.paints;
    const bool is_last = step_ + 1 == kSteps;
    if (!is_last || !paints->isVisible() || paints->visibleRegion().isEmpty() ||
        paints->window() != &studio_.window())
        return in_middle;
    const QRect seen = paints->visibleRegion().boundingRect();
    return {paints->mapTo(&studio_.window(), seen.topLeft()), seen.size()};
}

/// The canvas has another size whenever panels have.
bool TourCommands::eventFilter(QObject* object, QEvent* event) {
    if (bubble_ != nullptr) {
        if (event->type() == QEvent::Hide) end();
        if (event->type() == QEvent::Resize || event->type() == QEvent::Move)
            bubble_->point_at(target());
    }
    return QObject::eventFilter(object, event);
}

}  // namespace pastoso::main
