// The language that the window speaks.
#pragma once

#include <QString>

namespace pastoso::main {

/// What is shown from now on is in this language, "ja" or "zh_TW" for example, numbers as it writes
/// them; empty: in that of the desktop. English where there is no translation. For the whole program,
/// before there is a window.
void speak(const QString& language);

}  // namespace pastoso::main
