#include "panels/messages/message_panel.hpp"

#include "appearance/shown_time.hpp"
#include "panels/parts/section.hpp"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTime>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

/// Days of painting; more would only be memory.
constexpr int kMostLines = 1000;

QPushButton* button(const QString& words, const QString& hint, const char* name) {
    auto* made = new QPushButton(words);
    made->setToolTip(hint);
    made->setObjectName(QString::fromLatin1(name));
    keep_keys_for_canvas(made);
    return made;
}

}  // namespace

MessagePanel::MessagePanel(QWidget* parent) : QWidget(parent), list_(new QPlainTextEdit) {
    list_->setObjectName(QStringLiteral("messages"));
    list_->setAccessibleName(tr("Messages"));
    list_->setReadOnly(true);
    list_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    list_->setTabChangesFocus(true);
    list_->setFocusPolicy(Qt::StrongFocus);
    keep_own_keys(list_, {Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_F2});
    list_->setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    list_->setMaximumBlockCount(kMostLines);
    list_->setPlaceholderText(tr("Nothing has been told yet."));
    QPushButton* copy =
        button(tr("Copy all"), tr("All messages, to be pasted elsewhere"), "copy_messages");
    QPushButton* clear = button(tr("Clear"), tr("Take all messages off the list"), "clear_messages");
    connect(copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(text()); });
    connect(clear, &QPushButton::clicked, list_, &QPlainTextEdit::clear);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(copy);
    buttons->addWidget(clear);
    auto* column = new QVBoxLayout(this);
    column->addWidget(list_, 1);
    column->addLayout(buttons);
}

void MessagePanel::follow(MessageLog& log) {
    connect(&log, &MessageLog::added, this, &MessagePanel::add);
}

QString MessagePanel::text() const {
    return list_->toPlainText();
}

void MessagePanel::add(const QString& sentence) {
    const QString time = appearance::shown_time(QTime::currentTime());
    list_->appendPlainText(time + QStringLiteral("  ") + sentence);
}

}  // namespace pastoso::panels
