// Small shared pieces of the liquids' panels.
#pragma once

class QAction;
class QGridLayout;
class QToolButton;
class QVBoxLayout;

namespace pastoso::tea {

/// The button that brings the painting back.
QToolButton* back_button(QAction* back);

/// A grid for numbers at the end of a column.
QGridLayout* rows_under(QVBoxLayout* column);

}  // namespace pastoso::tea
