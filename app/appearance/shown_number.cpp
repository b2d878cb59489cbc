#include "appearance/shown_number.hpp"

#include <QLocale>

namespace pastoso::appearance {
namespace {

QLocale ungrouped_locale() {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale;
}

}  // namespace

QString shown_number(double value) {
    constexpr int kDigits = 6;
    return ungrouped_locale().toString(value, 'g', kDigits);
}

QString shown_number(double value, int decimals) {
    return ungrouped_locale().toString(value, 'f', decimals);
}

}  // namespace pastoso::appearance
