// Dates and times in the painter's language, short.
#pragma once

#include <QDateTime>

namespace pastoso::appearance {

QString shown_time(const QTime& time);
QString shown_time(const QDateTime& time);

}  // namespace pastoso::appearance
