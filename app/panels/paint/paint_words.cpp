#include "panels/paint/paint_words.hpp"

#include "appearance/shown_names.hpp"
#include "core/number_text.hpp"
#include "pigment/paint_name.hpp"

#include <cmath>

#include <QObject>
#include <QStringList>

namespace pastoso::panels {
namespace {

QString number_words(double number) {
    return QString::fromStdString(core::number_text(number));
}

/// Whole percents, and tenths where a tenth matters.
QString percent_words(double percent) {
    const double step = percent < 9.95 ? 10.0 : 1.0;
    return QObject::tr("%1 %").arg(number_words(std::round(percent * step) / step));
}

}  // namespace

QString recipe_words(const document::PaintRecipe& paint) {
    if (paint.ingredients.empty()) return QObject::tr("Clear medium");
    QStringList parts;
    for (const document::Ingredient& part : paint.ingredients) {
        const QString name = appearance::shown_name(pigment::painters_name(part.pigment));
        parts +=
            paint.ingredients.size() > 1 ? number_words(part.parts) + QLatin1Char(' ') + name : name;
    }
    return parts.join(QStringLiteral(" + "));
}

QString share_words(const document::PaintRecipe& paint) {
    if (paint.ingredients.empty()) return QObject::tr("clear medium");
    double sum = 0.0;
    for (const document::Ingredient& part : paint.ingredients)
        sum += part.parts;
    QStringList shares;
    for (const document::Ingredient& part : paint.ingredients) {
        const QString pigment = QString::fromStdString(part.pigment);
        shares += paint.ingredients.size() > 1
                      ? pigment + QLatin1Char(' ') + percent_words(100.0 * part.parts / sum)
                      : pigment;
    }
    if (paint.strength < 1.0)
        shares += QObject::tr("thinned to %1").arg(percent_words(100.0 * paint.strength));
    return shares.join(QStringLiteral(", "));
}

}  // namespace pastoso::panels
