// Small shared pieces of the panels.
#pragma once

#include <vector>

#include <QKeyCombination>

class QAbstractItemView;
class QAction;
class QComboBox;
class QDoubleSpinBox;
class QListView;
class QScrollArea;
class QString;
class QToolButton;
class QVBoxLayout;
class QWidget;

namespace pastoso::panels {

/// A column in `panel` under a heading, which has these buttons beside it.
QVBoxLayout* section(QWidget* panel, const QString& words,
                     const std::vector<QToolButton*>& buttons = {});

/// What does not fit is scrolled to, up and down; a click beside the controls leaves the keys to the
/// canvas.
QScrollArea* scrolled(QWidget* content);

/// Lets a box be narrower than the longest of its entries.
void let_shrink(QComboBox* box);

/// Leaves the keyboard to the canvas, where Space and the letter keys mean something else, until the
/// Tab key asks for the widget.
void keep_keys_for_canvas(QWidget* widget);

/// Lets the widget answer to these keys itself while it has the keyboard, whatever commands they give
/// elsewhere.
void keep_own_keys(QWidget* widget, const std::vector<QKeyCombination>& keys);

/// Gives a list the keyboard when it is clicked, until the pointer is over the canvas again: then arrows
/// and the first letters of a name move in it, and F2, Delete and Backspace are for what it lists alone.
void take_keys_of_list(QAbstractItemView* list);

/// A button for an action, with its icon and its words, as wide as there is room.
QToolButton* action_button(QAction* action);

/// One with its icon alone, no larger than a line of words.
QToolButton* small_button(QAction* action);

/// Buttons for actions side by side, all of one width.
QWidget* button_row(const std::vector<QAction*>& actions);

/// The same without words.
QWidget* icon_row(const std::vector<QAction*>& actions);

/// Shows the number without a signal.
void show_number(QDoubleSpinBox* box, double value);

/// Makes a list just tall enough for so many rows; the others are scrolled to.
void fit_to_rows(QListView* list, int rows);

}  // namespace pastoso::panels
