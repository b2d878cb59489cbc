#include "main/language.hpp"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace pastoso::main {
namespace {

void use(QTranslator& translator, const QLocale& locale, const QString& name, const QString& folder) {
    QCoreApplication::removeTranslator(&translator);
    if (translator.load(locale, name, QStringLiteral("_"), folder))
        QCoreApplication::installTranslator(&translator);
}

}  // namespace

void speak(const QString& language) {
    static QTranslator qt_words, own_words;
    const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
    QLocale::setDefault(locale);
    use(qt_words, locale, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    use(own_words, locale, QStringLiteral("pastoso"), QStringLiteral(":/translations"));
}

}  // namespace pastoso::main
