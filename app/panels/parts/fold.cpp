#include "panels/parts/fold.hpp"

#include "panels/parts/section.hpp"

#include <algorithm>

#include <QToolButton>
#include <QVBoxLayout>

namespace pastoso::panels {

Fold::Fold(const QString& name, const QString& words, const QString& hint, QWidget* parent)
    : QWidget(parent), button_(new QToolButton) {
    button_->setObjectName(name);
    button_->setText(words);
    button_->setToolTip(hint);
    button_->setCheckable(true);
    button_->setAutoRaise(true);
    button_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    keep_keys_for_canvas(button_);
    auto* content = new QWidget;
    column_ = new QVBoxLayout(content);
    column_->setContentsMargins(0, 0, 0, 0);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    for (QVBoxLayout* column : {column_, whole})
        column->setSpacing(8);
    whole->addWidget(button_);
    whole->addWidget(content);
    const auto show = [this, content](bool shown) {
        button_->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
        content->setVisible(shown);
    };
    connect(button_, &QToolButton::toggled, content, show);
    show(false);
}

void Fold::open(bool open) {
    button_->setChecked(open);
}

QSize Fold::minimumSizeHint() const {
    const QSize least = QWidget::minimumSizeHint();
    return {std::max(least.width(), column_->totalMinimumSize().width()), least.height()};
}

bool Fold::is_open() const {
    return button_->isChecked();
}

}  // namespace pastoso::panels
