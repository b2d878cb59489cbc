#include "panels/parts/work_progress.hpp"

#include <cmath>

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

namespace pastoso::panels {
namespace {

constexpr int kBarWidth = 110;

}  // namespace

WorkProgress::WorkProgress(QAction* stop, QWidget* parent)
    : QWidget(parent), words_(new QLabel), bar_(new QProgressBar) {
    bar_->setRange(0, 100);
    bar_->setFormat(tr("%p %"));
    bar_->setFixedWidth(kBarWidth);
    bar_->setObjectName(QStringLiteral("work_done"));
    auto* button = new QToolButton;
    button->setDefaultAction(stop);
    button->setFocusPolicy(Qt::TabFocus);
    button->setObjectName(QStringLiteral("stop_work"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(5);
    row->addWidget(words_);
    row->addWidget(bar_);
    row->addWidget(button);
    hide();
}

void WorkProgress::show_work(const QString& words, const QString& hint) {
    words_->setText(words);
    setToolTip(hint);
    show_done(0.0);
    show();
}

void WorkProgress::show_done(double done) {
    bar_->setValue(static_cast<int>(std::floor(100.0 * done)));
}

}  // namespace pastoso::panels
