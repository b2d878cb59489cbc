#include "appearance/unit_box.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <utility>

#include <QKeyEvent>
#include <QLineEdit>
#include <QToolTip>

namespace pastoso::appearance {
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

std::optional<double> read_pixels(const QString& words, const QLocale& locale) {
    constexpr Unit kUnits[] = {{QLatin1String("px"), 1.0}, {QLatin1String("pixels"), 1.0}};
    return read(words, locale, kUnits);
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
    // Said before the number follows what is typed.
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] {
        if (!before_typing_) before_typing_ = value();
    });
    connect(this, &QAbstractSpinBox::editingFinished, this, [this] { before_typing_.reset(); });
}

QString UnitBox::typed_in(const QString& text) const {
    return (text.endsWith(suffix()) ? text.chopped(suffix().size()) : text).trimmed();
}

std::optional<double> UnitBox::read(const QString& text) const {
    const QString words = typed_in(text).toLower();
    if (const auto pixels = px_per_mm_ ? read_pixels(words, locale()) : std::nullopt)
        return *pixels / px_per_mm_();
    return reader_(words, locale());
}

bool UnitBox::begins_as_number(const QString& text) const {
    const bool is_negative =
        text.startsWith(QLatin1Char('-')) || text.startsWith(locale().negativeSign());
    return (is_negative && minimum() < 0.0) || (!text.isEmpty() && text.front().isDigit());
}

/// What is not read yet may become so by more letters.
QValidator::State UnitBox::validate(QString& text, int& cursor) const {
    const auto value = read(text);
    if (value && *value >= minimum() && *value <= maximum()) return QValidator::Acceptable;
    const bool is_number = QDoubleSpinBox::validate(text, cursor) != QValidator::Invalid;
    const bool begins_so = begins_as_number(text.trimmed());
    return value || is_number || begins_so ? QValidator::Intermediate : QValidator::Invalid;
}

/// Each key that made a number has set it, and "3000 px" began with one.
void UnitBox::fixup(QString& text) const {
    const auto typed = read(text);
    if (!typed && !text.isEmpty()) tell_refused(text);
    const double kept =
        typed ? std::clamp(*typed, minimum(), maximum()) : before_typing_.value_or(value());
    text = textFromValue(kept) + suffix();
}

/// Once the keyboard is where it goes: its way hides what is shown.
void UnitBox::tell_refused(const QString& text) const {
    const QString words =
        tr("\"%1\" is not understood here; the number stays as it was.").arg(typed_in(text));
    const auto show = [box = lineEdit(), words] {
        QToolTip::showText(box->mapToGlobal(QPoint(0, box->height())), words, box);
    };
    QMetaObject::invokeMethod(lineEdit(), show, Qt::QueuedConnection);
}

void UnitBox::stepBy(int steps) {
    QDoubleSpinBox::stepBy(steps);
    before_typing_.reset();
}

/// What is refused closes no dialog.
void UnitBox::keyPressEvent(QKeyEvent* event) {
    const bool ends = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const bool refused = ends && !read(text());
    QDoubleSpinBox::keyPressEvent(event);
    if (refused) event->accept();
}

double UnitBox::valueFromText(const QString& text) const {
    return read(text).value_or(value());
}

}  // namespace pastoso::appearance
