// How widgets are drawn, in Qt's style sheets, with the colours of a theme.
#pragma once

#include "appearance/theme.hpp"

#include <QString>

namespace pastoso::appearance {

QString style_sheet(const ThemeColours& colours);

}  // namespace pastoso::appearance
