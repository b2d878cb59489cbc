// Words that stand in panels and dialogs.
#pragma once

class QLabel;
class QString;

namespace pastoso::panels {

QLabel* heading(const QString& words);

/// Quiet, and as many lines as it needs.
QLabel* note(const QString& words);

}  // namespace pastoso::panels
