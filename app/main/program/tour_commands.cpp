#include "main/program/tour_commands.hpp"

#include "commands/command_words.hpp"
#include "help/tour_bubble.hpp"
#include "help/tour_frame.hpp"
#include "panels/paint/paint_panel.hpp"
#include "panels/parts/tool_bar.hpp"

#include <array>

#include <QAction>
#include <QEvent>
#include <QList>
#include <QMainWindow>
#include <QToolButton>

namespace pastoso::main {
namespace {

using commands::Command;

constexpr int kSteps = 3;

/// What a step is done by.
std::set<TourCommands::Deed> deeds_of(int step) {
    using Deed = TourCommands::Deed;
    const std::array<std::set<Deed>, kSteps> deeds = {
        {{Deed::Stroke}, {Deed::MoveCanvas, Deed::PickPaint}, {Deed::ChoosePaint, Deed::TakeBack}}};
    return deeds[static_cast<std::size_t>(step)];
}

/// What is seen of a widget, in the window: nothing behind others, or in another window.
QRect seen_of(const QWidget& widget, const QWidget& window) {
    if (!widget.isVisible() || widget.window() != &window) return {};
    QRect seen = widget.rect();
    for (const QWidget* one = &widget; one != &window; one = one->parentWidget())
        seen = seen.translated(one->pos()).intersected(one->parentWidget()->rect());
    return seen;
}

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
    panels_.paints->installEventFilter(this);
    connect(&studio_, &Studio::published, this,
            [this](const auto&, const session::Status& status) { take(status); });
    interactions::OnCanvas& on_canvas = studio_.on_canvas();
    for (interactions::Picking* pick : {static_cast<interactions::Picking*>(&on_canvas.pick_next),
                                        static_cast<interactions::Picking*>(&on_canvas.pick_by_keys)})
        connect(pick, &interactions::Picking::picked, this, [this] { note(Deed::PickPaint); });
    connect(panels_.paints, &panels::PaintPanel::paint_chosen, this,
            [this] { note(Deed::ChoosePaint); });
    connect(studio_.commands().action(Command::Undo), &QAction::triggered, this,
            [this] { note(Deed::TakeBack); });
}

void TourCommands::begin() {
    end();
    frame_ = new help::TourFrame(&studio_.window());
    bubble_ = new help::TourBubble(&studio_.window());
    connect(bubble_, &help::TourBubble::next_wanted, this, &TourCommands::go_on);
    connect(bubble_, &help::TourBubble::left, this, &TourCommands::end);
    seen_ = true;
    step_ = 0;
    show_step();
    bubble_->take_keys();
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
    for (QWidget* shown : {static_cast<QWidget*>(bubble_), static_cast<QWidget*>(frame_)}) {
        shown->hide();
        shown->deleteLater();
    }
    bubble_.clear();
    frame_.clear();
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
    open_ = deeds_of(step_);
    bubble_->show_step(step(studio_.commands(), step_), target());
    show_frames();
}

/// A stroke is one once the pen is up.
void TourCommands::take(const session::Status& status) {
    if (status.stroke_in_progress) return;
    if (status.strokes > strokes_) note(Deed::Stroke);
    strokes_ = status.strokes;
}

void TourCommands::note(Deed deed) {
    if (bubble_ == nullptr || open_.erase(deed) == 0) return;
    if (open_.empty())
        go_on();
    else
        show_frames();
}

/// Below the bubble.
void TourCommands::show_frames() {
    QList<QRect> places;
    for (const Deed deed : open_)
        if (const QWidget* there = place_of(deed)) places.push_back(seen_of(*there, studio_.window()));
    frame_->show_around(places);
    frame_->raise();
    bubble_->raise();
}

/// Null: nowhere in the window.
const QWidget* TourCommands::place_of(Deed deed) const {
    if (deed == Deed::ChoosePaint) return panels_.paints;
    if (deed != Deed::TakeBack) return &studio_.canvas();
    const QAction* undo = studio_.commands().action(Command::Undo);
    for (const auto* button : panels_.bar->findChildren<QToolButton*>())
        if (button->defaultAction() == undo) return button;
    return nullptr;
}

/// In the window. Of a panel that is not there, the canvas.
QRect TourCommands::target() const {
    const QWidget& canvas = studio_.canvas();
    const QPoint middle = canvas.mapTo(&studio_.window(), canvas.rect().center());
    const bool is_last = step_ + 1 == kSteps;
    const QRect paints = seen_of(*panels_.paints, studio_.window());
    return is_last && !paints.isEmpty() ? paints : QRect(middle, QSize(1, 1));
}

/// By the wheel, or a drag with Space.
bool TourCommands::moves_canvas(const QEvent& event) const {
    const bool is_end =
        event.type() == QEvent::MouseButtonRelease || event.type() == QEvent::TabletRelease;
    return event.type() == QEvent::Wheel || (is_end && studio_.on_canvas().navigate.is_mode());
}

/// The canvas has another size whenever panels have.
bool TourCommands::eventFilter(QObject* object, QEvent* event) {
    if (bubble_ == nullptr) return QObject::eventFilter(object, event);
    const bool is_canvas = object == &studio_.canvas();
    if (is_canvas && moves_canvas(*event)) note(Deed::MoveCanvas);
    if (is_canvas && event->type() == QEvent::Hide) end();
    const bool is_elsewhere = event->type() == QEvent::Resize || event->type() == QEvent::Move;
    if (bubble_ != nullptr && is_elsewhere) {
        bubble_->point_at(target());
        show_frames();
    }
    return QObject::eventFilter(object, event);
}

}  // namespace pastoso::main
