#include "appearance/shown_time.hpp"

#include <QLocale>

namespace pastoso::appearance {
namespace {

/// Where a language tells the part of the day by a letter that Qt does not know and would print, the hours
/// of the whole day are counted.
QString time_format(const QLocale& locale) {
    const QString format = locale.timeFormat(QLocale::ShortFormat);
    return format.contains(QLatin1Char('B')) ? QStringLiteral("HH:mm") : format;
}

}  // namespace

QString shown_time(const QTime& time) {
    const QLocale locale;
    return locale.toString(time, time_format(locale));
}

QString shown_time(const QDateTime& time) {
    return QLocale().toString(time.date(), QLocale::ShortFormat) + QLatin1Char(' ') +
           shown_time(time.time());
}

}  // namespace pastoso::appearance
