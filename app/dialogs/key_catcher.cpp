#include "dialogs/key_catcher.hpp"

#include <QKeyEvent>

namespace pastoso::dialogs {
namespace {

bool is_modifier(int key) {
    return key == Qt::Key_Control || key == Qt::Key_Shift || key == Qt::Key_Alt || key == Qt::Key_Meta ||
           key == Qt::Key_AltGr || key == Qt::Key_Super_L || key == Qt::Key_Super_R ||
           key == Qt::Key_CapsLock || key == 0 || key == Qt::Key_unknown;
}

/// Shift is part of the key only where the key would be another without it: "?" is typed with Shift on
/// many keyboards, and is "?" all the same.
QKeySequence key_of(const QKeyEvent& event) {
    Qt::KeyboardModifiers modifiers =
        event.modifiers() & ~(Qt::KeypadModifier | Qt::GroupSwitchModifier);
    int key = event.key();
    if (key == Qt::Key_Backtab) key = Qt::Key_Tab;
    const QChar sign = key < Qt::Key_Escape ? QChar(key) : QChar();
    if (!sign.isNull() && !sign.isLetterOrNumber() && !sign.isSpace())
        modifiers &= ~Qt::KeyboardModifiers(Qt::ShiftModifier);
    return QKeySequence(QKeyCombination(modifiers, static_cast<Qt::Key>(key)));
}

}  // namespace

KeyCatcher::KeyCatcher(const QString& words, QWidget* parent)
    : QPushButton(words, parent), words_(words) {
    setAutoDefault(false);
    connect(this, &QPushButton::clicked, this, &KeyCatcher::listen);
}

void KeyCatcher::listen() {
    listening_ = true;
    setText(tr("Press the keys... (Esc: none)"));
    setFocus(Qt::OtherFocusReason);
}

void KeyCatcher::stop() {
    listening_ = false;
    setText(words_);
}

/// No command is given, and no widget left, by the key that is caught.
bool KeyCatcher::event(QEvent* event) {
    if (listening_ && event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    if (listening_ && event->type() == QEvent::KeyPress) {
        keyPressEvent(static_cast<QKeyEvent*>(event));
        return true;
    }
    return QPushButton::event(event);
}

void KeyCatcher::keyPressEvent(QKeyEvent* event) {
    if (!listening_) return QPushButton::keyPressEvent(event);
    event->accept();
    if (is_modifier(event->key()) || event->isAutoRepeat()) return;
    const QKeySequence key = key_of(*event);
    stop();
    if (key != QKeySequence(Qt::Key_Escape)) Q_EMIT caught(key);
}

void KeyCatcher::focusOutEvent(QFocusEvent* event) {
    stop();
    QPushButton::focusOutEvent(event);
}

}  // namespace pastoso::dialogs
