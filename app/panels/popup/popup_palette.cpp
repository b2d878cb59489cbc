#include "panels/popup/popup_palette.hpp"

#include "appearance/shown_names.hpp"
#include "appearance/shown_number.hpp"
#include "panels/paint/thinning_slider.hpp"
#include "panels/popup/ring_places.hpp"
#include "panels/popup/round_button.hpp"

#include <algorithm>
#include <cmath>

#include <QAction>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QScreen>
#include <QSlider>
#include <QWheelEvent>

namespace pastoso::panels {
namespace {

/// Pixels of the layout, from the middle.
constexpr int kRadius = 178;
constexpr double kToolRing = 143.0, kPaintRing = 88.0, kCommandRing = 148.0;
constexpr int kToolSize = PopupPalette::kThumbnail, kPaintSize = 30, kCommandSize = 50;

constexpr QPointF kMiddle(kRadius, kRadius);

}  // namespace

/// A click beside it closes it and does nothing else: it must not leave a dab of paint.
PopupPalette::PopupPalette(int tools, int paints, const std::vector<QAction*>& commands, QWidget* parent)
    : QFrame(parent, Qt::Popup) {
    setObjectName(QStringLiteral("popup_palette"));
    setAccessibleName(tr("Pop-up palette"));
    setAttribute(Qt::WA_NoMouseReplay);
    setAttribute(Qt::WA_TranslucentBackground);
    setFixedSize(2 * kRadius, 2 * kRadius);
    setMask(QRegion(rect(), QRegion::Ellipse));
    make_tools(tools);
    make_paints(paints);
    make_middle();
    make_commands(commands);
    rings_[0].assign(tools_.begin(), tools_.end());
    rings_[1].assign(paints_.begin(), paints_.end());
}

RoundButton* PopupPalette::button(int diameter, const QPointF& place, const char* name) {
    auto* made = new RoundButton(diameter, this);
    made->setObjectName(QLatin1String(name));
    made->move_middle(kMiddle + place);
    return made;
}

/// Over the top, from the lower left to the lower right.
void PopupPalette::make_tools(int count) {
    for (const QPointF& place : ring_places(count, kToolRing, 150.0, 390.0)) {
        RoundButton* made = button(kToolSize, place, "popup_tool");
        made->setCheckable(true);
        connect(made, &RoundButton::clicked, this, [this, i = tools_.size()] {
            hide();
            Q_EMIT tool_chosen(names_[i]);
        });
        tools_.push_back(made);
    }
}

void PopupPalette::make_paints(int count) {
    for (const QPointF& place : ring_places(count, kPaintRing, -90.0, 270.0)) {
        RoundButton* made = button(kPaintSize, place, "popup_paint");
        connect(made, &RoundButton::clicked, this, [this, i = static_cast<int>(paints_.size())] {
            hide();
            Q_EMIT paint_chosen(i);
        });
        paints_.push_back(made);
    }
}

/// The two paints, and what changes without closing: the width, and how thin the paint is.
void PopupPalette::make_middle() {
    second_ = button(34, {24.0, -20.0}, "popup_second_paint");
    paint_ = button(48, {-10.0, -30.0}, "popup_first_paint");
    paint_->setFocusPolicy(Qt::NoFocus);
    connect(second_, &RoundButton::clicked, this, [this] {
        hide();
        Q_EMIT paints_swapped();
    });
    RoundButton* narrower = button(26, {-44.0, 15.0}, "popup_narrower");
    RoundButton* wider = button(26, {44.0, 15.0}, "popup_wider");
    narrower->setText(QStringLiteral("\u2212"));
    narrower->show_words(tr("A narrower brush"));
    wider->setText(QStringLiteral("+"));
    wider->show_words(tr("A wider brush"));
    for (RoundButton* step : {narrower, wider}) {
        step->setAutoRepeat(true);
        connect(step, &RoundButton::clicked, this,
                [this, steps = step == wider ? 1 : -1] { Q_EMIT width_stepped(steps); });
    }
    width_ = new QLabel(this);
    width_->setObjectName(QStringLiteral("popup_width"));
    width_->setAlignment(Qt::AlignCenter);
    width_->setGeometry(kRadius - 28, kRadius + 3, 56, 24);
    width_->setAttribute(Qt::WA_TransparentForMouseEvents);
    thinning_ = new ThinningSlider(Qt::Vertical, this);
    thinning_->setGeometry(kRadius - 48, kRadius + 28, 96, 34);
    connect(thinning_, &ThinningSlider::share_chosen, this, &PopupPalette::share_chosen);
    rings_[2] = {second_, narrower, wider, thinning_->slider()};
}

void PopupPalette::make_commands(const std::vector<QAction*>& actions) {
    const auto places = ring_places(static_cast<int>(actions.size()), kCommandRing, 122.0, 58.0);
    for (std::size_t i = 0; i < actions.size(); ++i) {
        QAction* action = actions[i];
        RoundButton* made = button(kCommandSize, places[i], "popup_command");
        const auto follow = [made, action] {
            made->setIcon(action->icon());
            made->setText(action->iconText());
            made->setEnabled(action->isEnabled());
            made->show_words(action->toolTip());
        };
        follow();
        connect(action, &QAction::changed, made, follow);
        // Given once the palette is gone: a command may ask something itself.
        connect(made, &RoundButton::clicked, this, [this, action] {
            hide();
            QMetaObject::invokeMethod(action, &QAction::trigger, Qt::QueuedConnection);
        });
        QFont small = made->font();
        small.setPointSizeF(0.85 * small.pointSizeF());
        made->setFont(small);
        rings_[3].push_back(made);
    }
}

// ---- what is shown

void PopupPalette::show_content(const Content& content) {
    names_ = content.tools;
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        const bool used = i < names_.size();
        tools_[i]->setVisible(used);
        if (!used) continue;
        const QString words = appearance::shown_name(names_[i]);
        if (tools_[i]->toolTip() != words) tools_[i]->show_picture({});
        tools_[i]->show_words(words);
        tools_[i]->setChecked(names_[i] == content.tool_in_hand);
    }
    for (std::size_t i = 0; i < paints_.size(); ++i) {
        paints_[i]->setVisible(i < content.paints.size());
        if (i < content.paints.size())
            paints_[i]->show_colour(content.paints[i].colour, content.paints[i].words);
    }
    paint_->show_colour(content.paint.colour, content.paint.words);
    second_->show_colour(
        content.second_paint.colour,
        tr("%1: take this one, and put the other here").arg(content.second_paint.words));
}

void PopupPalette::show_width(double width_mm) {
    width_->setText(tr("%1 mm").arg(appearance::shown_number(std::round(10.0 * width_mm) / 10.0)));
}

void PopupPalette::show_thinning(const tools::Hand& hand) {
    thinning_->show_hand(hand);
}

void PopupPalette::set_thumbnail(const QString& tool, const QImage& image) {
    for (std::size_t i = 0; i < names_.size() && i < tools_.size(); ++i)
        if (names_[i] == tool) tools_[i]->show_picture(image);
}

void PopupPalette::open_at(const QPoint& place) {
    const QScreen* screen = QGuiApplication::screenAt(place);
    if (screen == nullptr) screen = QGuiApplication::primaryScreen();
    move(corner_on_screen(place, size(), screen->availableGeometry()));
    show();
    const auto in_hand = std::find_if(tools_.begin(), tools_.end(),
                                      [](const RoundButton* tool) { return tool->isChecked(); });
    (in_hand != tools_.end() ? *in_hand : tools_.front())->setFocus(Qt::PopupFocusReason);
}

void PopupPalette::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1.5));
    painter.setBrush(palette().window());
    painter.drawEllipse(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5));
    painter.setPen(QPen(palette().color(QPalette::Button), 1.0));
    for (const double radius : {kPaintRing - 22.0, kPaintRing + 22.0})
        painter.drawEllipse(kMiddle, radius, radius);
}

// ---- keys and mouse

/// Right and left go around a ring, up and down from ring to ring.
void PopupPalette::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Escape:
            return hide();
        case Qt::Key_Right:
            return step_in_ring(1);
        case Qt::Key_Left:
            return step_in_ring(-1);
        case Qt::Key_Down:
            return step_ring(1);
        case Qt::Key_Up:
            return step_ring(-1);
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (auto* chosen = qobject_cast<RoundButton*>(focusWidget())) chosen->click();
            return;
        default:
            QFrame::keyPressEvent(event);
    }
}

/// The Tab key goes from ring to ring.
bool PopupPalette::focusNextPrevChild(bool next) {
    step_ring(next ? 1 : -1);
    return true;
}

bool PopupPalette::focus_on(const Ring& ring, std::size_t index) {
    QWidget* control = ring[index % ring.size()];
    if (control->isHidden() || !control->isEnabled()) return false;
    control->setFocus(Qt::TabFocusReason);
    return true;
}

void PopupPalette::step_in_ring(int steps) {
    for (const Ring& ring : rings_) {
        const auto found = std::find(ring.begin(), ring.end(), focusWidget());
        if (found == ring.end()) continue;
        const auto size = ring.size();
        const auto step = steps > 0 ? std::size_t{1} : size - 1;
        auto index = static_cast<std::size_t>(found - ring.begin());
        for (std::size_t tried = 0; tried < size; ++tried)
            if (focus_on(ring, index += step)) return;
    }
}

void PopupPalette::step_ring(int steps) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < rings_.size(); ++i)
        if (std::find(rings_[i].begin(), rings_[i].end(), focusWidget()) != rings_[i].end()) at = i;
    for (std::size_t tried = 0; tried < rings_.size(); ++tried) {
        at = (at + (steps > 0 ? 1 : rings_.size() - 1)) % rings_.size();
        for (std::size_t index = 0; index < rings_[at].size(); ++index)
            if (focus_on(rings_[at], index)) return;
    }
}

void PopupPalette::wheelEvent(QWheelEvent* event) {
    if (event->angleDelta().y() != 0) Q_EMIT width_stepped(event->angleDelta().y() > 0 ? 1 : -1);
}

void PopupPalette::hideEvent(QHideEvent* event) {
    thinning_->finish();
    QFrame::hideEvent(event);
}

/// In the corners around the disc too.
void PopupPalette::mousePressEvent(QMouseEvent* event) {
    const QPointF away = event->position() - kMiddle;
    if (QPointF::dotProduct(away, away) > double{kRadius} * kRadius) hide();
}

}  // namespace pastoso::panels
