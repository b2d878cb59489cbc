// The look of the window: neutral greys, dark or light, so that the eye judges the colours of the paint
// alone.
#pragma once

#include <optional>
#include <string_view>

#include <QColor>

class QApplication;

namespace pastoso::appearance {

enum class Theme { Dark, Light };

/// High: for eyes that need more than usual; text against what is behind it at least 7 : 1, lines around
/// buttons and fields and what cannot be used at least 3 : 1 and 4.5 : 1
/// (WCAG 2.1: 1.4.6, 1.4.11, 1.4.3).
enum class Contrast { Usual, High };

/// "dark" or "light": as it is written in files.
std::string_view name_of(Theme theme);

struct ThemeColours {
    QColor window;  ///< what panels stand on
    QColor edge;    ///< between bars and what lies beside them
    QColor field;   ///< where something is written or listed
    QColor button;
    QColor hovered;  ///< a button under the pointer
    QColor line;     ///< around buttons and fields
    QColor text;
    QColor quiet_text;  ///< headings and readings
    QColor faint_text;  ///< what can't be used, or hints in a field
    QColor very_faint;  ///< marks that only matter under the pointer
    QColor accent;
    QColor focus;   ///< around what has the keyboard
    QColor chosen;  ///< behind what is chosen
    QColor chosen_text;
    QColor warning;                ///< a sentence that should be seen
    QColor bare_light, bare_dark;  ///< squares behind what no paint covers
    QColor ground;                 ///< around the canvas: without any hue, neither white nor black
};

/// The theme that was applied last; none before the first.
std::optional<Theme> theme();

/// Its colours; before the first those of the dark one.
const ThemeColours& colours();

/// In the contrast that was set last.
void apply_theme(QApplication& application, Theme theme);

/// Of this theme and the next ones.
void set_contrast(QApplication& application, Contrast contrast);

/// Has all text so many times as large as the program was started with.
void scale_text(double scale);

}  // namespace pastoso::appearance
