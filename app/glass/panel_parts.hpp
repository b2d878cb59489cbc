// What the liquids' panels are made of.
#pragma once

#include <QString>

class QAction;
class QGridLayout;
class QVBoxLayout;
class QWidget;

namespace pastoso::panels {
class FeelRow;
class Fold;
class ValueRow;
}  // namespace pastoso::panels

namespace pastoso::glass {

using panels::FeelRow;
using panels::Fold;
using panels::ValueRow;

class GlassChooser;

/// The actions on the page of any liquid.
struct GlassActions {
    QAction *back, *pause, *full_speed, *front;
};

/// The column of a panel's sections.
QVBoxLayout* column_of(QWidget* panel);

/// A section at the end of a column.
QVBoxLayout* section_under(QVBoxLayout* column, const QString& heading);

/// The same, with the button that brings the painting back above it and the chooser in it.
QVBoxLayout* glass_section_under(QVBoxLayout* column, const QString& heading, QAction* back,
                                 GlassChooser* chooser);

/// A grid for numbers at the end of a column.
QGridLayout* rows_under(QVBoxLayout* column);

/// A number as the panel shows it.
struct NumberWords {
    const char* words;
    const char* hint;
    const char* unit;  ///< with the space before it
    double scale;      ///< shown = scale times SI
    int decimals;
    double usual_least, usual_most;  ///< as shown
    bool logarithmic = false;
};

/// A row for it at the end of a grid; name and limits, in SI, are those that it has in files.
ValueRow* add_number(QGridLayout* grid, const NumberWords& number, const char* name, double least,
                     double most);

/// A slider in words, as the panel shows it.
struct FeelWords {
    const char* name;  ///< of its widget
    const char* from;
    const char* to;
    const char* hint;
};

FeelRow* add_feel(QGridLayout* grid, const FeelWords& feel);

/// Where all numbers are that one can do without.
Fold* new_numbers_fold();

/// Words of a table in the language of the window.
QString words_of(const char* text);

}  // namespace pastoso::glass
