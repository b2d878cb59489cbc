#include "view/canvas_view.hpp"

#include "view/look_legend.hpp"

#include <utility>

namespace pastoso::view {
namespace {

/// Drafts left alone for about this long are refined: longer than the pause between two movements of a
/// hand.
constexpr int kCoolingTime_ms = 60;

/// Of the well's view, unless somebody wants it larger.
constexpr QSize kWellSize(360, 272);

}  // namespace

CanvasView::CanvasView(document::Surface surface, QWidget* parent)
    : GraphicsWidget(parent),
      surface_(surface),
      presenter_([this] {
          QMetaObject::invokeMethod(
              this, [this] { update(); }, Qt::QueuedConnection);
      }),
      legend_(new LookLegend(this)) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setTabletTracking(true);
    setAttribute(Qt::WA_AcceptTouchEvents);
    setMinimumSize(surface == document::Surface::Canvas ? QSize(320, 240) : QSize(200, 150));
    QSizePolicy policy = sizePolicy();
    policy.setHeightForWidth(surface == document::Surface::Well);
    setSizePolicy(policy);
    cooling_.setSingleShot(true);
    cooling_.setInterval(kCoolingTime_ms);
    connect(&cooling_, &QTimer::timeout, this, [this] {
        plan_.let_drafts_cool();
        update();
    });
    holding_.setSingleShot(true);
    holding_.setInterval(input::TouchGestures::kHold_ms);
    connect(&holding_, &QTimer::timeout, this, &CanvasView::hold_finger);
    refresh();
}

QSize CanvasView::sizeHint() const {
    return surface_ == document::Surface::Well ? kWellSize : QOpenGLWidget::sizeHint();
}

int CanvasView::heightForWidth(int width) const {
    if (surface_ == document::Surface::Canvas) return -1;
    return width * kWellSize.height() / kWellSize.width();
}

CanvasView::~CanvasView() {
    release_graphics();
}

void CanvasView::show_snapshot(std::shared_ptr<const document::Snapshot> snapshot,
                               std::optional<glm::dvec2> shift_mm) {
    const bool other_canvas = wanted_ == nullptr || wanted_->film.shape != snapshot->film.shape ||
                              wanted_->film.cell_mm != snapshot->film.cell_mm;
    if (wanted_ != nullptr && wanted_->tracing != snapshot->tracing) tracing_preview_.reset();
    wanted_ = std::move(snapshot);
    if (other_canvas || shift_mm) begin_other_canvas();
    if (shift_mm) {
        fitted_ = false;
        const glm::dvec2 drag_px = -view_.zoom / wanted_->film.cell_mm * (view_.axes() * *shift_mm);
        set_view(panned(view_, drag_px, canvas_cells(), window_px()));
    } else if (other_canvas) {
        fit();
    }
    ask_presenter();
    update();
}

/// What was begun over the canvas has no place on this one.
void CanvasView::begin_other_canvas() {
    drop_textures();
    preview_.reset();
    interactions_.cancel();
    damage_all();
}

void CanvasView::set_viewing(const pigment::Viewing& viewing) {
    if (viewing == viewing_) return;
    viewing_ = viewing;
    update();
    Q_EMIT viewing_changed();
}

void CanvasView::show_tracing(bool shown) {
    tracing_shown_ = shown;
    update();
}

void CanvasView::preview_tracing(Tracing tracing) {
    tracing_preview_ = std::move(tracing);
    update();
}

Tracing CanvasView::seen_tracing() const {
    if (!tracing_shown_) return nullptr;
    return tracing_preview_ != nullptr ? tracing_preview_ : wanted_->tracing;
}

bool CanvasView::finished() const {
    const bool shows = shown_ != nullptr ? drawn_ == wanted_sight() : wanted_ == nullptr;
    return shows && !moved_from_ && !presenter_.busy() && presentations_.empty() && !upload_.active() &&
           !plan_.has_damage() && !plan_.has_drafts();
}

void CanvasView::damage_all() {
    plan_.add_damage(QRect(0, 0, static_cast<int>(window_px().x), static_cast<int>(window_px().y)));
    update();
}

}  // namespace pastoso::view
