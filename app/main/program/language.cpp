#include "main/program/language.hpp"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace pastoso::main {
namespace {

/// Of Qt's own buttons, which no Swedish comes with.
[[maybe_unused]] constexpr const char* kButtonWords[] = {
    QT_TRANSLATE_NOOP("QPlatformTheme", "OK"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Save"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Open"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "&Yes"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "&No"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Close"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Cancel"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Discard"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Help"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Apply"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Reset"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Restore Defaults"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Retry"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Ignore"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Abort"),
};

/// Whether there are such words.
bool use(QTranslator& translator, const QLocale& locale, const QString& name, const QString& folder) {
    QCoreApplication::removeTranslator(&translator);
    return translator.load(locale, name, QStringLiteral("_"), folder) &&
           QCoreApplication::installTranslator(&translator);
}

}  // namespace

void speak(const QString& language) {
    static QTranslator qt_words, own_words;
    const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
    QLocale::setDefault(locale);
    use(qt_words, locale, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    const QString own = QStringLiteral("pastoso"), folder = QStringLiteral(":/translations");
    // English, too, has words of its own for one and for several.
    if (!use(own_words, locale, own, folder)) use(own_words, QLocale(QLocale::English), own, folder);
}

}  // namespace pastoso::main
