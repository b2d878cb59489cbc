#include "panels/paint/thinning_slider.hpp"

#include "film/thinning.hpp"
#include "panels/paint/paint_words.hpp"
#include "panels/parts/section.hpp"
#include "panels/parts/slider_scale.hpp"
#include "panels/parts/upright.hpp"
#include "tools/paint_share.hpp"

#include <algorithm>

#include <QBoxLayout>
#include <QFontMetrics>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

namespace pastoso::panels {
namespace {

constexpr int kRest_ms = 250;
constexpr int kLength_px = 72;

constexpr SliderScale kShares{film::kLeastPaintShare, 1.0, true};

/// The paint stands on the left, the medium on the right.
double share_at(int step) {
    return kShares.value_at(SliderScale::kSteps - step);
}
int step_of(double share) {
    return SliderScale::kSteps - kShares.step_of(share);
}

/// So that the slider stays where it is while the words change.
int widest_words(const QFontMetrics& font) {
    using tools::Body;
    int widest = 0;
    for (const Body body : {Body::Paste, Body::Cream, Body::Milk, Body::Wash, Body::Stain})
        widest = std::max(widest, font.horizontalAdvance(thinning_words(body, 1.0)));
    return widest;
}

/// A number keeps its sign where the words take two lines.
QString unbroken(QString words) {
    return words.replace(QStringLiteral(" %"), QStringLiteral("\u00a0%"));
}

}  // namespace

ThinningSlider::ThinningSlider(Qt::Orientation direction, QWidget* parent)
    : QWidget(parent), slider_(new QSlider(Qt::Horizontal)), words_(new QLabel) {
    const bool above = direction == Qt::Vertical;
    auto* layout = new QBoxLayout(above ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight, this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(above ? 0 : 4);
    slider_->setObjectName(QStringLiteral("paint_share"));
    slider_->setAccessibleName(tr("Paint : medium"));
    slider_->setRange(0, SliderScale::kSteps);
    slider_->setPageStep(SliderScale::kSteps / 10);
    keep_keys_for_canvas(slider_);
    keep_own_keys(slider_, {Qt::Key_PageUp, Qt::Key_PageDown});
    words_->setObjectName(QStringLiteral("reading"));
    words_->setAlignment(above ? Qt::AlignCenter : Qt::AlignVCenter | Qt::AlignLeft);
    words_->setMinimumWidth(widest_words(words_->fontMetrics()));
    slider_->setFixedWidth(kLength_px);
    layout->addWidget(above ? static_cast<QWidget*>(words_) : slider_, 0, Qt::AlignHCenter);
    layout->addWidget(above ? static_cast<QWidget*>(slider_) : words_, 0, Qt::AlignHCenter);
    show_hint();
    resting_.setSingleShot(true);
    resting_.setInterval(kRest_ms);
    connect(&resting_, &QTimer::timeout, this, [this] { Q_EMIT share_chosen(share_); });
    connect(slider_, &QSlider::valueChanged, this, [this](int step) {
        show_share(share_at(step));
        resting_.start();
    });
}

void ThinningSlider::show_hint() {
    setToolTip(slider_->orientation() == Qt::Vertical
                   ? tr("Paint : medium, from paste to stain. Upwards the paint is thinned: it "
                        "runs sooner, and lets through what lies below")
                   : tr("Paint : medium, from paste to stain. To the right the paint is thinned: it "
                        "runs sooner, and lets through what lies below"));
}

void ThinningSlider::set_upright(bool upright) {
    static_cast<QBoxLayout*>(layout())->setDirection(upright ? QBoxLayout::TopToBottom
                                                             : QBoxLayout::LeftToRight);
    slider_->setOrientation(upright ? Qt::Vertical : Qt::Horizontal);
    slider_->setMinimumSize(upright ? QSize(0, kLength_px) : QSize(kLength_px, 0));
    slider_->setMaximumSize(upright ? QSize(QWIDGETSIZE_MAX, kLength_px)
                                    : QSize(kLength_px, QWIDGETSIZE_MAX));
    words_->setWordWrap(upright);
    words_->setAlignment(upright ? Qt::AlignHCenter | Qt::AlignTop : Qt::AlignVCenter | Qt::AlignLeft);
    words_->setMinimumSize(upright ? QSize(kUprightWidth_px, 2 * words_->fontMetrics().lineSpacing())
                                   : QSize(widest_words(words_->fontMetrics()), 0));
    words_->setMaximumWidth(upright ? kUprightWidth_px : QWIDGETSIZE_MAX);
    show_hint();
}

void ThinningSlider::finish() {
    if (!resting_.isActive()) return;
    resting_.stop();
    Q_EMIT share_chosen(share_);
}

void ThinningSlider::show_hand(const tools::Hand& hand) {
    if (resting_.isActive() && hand.medium == in_hand_) return;
    resting_.stop();
    in_hand_ = hand.medium;
    unthinned_ = tools::unthinned_medium(hand);
    setEnabled(tools::can_thin(hand));
    show_share(hand.medium.paint_share);
    const QSignalBlocker quiet(slider_);
    slider_->setValue(step_of(share_));
}

void ThinningSlider::show_share(double share) {
    share_ = share;
    words_->setText(unbroken(thinning_words(tools::body_of(film::thinned(unthinned_, share)), share)));
}

}  // namespace pastoso::panels
