#include "commands/command_words.hpp"

#include <QCoreApplication>
#include <QRegularExpression>

namespace pastoso::commands {

QString words_of(const char* text) {
    return QCoreApplication::translate("pastoso::commands", text);
}

/// Where a script has no letters for mnemonics, "(&N)" stands behind the words.
QString plain_words(const char* text) {
    static const QRegularExpression behind(QStringLiteral("\\(&.\\)"));
    QString plain = words_of(text);
    plain.remove(behind).remove(QLatin1Char('&'));
    if (plain.endsWith(QStringLiteral("..."))) plain.chop(3);
    return plain;
}

}  // namespace pastoso::commands
