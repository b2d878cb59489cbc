#include "appearance/shown_message.hpp"

#include <QCoreApplication>

namespace pastoso::appearance {

QString shown_message(const core::Message& message) {
    return QString::fromStdString(message.text([](const char* pattern) {
        return QCoreApplication::translate("Engine", pattern).toStdString();
    }));
}

QString as_sentence(QString words) {
    if (!words.isEmpty()) words[0] = words[0].toUpper();
    return words;
}

QString shown_sentence(const core::Message& message) {
    return as_sentence(shown_message(message));
}

}  // namespace pastoso::appearance
