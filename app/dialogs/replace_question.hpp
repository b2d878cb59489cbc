// Asks before a file is replaced that the painter may want to keep.
#pragma once

#include <QString>

class QWidget;

namespace pastoso::dialogs {

enum class Replacing { Replace, SaveAs, Cancel };

/// `sentence` says what speaks against it. Waits for the answer; Cancel where there is none.
Replacing ask_replacing(const QString& sentence, QWidget* parent);

}  // namespace pastoso::dialogs
