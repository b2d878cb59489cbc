#include "panels/colour/colour_wheel.hpp"

#include "appearance/said_value.hpp"
#include "appearance/screen_colours.hpp"
#include "appearance/shown_number.hpp"
#include "core/units.hpp"
#include "panels/colour/wheel_marks.hpp"
#include "panels/colour/wheel_picture.hpp"
#include "panels/parts/section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

namespace pastoso::panels {
namespace {

/// In units of the window.
constexpr double kRingWidth = 17.0, kMargin = 3.0, kGap = 5.0;

/// A corner of a mask is taken so far from it.
constexpr double kCorner_px = 5.0;

/// What a key moves by.
constexpr double kHueStep_deg = 5.0, kLightnessStep = 2.0, kChromaStep = 0.01;
constexpr double kFine = 0.2;

}  // namespace

ColourWheel::ColourWheel(QWidget* parent) : QWidget(parent) {
    connect(&appearance::screen_colours(), &appearance::ScreenColours::changed, this,
            [this] { ring_ = field_ = disc_ = {}; });
    setObjectName(QStringLiteral("colour_wheel"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    appearance::say_as(*this, QAccessible::ColorChooser);
    setAccessibleName(tr("Colour wheel"));
    setToolTip(
        tr("The ring is the hue. Inside, lightness goes up and chroma to the right, as far as the\n"
           "screen has it. Keys: arrows, Page Up and Page Down for the hue, with Ctrl finely."));
    keep_keys_for_canvas(this);
    keep_own_keys(this, {Qt::Key_PageUp, Qt::Key_PageDown, Qt::CTRL | Qt::Key_PageUp,
                         Qt::CTRL | Qt::Key_PageDown});
}

void ColourWheel::show_colour(const tools::Channels& oklch) {
    const double hue_deg = oklch_[2];
    oklch_ = oklch;
    if (oklch[1] == 0.0) oklch_[2] = hue_deg;
    if (!tools::in_harmony(aids_.harmony, harmony_deg_, oklch_[2])) turn_harmony(oklch_[2]);
    appearance::say_value(*this, tr("Lightness %1 %, chroma %2, hue %3\u00b0")
                                     .arg(oklch_[0], 0, 'f', 0)
                                     .arg(appearance::shown_number(oklch_[1], 2))
                                     .arg(oklch_[2], 0, 'f', 0));
    update();
}

void ColourWheel::show_aids(const tools::ColourAids& aids) {
    const bool other_harmony = aids.harmony != aids_.harmony;
    aids_ = aids;
    if (other_harmony) turn_harmony(oklch_[2]);
    update();
}

void ColourWheel::turn_harmony(double hue_deg) {
    harmony_deg_ = hue_deg;
    marks_deg_ = tools::harmony_hues(aids_.harmony, hue_deg);
    if (!marks_deg_.empty()) marks_deg_.push_back(hue_deg);
}

// ---- places

ColourWheel::Measures ColourWheel::measures() const {
    Measures all{};
    all.ratio = devicePixelRatioF();
    const double wide = width() * all.ratio, high = height() * all.ratio;
    all.side = static_cast<int>(std::min(wide, high));
    all.left = static_cast<int>((wide - all.side) / 2.0);
    all.top = static_cast<int>((high - all.side) / 2.0);
    all.outer = 0.5 * all.side - kMargin * all.ratio;
    all.inner = all.outer - kRingWidth * all.ratio;
    all.field_side = static_cast<int>((all.inner - kGap * all.ratio) * std::numbers::sqrt2);
    all.field_left = all.left + (all.side - all.field_side) / 2;
    all.field_top = all.top + (all.side - all.field_side) / 2;
    all.disc = all.inner - kGap * all.ratio;
    return all;
}

QPointF ColourWheel::ring_position(double hue_deg) const {
    const Measures all = measures();
    const double radius = 0.5 * (all.inner + all.outer), hue = core::radians(hue_deg);
    return QPointF(all.left + 0.5 * all.side + radius * std::cos(hue),
                   all.top + 0.5 * all.side - radius * std::sin(hue)) /
           all.ratio;
}

QPointF ColourWheel::field_position(double lightness, double chroma) const {
    const Measures all = measures();
    return QPointF(all.field_left + all.field_side * chroma / kFieldChroma,
                   all.field_top + all.field_side * (1.0 - lightness / 100.0)) /
           all.ratio;
}

QPointF ColourWheel::disc_position(const glm::dvec2& place) const {
    const Measures all = measures();
    return QPointF(all.left + 0.5 * all.side + all.disc * place.x,
                   all.top + 0.5 * all.side - all.disc * place.y) /
           all.ratio;
}

const double* ColourWheel::mark_at(const QPointF& position) const {
    for (const double& hue_deg : marks_deg_) {
        const QPointF way = position - ring_position(hue_deg);
        if (std::hypot(way.x(), way.y()) <= kHueMark_px + 1.0 &&
            !tools::in_harmony({}, hue_deg, oklch_[2]))
            return &hue_deg;
    }
    return nullptr;
}

std::optional<std::size_t> ColourWheel::corner_at(const QPointF& position) const {
    const std::vector<glm::dvec2> outline = tools::mask_outline(aids_.mask);
    for (std::size_t i = 0; i < tools::movable_corners(aids_.mask.shape); ++i) {
        const QPointF way = position - disc_position(outline[i]);
        if (std::hypot(way.x(), way.y()) <= kCorner_px) return i;
    }
    return std::nullopt;
}

ColourWheel::Drag ColourWheel::place_of(const QPointF& position) const {
    if (corner_at(position)) return Drag::Corner;
    if (mark_at(position) != nullptr) return Drag::Mark;
    const Measures all = measures();
    const QPointF at = position * all.ratio;
    const double radius =
        std::hypot(at.x() - all.left - 0.5 * all.side, at.y() - all.top - 0.5 * all.side);
    if (radius > all.disc) return Drag::Ring;
    return has_mask() ? Drag::Disc : Drag::Field;
}

// ---- changes

/// A colour beyond sRGB is brought to its edge at that lightness, one beyond the mask to the mask's.
void ColourWheel::move_to(tools::Channels oklch) {
    oklch[0] = std::clamp(oklch[0], 0.0, 100.0);
    oklch[2] = tools::turned_deg(oklch[2]);
    oklch[1] = std::clamp(oklch[1], 0.0, tools::most_chroma(oklch[0], oklch[2]));
    oklch = tools::held_in_mask(aids_.mask, oklch);
    const bool same = oklch == oklch_;
    show_colour(oklch);
    if (!same) Q_EMIT moved(oklch_);
}

/// The colour in hand stays, also where the mask no longer holds it.
void ColourWheel::move_corner(const glm::dvec2& place) {
    aids_.mask = tools::with_corner(aids_.mask, corner_, place);
    update();
}

/// A harmony turns with the hue, but for a mark, which is one of its own hues.
void ColourWheel::drag_to(const QPointF& position) {
    const Measures all = measures();
    const QPointF at = position * all.ratio;
    const double right = at.x() - all.left - 0.5 * all.side, up = all.top + 0.5 * all.side - at.y();
    if (drag_ == Drag::Field) {
        const double chroma = kFieldChroma * (at.x() - all.field_left) / all.field_side;
        const double lightness = 100.0 * (1.0 - (at.y() - all.field_top) / all.field_side);
        return move_to({lightness, chroma, oklch_[2]});
    }
    if (drag_ == Drag::Ring)
        move_to({oklch_[0], pressed_chroma_, core::degrees(std::atan2(up, right))});
    else if (drag_ == Drag::Disc)
        move_to(tools::colour_on_disc(oklch_[0], glm::dvec2(right, up) / all.disc, oklch_[2]));
    else if (drag_ == Drag::Corner)
        return move_corner(glm::dvec2(right, up) / all.disc);
    else
        return;
    turn_harmony(oklch_[2]);
    update();
}

void ColourWheel::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    drag_ = place_of(event->position());
    pressed_chroma_ = oklch_[1];
    if (drag_ == Drag::Corner)
        corner_ = *corner_at(event->position());
    else if (const double* mark = mark_at(event->position()))
        move_to({oklch_[0], pressed_chroma_, *mark});
    else
        drag_to(event->position());
}

void ColourWheel::mouseMoveEvent(QMouseEvent* event) {
    drag_to(event->position());
}

void ColourWheel::mouseReleaseEvent(QMouseEvent*) {
    const Drag ended = std::exchange(drag_, Drag::None);
    if (ended == Drag::Corner) Q_EMIT mask_moved(aids_.mask);
    if (ended != Drag::None && ended != Drag::Corner) Q_EMIT released();
}

/// Turns the ring; over a panel that scrolls the wheel would else move both.
void ColourWheel::wheelEvent(QWheelEvent* event) {
    if (!hasFocus()) return event->ignore();
    const double notches = event->angleDelta().y() / 120.0;
    move_to({oklch_[0], oklch_[1], oklch_[2] + notches * kHueStep_deg});
}

void ColourWheel::keyPressEvent(QKeyEvent* event) {
    const double steps = event->modifiers().testFlag(Qt::ControlModifier) ? kFine : 1.0;
    tools::Channels to = oklch_;
    switch (event->key()) {
        case Qt::Key_Left:
            to[1] -= steps * kChromaStep;
            break;
        case Qt::Key_Right:
            to[1] += steps * kChromaStep;
            break;
        case Qt::Key_Up:
            to[0] += steps * kLightnessStep;
            break;
        case Qt::Key_Down:
            to[0] -= steps * kLightnessStep;
            break;
        case Qt::Key_PageUp:
            to[2] += steps * kHueStep_deg;
            break;
        case Qt::Key_PageDown:
            to[2] -= steps * kHueStep_deg;
            break;
        default:
            return QWidget::keyPressEvent(event);
    }
    move_to(to);
}

// ---- the picture

void ColourWheel::draw_pictures() {
    const Measures all = measures();
    if (ring_.width() != all.side || ring_.devicePixelRatio() != all.ratio) {
        ring_ = appearance::shown(hue_ring(all.side, all.inner, all.outer));
        ring_.setDevicePixelRatio(all.ratio);
    }
    if (has_mask()) {
        if (disc_.width() == all.side && disc_lightness_ == oklch_[0]) return;
        disc_ = appearance::shown(hue_disc(all.side, all.disc, oklch_[0]));
        disc_.setDevicePixelRatio(all.ratio);
        disc_lightness_ = oklch_[0];
        return;
    }
    if (field_.width() == all.field_side && field_hue_deg_ == oklch_[2]) return;
    field_ = appearance::shown(colour_field(all.field_side, oklch_[2]));
    field_.setDevicePixelRatio(all.ratio);
    field_hue_deg_ = oklch_[2];
}

/// Where sRGB ends, as a line that smooths the field's steps.
void ColourWheel::paint_boundary(QPainter& painter) const {
    constexpr int kPoints = 64;
    QPolygonF line;
    for (int i = 0; i <= kPoints; ++i) {
        const double lightness = 100.0 * i / kPoints;
        line << field_position(lightness, tools::most_chroma(lightness, oklch_[2]));
    }
    painter.setPen(QPen(QColor(160, 160, 162, 170), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
}

void ColourWheel::paint_field(QPainter& painter) const {
    const Measures all = measures();
    const QRectF field(QPointF(all.field_left, all.field_top) / all.ratio,
                       QSizeF(all.field_side, all.field_side) / all.ratio);
    painter.setPen(hasFocus() ? QPen(palette().highlight(), 1.0) : QPen(QColor(0, 0, 0, 140), 1.0));
    painter.setBrush(palette().base());
    painter.drawRect(field.adjusted(-0.5, -0.5, 0.5, 0.5));
    painter.drawImage(field.topLeft(), field_);
    paint_boundary(painter);
    paint_mark(painter, field_position(oklch_[0], oklch_[1]), mark_colour(oklch_));
}

/// Beyond the mask it is faint.
void ColourWheel::paint_disc(QPainter& painter) const {
    const Measures all = measures();
    painter.drawImage(QPointF(all.left, all.top) / all.ratio, disc_);
    QPolygonF outline;
    for (const glm::dvec2& corner : tools::mask_outline(aids_.mask))
        outline << disc_position(corner);
    const double radius = all.disc / all.ratio + 0.5;
    paint_veil(painter, disc_position({0.0, 0.0}), radius, outline, palette().color(QPalette::Window));
    const QColor bright(240, 240, 240);
    paint_mask_line(painter, outline, static_cast<int>(tools::movable_corners(aids_.mask.shape)),
                    hasFocus() ? palette().color(QPalette::Highlight) : bright);
    paint_mark(painter, disc_position(tools::disc_place(oklch_)), mark_colour(oklch_));
}

void ColourWheel::paintEvent(QPaintEvent*) {
    draw_pictures();
    const Measures all = measures();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawImage(QPointF(all.left, all.top) / all.ratio, ring_);
    has_mask() ? paint_disc(painter) : paint_field(painter);
    for (const double hue_deg : marks_deg_)
        paint_hue_mark(painter, ring_position(hue_deg),
                       mark_colour({kRingLightness, kRingChroma, hue_deg}));
    paint_mark(painter, ring_position(oklch_[2]), mark_colour({kRingLightness, kRingChroma, oklch_[2]}));
}

}  // namespace pastoso::panels
