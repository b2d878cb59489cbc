#include "panels/messages/pace_notice.hpp"

#include "panels/parts/section.hpp"

#include <QAccessible>
#include <QAction>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>

namespace pastoso::panels {
namespace {

/// In the order of tools::Pace, the first of which is not told.
constexpr const char* kShares[] = {"",
                                   QT_TR_NOOP("half"),
                                   QT_TR_NOOP("a third"),
                                   QT_TR_NOOP("a quarter"),
                                   QT_TR_NOOP("a fifth"),
                                   QT_TR_NOOP("a tenth"),
                                   QT_TR_NOOP("less than a tenth")};

QString share_of(tools::Pace pace) {
    return QCoreApplication::translate("pastoso::panels", kShares[static_cast<int>(pace)]);
}

}  // namespace

PaceNotice::PaceNotice(const std::vector<Choice>& choices, QWidget* parent)
    : QWidget(parent), watch_(0.0), words_(new QLabel), all_(new QPushButton(tr("What helps"))) {
    setObjectName(QStringLiteral("pace_notice"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // the window gets no wider for it
    words_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row->addWidget(words_, 1);
    for (const Choice& choice : choices) {
        auto* button = new QPushButton(choice.words);
        button->setToolTip(choice.action->toolTip());
        keep_keys_for_canvas(button);
        connect(button, &QPushButton::clicked, choice.action, &QAction::trigger);
        connect(choice.action, &QAction::changed, this, &PaceNotice::fit);
        row->addWidget(button);
        buttons_.push_back({choice, button});
    }
    all_->setToolTip(tr("What lets the paint keep up again"));
    keep_keys_for_canvas(all_);
    all_->setMenu(new QMenu(all_));
    connect(all_->menu(), &QMenu::aboutToShow, this, &PaceNotice::fill_menu);
    row->addWidget(all_);
    hide();
}

void PaceNotice::look(const session::Status& status, double now_s) {
    if (status.paused) watch_ = tools::PaceWatch(now_s);
    const double share = status.paused ? 1.0 : status.paint_per_wall / status.speed;
    tell(watch_.look(share, now_s), status.speed);
}

void PaceNotice::tell(tools::Pace pace, double speed) {
    QString sentence;
    if (pace != tools::Pace::Full)
        sentence = speed > 1.0 ? tr("Time runs at %1 of %2 ×.").arg(share_of(pace)).arg(speed)
                               : tr("The paint runs at %1 of its pace.").arg(share_of(pace));
    if (sentence == sentence_) return;
    const bool alert = sentence_.isEmpty();
    sentence_ = sentence;
    faster_ = speed > 1.0;
    words_->setToolTip(sentence_);
    setAccessibleName(sentence_);
    fit();
    Q_EMIT sentence_changed();
    if (!alert) return;
    QAccessibleEvent told(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&told);
}

void PaceNotice::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

bool PaceNotice::helps(const Choice& choice) const {
    return choice.action->isEnabled() && (faster_ ? choice.faster_time : choice.real_time);
}

/// The choices stand beside the sentence, or in a menu where there is no room for all of them.
void PaceNotice::fit() {
    int room = width() - words_->fontMetrics().horizontalAdvance(sentence_) - 2 * words_->margin();
    for (const auto& [choice, button] : buttons_)
        if (helps(choice)) room -= layout()->spacing() + button->sizeHint().width();
    for (const auto& [choice, button] : buttons_)
        button->setVisible(helps(choice) && room >= 0);
    all_->setVisible(room < 0);
    layout()->activate();
    const int width = words_->contentsRect().width() - 2 * words_->margin();
    words_->setText(words_->fontMetrics().elidedText(sentence_, Qt::ElideRight, width));
}

void PaceNotice::fill_menu() {
    all_->menu()->clear();
    for (const auto& [choice, button] : buttons_)
        if (helps(choice)) all_->menu()->addAction(choice.words, choice.action, &QAction::trigger);
}

}  // namespace pastoso::panels
