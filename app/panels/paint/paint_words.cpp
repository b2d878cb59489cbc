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

QString body_words(tools::Body body) {
    switch (body) {
        case tools::Body::Paste:
            return QObject::tr("paste");
        case tools::Body::Cream:
            return QObject::tr("cream");
        case tools::Body::Milk:
            return QObject::tr("milk");
        case tools::Body::Wash:
            return QObject::tr("wash");
        case tools::Body::Stain:
            break;
    }
    return QObject::tr("stain");
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

QString hiding_words(pigment::Hiding hiding) {
    switch (hiding) {
        case pigment::Hiding::Transparent:
            return QObject::tr("transparent");
        case pigment::Hiding::SemiTransparent:
            return QObject::tr("semi-transparent");
        case pigment::Hiding::SemiOpaque:
            return QObject::tr("semi-opaque");
        case pigment::Hiding::Opaque:
            break;
    }
    return QObject::tr("opaque");
}

QString thinning_words(tools::Body body, double paint_share) {
    return QObject::tr("%1, %2").arg(body_words(body), percent_words(100.0 * paint_share));
}

QString paint_words(const document::PaintRecipe& paint, pigment::Hiding hiding) {
    const QString name = recipe_words(paint);
    return paint.ingredients.empty() ? name : QObject::tr("%1, %2").arg(name, hiding_words(hiding));
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

QString recipe_lines(const document::PaintRecipe& paint) {
    QStringList lines;
    for (const document::Ingredient& part : paint.ingredients) {
        const document::PaintRecipe tube{{{part.pigment, 1.0}}, 1.0};
        const QString name = recipe_words(tube);
        const QString parts = QString::number(part.parts);
        lines += paint.ingredients.size() > 1 ? QStringLiteral("%1 \u00d7 %2").arg(parts, name) : name;
    }
    if (paint.ingredients.size() > 1) lines += share_words(paint);
    return lines.join('\n');
}

QString difference_words(double difference) {
    if (difference < 1.0) return QObject::tr("the same to the eye");
    if (difference < 2.5) return QObject::tr("close");
    if (difference < 6.0) return QObject::tr("a little off");
    return QObject::tr("beyond these tubes");
}

}  // namespace pastoso::panels
