#include "keys_table.hpp"

#include "commands/command_list.hpp"
#include "commands/command_words.hpp"
#include "commands/key_sets.hpp"

#include <QCoreApplication>
#include <QKeySequence>
#include <QStringList>

namespace pastoso::screens {
namespace {

using commands::CommandText, commands::KeySet;

QString words(const char* text) {
    return QCoreApplication::translate("pastoso::screens", text);
}

QString beginning() {
    return QLatin1String("# ") +
           words(QT_TRANSLATE_NOOP("pastoso::screens", "All commands and their keys")) +
           QLatin1String("\n\n") +
           words(QT_TRANSLATE_NOOP(
               "pastoso::screens",
               "In the order of the menus. \"Keys\" in the \"Settings\" menu changes them "
               "([how](settings.md#keys)). This page is printed by the program; "
               "`packaging/screens.sh --manual` prints it anew.")) +
           QLatin1Char('\n');
}

QString head_of(const char* menu) {
    return QStringLiteral(
               "\n## %1\n\n| %2 | Pastoso | %3 | %4 | %5 |\n| --- | --- | --- | --- | --- |\n")
        .arg(commands::plain_words(menu), words(QT_TRANSLATE_NOOP("pastoso::screens", "command")),
             words(QT_TRANSLATE_NOOP("pastoso::screens", "like Krita")),
             words(QT_TRANSLATE_NOOP("pastoso::screens", "like Photoshop")),
             words(QT_TRANSLATE_NOOP("pastoso::screens", "does")));
}

/// Backticks that hold any key, also one that Markdown reads otherwise in a table.
QString key_words(const QKeySequence& key) {
    QString words = key.toString(QKeySequence::PortableText);
    return QLatin1Char('`') + words.replace(QLatin1Char('|'), QStringLiteral("\\|")) + QLatin1Char('`');
}

QString keys_of(KeySet set, commands::Command command) {
    QStringList words;
    for (const QKeySequence& key : commands::keys_in(set, command))
        words.append(key_words(key));
    return words.join(QStringLiteral(", "));
}

QString line_of(const CommandText& text) {
    return QStringLiteral("| %1 | %2 | %3 | %4 | %5 |\n")
        .arg(commands::plain_words(text.words), keys_of(KeySet::Pastoso, text.command),
             keys_of(KeySet::Krita, text.command), keys_of(KeySet::Photoshop, text.command),
             commands::words_of(text.hint));
}

}  // namespace

std::string keys_page() {
    QString page = beginning();
    const char* menu = nullptr;
    for (const CommandText& text : commands::command_list()) {
        if (menu != text.menu) page += head_of(text.menu);
        menu = text.menu;
        page += line_of(text);
    }
    return page.toStdString();
}

}  // namespace pastoso::screens
