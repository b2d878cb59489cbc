#include "dialogs/length_box.hpp"

#include "core/units.hpp"

#include <cmath>
#include <utility>

namespace pastoso::dialogs {
namespace {

constexpr int kDecimals = 2;

struct Unit {
    QLatin1String words;
    double worth;  ///< in the box's own unit
};

/// The number before one of the units; longer ones stand first where one ends like another.
template <std::size_t count>
std::optional<double> read(const QString& words, const QLocale& locale, const Unit (&units)[count]) {
    for (const Unit& unit : units) {
        if (!words.endsWith(unit.words)) continue;
        bool is_number = false;
        const QString number = words.chopped(unit.words.size()).trimmed();
        double value = locale.toDouble(number, &is_number);
        if (!is_number) value = QLocale::c().toDouble(number, &is_number);
        if (is_number) return value * unit.worth;
    }
    return {};
}

}  // namespace

std::optional<double> read_length_mm(const QString& words, const QLocale& locale) {
    constexpr Unit kUnits[] = {{QLatin1String("mm"), 1.0},
                               {QLatin1String("cm"), 10.0},
                               {QLatin1String("m"), 1000.0},
                               {QLatin1String("inches"), core::kInch_mm},
                               {QLatin1String("inch"), core::kInch_mm},
                               {QLatin1String("in"), core::kInch_mm},
                               {QLatin1String("\""), core::kInch_mm},
                               {QLatin1String(""), 1.0}};
    return read(words, locale, kUnits);
}

std::optional<double> read_px_per_mm(const QString& words, const QLocale& locale) {
    constexpr Unit kUnits[] = {{QLatin1String("px/mm"), 1.0},
                               {QLatin1String("dpi"), 1.0 / core::kInch_mm},
                               {QLatin1String("ppi"), 1.0 / core::kInch_mm},
                               {QLatin1String(""), 1.0}};
    return read(words, locale, kUnits);
}

UnitBox::UnitBox(Reader reader, const QString& name, const QString& suffix, QWidget* parent)
    : QDoubleSpinBox(parent), reader_(reader) {
    setObjectName(name);
    setDecimals(kDecimals);
    setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    setSuffix(suffix);
}

std::optional<double> UnitBox::read(const QString& text) const {
    const QString typed = text.endsWith(suffix()) ? text.chopped(suffix().size()) : text;
    return reader_(typed.trimmed().toLower(), locale());
}

/// What is not read yet may become so by more letters.
QValidator::State UnitBox::validate(QString& text, int& cursor) const {
    const auto value = read(text);
    if (value && *value >= minimum() && *value <= maximum()) return QValidator::Acceptable;
    const bool is_number = QDoubleSpinBox::validate(text, cursor) != QValidator::Invalid;
    const bool begins_so = !text.trimmed().isEmpty() && text.trimmed().front().isDigit();
    return value || is_number || begins_so ? QValidator::Intermediate : QValidator::Invalid;
}

double UnitBox::valueFromText(const QString& text) const {
    return read(text).value_or(value());
}

double in_hundredths(double value) {
    return std::round(100.0 * value) / 100.0;
}

double unrounded(const QDoubleSpinBox& box, double exact) {
    const double half_step = 0.5 * std::pow(10.0, -box.decimals());
    return std::abs(box.value() - exact) <= half_step ? exact : box.value();
}

}  // namespace pastoso::dialogs
