// Words that stand in panels and dialogs.
#pragma once

class QLabel;
class QString;

namespace pastoso::panels {

QLabel* heading(const QString& words);

/// Quiet, and as many lines as it needs.
QLabel* note(const QString& words);

/// Words that stand in a table of the panels, by QT_TR_NOOP, in the painter's language.
QString translated(const char* words);

}  // namespace pastoso::panels
