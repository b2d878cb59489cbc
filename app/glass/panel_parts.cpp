#include "glass/panel_parts.hpp"

#include "glass/glass_chooser.hpp"
#include "panels/parts/feel_row.hpp"
#include "panels/parts/fold.hpp"
#include "panels/parts/section.hpp"
#include "panels/parts/value_row.hpp"

#include <QAction>
#include <QCoreApplication>
#include <QGridLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace pastoso::glass {
namespace {

constexpr const char* kBack = QT_TR_NOOP("Back to the painting");
constexpr const char* kNumbers = QT_TR_NOOP("Numbers");
constexpr const char* kNumbersHint = QT_TR_NOOP("Each number of the liquid");
constexpr const char* kBackHint = QT_TR_NOOP("The glass waits as it is, and so did the painting");

/// The button that brings the painting back.
QToolButton* back_button(QAction* back) {
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("back_to_painting"));
    button->setText(words_of(kBack));
    button->setIcon(back->icon());
    button->setToolTip(words_of(kBackHint));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    panels::keep_keys_for_canvas(button);
    QObject::connect(button, &QToolButton::clicked, back, &QAction::trigger);
    return button;
}

}  // namespace

QVBoxLayout* column_of(QWidget* panel) {
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(10, 8, 10, 8);
    column->setSpacing(12);
    return column;
}

QVBoxLayout* section_under(QVBoxLayout* column, const QString& heading) {
    auto* widget = new QWidget;
    column->addWidget(widget);
    return panels::section(widget, heading);
}

QVBoxLayout* glass_section_under(QVBoxLayout* column, const QString& heading, QAction* back,
                                 GlassChooser* chooser) {
    QVBoxLayout* section = section_under(column, heading);
    section->insertWidget(0, back_button(back));
    section->addWidget(chooser);
    return section;
}

QGridLayout* rows_under(QVBoxLayout* column) {
    auto* widget = new QWidget;
    auto* grid = new QGridLayout(widget);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    column->addWidget(widget);
    return grid;
}

ValueRow* add_number(QGridLayout* grid, const NumberWords& number, const char* name, double least,
                     double most) {
    return new ValueRow(grid, QString::fromLatin1(name), words_of(number.words), words_of(number.hint),
                        {number.scale * least,
                         number.scale * most,
                         number.decimals,
                         words_of(number.unit),
                         number.logarithmic,
                         {{number.usual_least, number.usual_most}}});
}

FeelRow* add_feel(QGridLayout* grid, const FeelWords& feel) {
    return new FeelRow(grid, QString::fromLatin1(feel.name), words_of(feel.from), words_of(feel.to),
                       words_of(feel.hint));
}

Fold* new_numbers_fold() {
    return new Fold(QStringLiteral("liquid_numbers"), words_of(kNumbers), words_of(kNumbersHint));
}

QString words_of(const char* text) {
    return QCoreApplication::translate("pastoso::glass", text);
}

}  // namespace pastoso::glass
