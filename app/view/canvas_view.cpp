#include "view/canvas_view.hpp"

#include "screen/window_pixels.hpp"
#include "view/look_legend.hpp"

#include <utility>

namespace pastoso::view {
namespace {

/// Drafts left alone for about this long are refined: longer than the pause between two movements of a
/// hand.
constexpr int kCoolingTime_ms = 60;

/// Of the well's view, unless somebody wants it larger.
constexpr QSize kWellSize(360, 272);

/// As a canvas has that was turned by a quarter.
bool has_swapped_sides(const document::Snapshot& before, const document::Snapshot& after) {
    const grid::Shape was = before.film.shape, is = after.film.shape;
    return was.width != was.height && is == grid::Shape{was.height, was.width};
}

}  // namespace

CanvasView::CanvasView(document::Surface surface, QWidget* parent)
    : QWidget(parent), surface_(surface), legend_(new LookLegend(this)) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setTabletTracking(true);
    setAttribute(Qt::WA_AcceptTouchEvents);
    setMinimumSize(surface == document::Surface::Canvas ? QSize(320, 240) : QSize(200, 150));
    QSizePolicy policy = sizePolicy();
    policy.setHeightForWidth(surface == document::Surface::Well);
    setSizePolicy(policy);
    holding_.setSingleShot(true);
    holding_.setInterval(input::TouchGestures::kHold_ms);
    connect(&holding_, &QTimer::timeout, this, &CanvasView::hold_finger);
    connect(&pen_watch_, &PenWatch::pen_left, this, &CanvasView::lose_pen);
    put_up(screen::make_screen(drawn_by_, *this, *this));
    refresh();
}

QSize CanvasView::sizeHint() const {
    return surface_ == document::Surface::Well ? kWellSize : QWidget::sizeHint();
}

int CanvasView::heightForWidth(int width) const {
    if (surface_ == document::Surface::Canvas) return -1;
    return width * kWellSize.height() / kWellSize.width();
}

CanvasView::~CanvasView() = default;

/// Below the legend.
void CanvasView::put_up(std::unique_ptr<screen::CanvasScreen> screen) {
    screen_ = std::move(screen);
    screen_->widget().resize(size());
    screen_->widget().show();
    screen_->widget().lower();
    screen_->refresh();
}

void CanvasView::set_drawn_by(screen::DrawnBy drawn_by) {
    if (drawn_by == drawn_by_) return;
    drawn_by_ = drawn_by;
    opengl_failed_ = false;
    put_up(screen::make_screen(drawn_by_, *this, *this));
    if (wanted_ != nullptr) suit_screen();
}

/// To the size of the canvas.
void CanvasView::suit_screen() {
    const glm::dvec2 cells = canvas_cells();
    const bool by_processor =
        opengl_failed_ ||
        screen::drawn_by_processor(drawn_by_, graphics::opengl_support(), cells.x * cells.y);
    if (by_processor == (screen_->opengl() == nullptr)) return;
    put_up(screen::make_screen(by_processor ? screen::DrawnBy::Processor : screen::DrawnBy::OpenGl,
                               *this, *this));
}

/// Not at once: it is drawing. It may fail more than once until then.
void CanvasView::screen_failed(const QString& sentence) {
    QMetaObject::invokeMethod(
        this,
        [this, sentence] {
            if (screen_->opengl() == nullptr) return;
            opengl_failed_ = true;
            put_up(screen::make_screen(screen::DrawnBy::Processor, *this, *this));
            Q_EMIT fell_back(sentence);
        },
        Qt::QueuedConnection);
}

screen::Sight CanvasView::sight() const {
    return {painting_preview_ != nullptr ? painting_preview_ : wanted_,
            wanted_ == nullptr ? nullptr : seen_tracing(), lighting_, viewing_, look_};
}

void CanvasView::draw_over(const document::Snapshot& shown, screen::OverlayPainter& painter) {
    const glm::dmat2 px_from_mm = view_.zoom / shown.film.cell_mm * view_.axes();
    const Overlay overlay{
        painter, {view_.device_from_cell({0.0, 0.0}), px_from_mm, screen::window_px(*this)}, px_mm()};
    if (surface_ == document::Surface::Canvas) {
        draw_masking(shown, overlay);
        draw_selection(shown, overlay);
    }
    interactions_.draw(overlay);
}

void CanvasView::show_snapshot(std::shared_ptr<const document::Snapshot> snapshot,
                               std::optional<glm::dvec2> shift_mm) {
    const bool other_canvas = wanted_ == nullptr || wanted_->film.shape != snapshot->film.shape ||
                              wanted_->film.cell_mm != snapshot->film.cell_mm;
    const bool stands_otherwise = wanted_ != nullptr && has_swapped_sides(*wanted_, *snapshot);
    if (wanted_ != nullptr && wanted_->tracing != snapshot->tracing) tracing_preview_.reset();
    wanted_ = std::move(snapshot);
    if (painting_preview_ != nullptr && painting_preview_->bare != wanted_->bare)
        painting_preview_.reset();
    if (other_canvas || shift_mm) begin_other_canvas();
    if (shift_mm && !(fitted_ && stands_otherwise)) {
        fitted_ = false;
        const glm::dvec2 drag_px = -view_.zoom / wanted_->film.cell_mm * (view_.axes() * *shift_mm);
        set_view(panned(view_, drag_px, canvas_cells(), window_px()));
    } else if (other_canvas) {
        fit();
    }
    screen_->refresh();
}

/// What was begun over the canvas has no place on this one.
void CanvasView::begin_other_canvas() {
    suit_screen();
    screen_->begin_other_canvas();
    preview_.reset();
    interactions_.cancel();
}

void CanvasView::set_viewing(const pigment::Viewing& viewing) {
    if (viewing == viewing_) return;
    viewing_ = viewing;
    screen_->refresh();
    Q_EMIT viewing_changed();
}

void CanvasView::show_tracing(bool shown) {
    tracing_shown_ = shown;
    screen_->refresh();
}

void CanvasView::preview_tracing(screen::Tracing tracing) {
    tracing_preview_ = std::move(tracing);
    screen_->refresh();
}

void CanvasView::preview_painting(std::shared_ptr<const document::Snapshot> painting) {
    if (painting == painting_preview_) return;
    painting_preview_ = std::move(painting);
    screen_->refresh();
}

screen::Tracing CanvasView::seen_tracing() const {
    if (!tracing_shown_) return nullptr;
    return tracing_preview_ != nullptr ? tracing_preview_ : wanted_->tracing;
}

}  // namespace pastoso::view
