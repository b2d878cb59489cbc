#include "panels/references/reference_view.hpp"

#include "appearance/said_value.hpp"
#include "appearance/theme.hpp"
#include "panels/parts/section.hpp"
#include "panels/references/reference_places.hpp"
#include "tools/picture_colours.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>
#include <QPolygonF>

namespace pastoso::panels {
namespace {

constexpr double kLeastZoom = 0.02, kMostZoom = 200.0;
constexpr int kRest_ms = 250;
constexpr double kHandle = 4.0;  ///< half of its side, in units of the widget
constexpr double kTurnHandleAway = 22.0;

/// Half a side of the square whose mean is picked, in units of the widget.
constexpr double kPickedHalf = 2.5;

document::Reference* find_in(document::ReferenceBoard& board, document::ReferenceId id) {
    const auto found = std::ranges::find(board.references, id, &document::Reference::id);
    return found == board.references.end() ? nullptr : &*found;
}

}  // namespace

ReferenceView::ReferenceView(QWidget* parent) : QWidget(parent) {
    appearance::say_as(*this, QAccessible::Graphic);
    setObjectName(QStringLiteral("reference_board"));
    setAccessibleName(tr("Board of references"));
    setToolTip(
        tr("Drag: move a picture, scale it by a corner, turn it by the ring\n"
           "Control and click: paint of that colour\n"
           "Wheel: closer, farther; with Shift it turns the picture\n"
           "Double click, 0: all of it"));
    say_board();
    setAcceptDrops(true);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    keep_own_keys(this, {Qt::Key_Plus, Qt::SHIFT | Qt::Key_Plus, Qt::Key_Minus, Qt::Key_0, Qt::Key_Left,
                         Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::SHIFT | Qt::Key_Left,
                         Qt::SHIFT | Qt::Key_Right, Qt::Key_Delete, Qt::Key_PageUp, Qt::Key_PageDown,
                         Qt::Key_Return, Qt::Key_Space, Qt::CTRL | Qt::Key_V});
    resting_.setSingleShot(true);
    resting_.setInterval(kRest_ms);
    connect(&resting_, &QTimer::timeout, this, &ReferenceView::finish);
    connect(&pictures_, &ReferencePictures::made, this, qOverload<>(&QWidget::update));
    connect(this, &ReferenceView::chosen_changed, this, &ReferenceView::say_board);
}

void ReferenceView::show_board(const document::SharedReferences& board) {
    if (board == board_) return;
    const std::size_t before = board_ ? board_->references.size() : 0;
    const std::size_t count = board ? board->references.size() : 0;
    const bool is_laid =
        count > before && document::find_reference(board_, board->references.back().id) == nullptr;
    board_ = board;
    if (is_said_) proposed_.reset();
    put_together();
    if (is_laid) chosen_ = board_->references.back().id;
    if (count != before && (fitted_ || before == 0)) fit();
    pictures_.keep_only(shown_);
    Q_EMIT chosen_changed();
    update();
}

void ReferenceView::put_together() {
    shown_ = board_ ? *board_ : document::ReferenceBoard{};
    if (chosen_ != 0 && find_in(shown_, chosen_) == nullptr) chosen_ = 0;
    if (!proposed_) return;
    if (document::Reference* changed = find_in(shown_, proposed_->reference)) {
        changed->place = proposed_->place;
        changed->look = proposed_->look;
    }
}

void ReferenceView::say_board() {
    const document::Reference* one = chosen();
    const auto count = static_cast<int>(shown_.references.size());
    appearance::say_value(
        *this, one == nullptr ? tr("pictures: %1").arg(count)
                              : tr("pictures: %1; chosen: %2")
                                    .arg(QString::number(count), QString::fromStdString(one->name)));
}

const document::Reference* ReferenceView::chosen() const {
    const auto found = std::ranges::find(shown_.references, chosen_, &document::Reference::id);
    return found == shown_.references.end() ? nullptr : &*found;
}

void ReferenceView::choose(document::ReferenceId reference) {
    if (reference == chosen_) return;
    finish();
    chosen_ = reference;
    Q_EMIT chosen_changed();
    update();
}

void ReferenceView::choose_next() {
    const auto& references = shown_.references;
    if (references.empty()) return;
    const auto found = std::ranges::find(references, chosen_, &document::Reference::id);
    const bool is_last = found == references.end() || std::next(found) == references.end();
    choose(is_last ? references.front().id : std::next(found)->id);
}

void ReferenceView::propose(const document::SetReference& set) {
    proposed_ = set;
    is_said_ = false;
    put_together();
    if (gesture_.drag == Drag::None) resting_.start();
    Q_EMIT chosen_changed();
    update();
}

void ReferenceView::finish() {
    resting_.stop();
    if (std::exchange(is_said_, true)) return;
    Q_EMIT acted(*proposed_);
}

void ReferenceView::remove_chosen() {
    finish();
    if (chosen_ != 0) Q_EMIT acted(document::RemoveReference{chosen_});
}

void ReferenceView::raise_chosen(int places) {
    finish();
    const document::Reference* one = chosen();
    if (one == nullptr) return;
    const auto place = static_cast<int>(one - shown_.references.data()) + places;
    if (place >= 0) Q_EMIT acted(document::MoveReference{chosen_, place});
}

QTransform ReferenceView::to_widget() const {
    QTransform view;
    view.translate(corner_.x(), corner_.y());
    view.scale(zoom_, zoom_);
    return view;
}

void ReferenceView::fit() {
    fit(extent_mm(shown_));
    fitted_ = true;
}

void ReferenceView::fit(const QRectF& part_mm) {
    constexpr double kRoomShare = 0.94;
    fitted_ = false;
    if (!part_mm.isNull())
        zoom_ = std::clamp(kRoomShare * std::min(width() / part_mm.width(), height() / part_mm.height()),
                           kLeastZoom, kMostZoom);
    corner_ = 0.5 * QPointF(width(), height()) - zoom_ * part_mm.center();
    update();
}

void ReferenceView::zoom_about(const QPointF& position, double factor) {
    const double zoom = std::clamp(factor * zoom_, kLeastZoom, kMostZoom);
    corner_ = position - (position - corner_) * (zoom / zoom_);
    zoom_ = zoom;
    fitted_ = false;
    update();
}

void ReferenceView::move_view(const QPointF& distance) {
    corner_ += distance;
    fitted_ = false;
    update();
}

void ReferenceView::pick_next(bool picks) {
    pick_next_ = picks;
    if (picks)
        setCursor(Qt::CrossCursor);
    else
        unsetCursor();
}

std::optional<pigment::Srgb8> ReferenceView::colour_at(const QPointF& position) const {
    const QPointF point_mm = board_mm(position);
    const document::Reference* one = reference_at(shown_, point_mm);
    if (one == nullptr) return std::nullopt;
    const QPointF pixel = pixel_at(*one, point_mm);
    const auto colour = tools::mean_colour(one->picture->pixels, pixel.x(), pixel.y(),
                                           kPickedHalf / zoom_ * pixels_per_mm(*one));
    return colour && one->look.grey ? tools::grey_of(*colour) : colour;
}

void ReferenceView::place_chosen(const document::ReferencePlace& place) {
    if (const document::Reference* one = chosen()) propose({one->id, in_range(place), one->look});
}

void ReferenceView::turn_chosen(double angle_deg) {
    const document::Reference* one = chosen();
    if (one == nullptr) return;
    document::ReferencePlace place = one->place;
    place.turn_deg += angle_deg;
    place_chosen(place);
}

void ReferenceView::scale_chosen(double factor) {
    const document::Reference* one = chosen();
    if (one == nullptr) return;
    document::ReferencePlace place = one->place;
    place.width_mm *= factor;
    place_chosen(place);
}

QPointF ReferenceView::turn_handle(const document::Reference& reference) const {
    const auto corners = corners_mm(reference);
    const QPointF middle = widget_position({reference.place.x_mm, reference.place.y_mm});
    const QPointF edge = 0.5 * (widget_position(corners[0]) + widget_position(corners[1]));
    const QPointF way = edge - middle;
    const double length = std::max(1.0, std::sqrt(QPointF::dotProduct(way, way)));
    return edge + kTurnHandleAway / length * way;
}

void ReferenceView::draw(QPainter& painter, const document::Reference& reference) {
    const QSizeF size = size_mm(reference);
    const QRectF area({-0.5 * size.width(), -0.5 * size.height()}, size);
    painter.save();
    painter.setTransform(on_board(reference.place) * to_widget(), true);
    painter.setOpacity(reference.look.opacity);
    const QImage picture =
        pictures_.at(reference, zoom_ * devicePixelRatioF() * reference.place.width_mm);
    if (picture.isNull())
        painter.fillRect(area, appearance::colours().field);
    else
        painter.drawImage(area, picture);
    painter.restore();
}

void ReferenceView::draw_handles(QPainter& painter, const document::Reference& reference) const {
    QPolygonF frame;
    for (const QPointF& corner : corners_mm(reference))
        frame << widget_position(corner);
    painter.setPen(QPen(appearance::colours().accent, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(frame);
    painter.setBrush(appearance::colours().window);
    for (const QPointF& corner : frame)
        painter.drawRect(QRectF(corner - QPointF(kHandle, kHandle), QSizeF(2 * kHandle, 2 * kHandle)));
    painter.drawEllipse(turn_handle(reference), kHandle + 1.0, kHandle + 1.0);
}

void ReferenceView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), appearance::colours().ground);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    if (shown_.references.empty()) {
        constexpr int kMargin = 12;
        painter.setPen(appearance::colours().quiet_text);
        painter.drawText(rect().adjusted(kMargin, kMargin, -kMargin, -kMargin),
                         Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Drag pictures here, to look at them and pick their colours while you "
                            "paint."));
    }
    for (const document::Reference& reference : shown_.references)
        draw(painter, reference);
    if (const document::Reference* one = chosen()) draw_handles(painter, *one);
    if (!hasFocus()) return;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(appearance::colours().focus);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

}  // namespace pastoso::panels
