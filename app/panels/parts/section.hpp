// Small shared pieces of the panels.
#pragma once

#include <vector>

#include <QKeyCombination>

class QAction;
class QDoubleSpinBox;
class QListView;
class QString;
class QToolButton;
class QVBoxLayout;
class QWidget;

namespace pastoso::panels {

/// A column in `panel` under a heading.
QVBoxLayout* section(QWidget* panel, const QString& heading);

/// Leaves the keyboard to the canvas, where Space and the letter keys mean something else, until the
/// Tab key asks for the widget.
void keep_keys_for_canvas(QWidget* widget);

/// Lets the widget answer to these keys itself while it has the keyboard, whatever commands they give
/// elsewhere.
void keep_own_keys(QWidget* widget, const std::vector<QKeyCombination>& keys);

/// A button for an action, with its icon and its words, as wide as there is room.
QToolButton* action_button(QAction* action);

/// Such buttons side by side, all of one width.
QWidget* button_row(const std::vector<QAction*>& actions);

/// The same without words.
QWidget* icon_row(const std::vector<QAction*>& actions);

/// Shows the number without a signal.
void show_number(QDoubleSpinBox* box, double value);

/// Makes a list just tall enough for so many rows; the others are scrolled to.
void fit_to_rows(QListView* list, int rows);

}  // namespace pastoso::panels
