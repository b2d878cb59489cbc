#include "panels/messages/message_bar.hpp"

#include "panels/messages/wrapped_text.hpp"
#include "panels/parts/section.hpp"

#include <algorithm>

#include <QAccessible>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr int kAround_px = 8;

}  // namespace

MessageBar::MessageBar(MessageLog& log, QWidget* parent)
    : QFrame(parent), log_(log), column_(new QVBoxLayout(this)) {
    setObjectName(QStringLiteral("message_bar"));
    setAccessibleName(tr("What needs your attention"));
    setAttribute(Qt::WA_NoMousePropagation);  // a click beside its buttons is no stroke
    setCursor(Qt::ArrowCursor);
    column_->setContentsMargins(12, 8, 8, 8);
    connect(&log_, &MessageLog::standing_changed, this, &MessageBar::show_messages);
    show_messages();
}

void MessageBar::lie_on(const QRect& place) {
    place_ = place;
    fit();
}

/// A button that was pressed is still busy with that when its row goes.
void MessageBar::show_messages() {
    if (rows_ != nullptr) {
        rows_->hide();
        rows_->deleteLater();
    }
    rows_ = new QWidget;
    auto* rows = new QVBoxLayout(rows_);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(6);
    for (const StandingMessage& message : log_.standing())
        rows->addWidget(row(message));
    column_->addWidget(rows_);
    setVisible(!log_.standing().empty());
    if (isHidden()) return;
    fit();
    raise();
    QAccessibleEvent told(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&told);
}

QWidget* MessageBar::row(const StandingMessage& message) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(new WrappedText(message.sentence), 1);
    const auto add_button = [&](const QString& words, const char* name) {
        auto* button = new QPushButton(words);
        button->setObjectName(QString::fromLatin1(name));
        button->setToolTip(message.sentence);
        keep_keys_for_canvas(button);
        layout->addWidget(button, 0, Qt::AlignTop);
        return button;
    };
    if (message.remedy)
        connect(add_button(message.remedy_words, "remedy"), &QPushButton::clicked, this, message.remedy);
    connect(add_button(tr("Put away"), "put_away"), &QPushButton::clicked, this,
            [this, matter = message.matter] { log_.solve(matter); });
    return row;
}

void MessageBar::fit() {
    if (log_.standing().empty() || place_.isEmpty()) return;
    const int width = std::max(0, place_.width() - 2 * kAround_px);
    column_->invalidate();
    column_->activate();
    const int height = std::min(column_->totalHeightForWidth(width), place_.height());
    setGeometry(place_.x() + kAround_px, place_.bottom() + 1 - kAround_px - height, width, height);
}

}  // namespace pastoso::panels
