#include "appearance/theme.hpp"

#include "appearance/style_sheet.hpp"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QFont>
#include <QPalette>
#include <QStyleFactory>

namespace pastoso::appearance {
namespace {

ThemeColours dark_colours() {
    return {.window = {43, 43, 45},
            .edge = {31, 31, 33},
            .field = {33, 33, 35},
            .button = {58, 58, 61},
            .hovered = {70, 70, 74},
            .line = {72, 72, 76},
            .text = {218, 218, 220},
            .quiet_text = {169, 169, 174},
            .faint_text = {122, 122, 126},
            .very_faint = {84, 84, 88},
            .accent = {104, 138, 172},
            .focus = {150, 194, 238},
            .chosen = {69, 96, 124},
            .chosen_text = {255, 255, 255},
            .warning = {224, 196, 138},
            .bare_light = {92, 92, 96},
            .bare_dark = {78, 78, 82},
            .ground = {57, 57, 57}};
}

ThemeColours light_colours() {
    return {.window = {212, 212, 213},
            .edge = {180, 180, 182},
            .field = {232, 232, 233},
            .button = {226, 226, 227},
            .hovered = {238, 238, 239},
            .line = {164, 164, 167},
            .text = {30, 30, 32},
            .quiet_text = {76, 76, 80},
            .faint_text = {128, 128, 132},
            .very_faint = {160, 160, 164},
            .accent = {58, 104, 150},
            .focus = {16, 72, 136},
            .chosen = {158, 188, 218},
            .chosen_text = {12, 20, 28},
            .warning = {128, 76, 0},
            .bare_light = {206, 206, 208},
            .bare_dark = {188, 188, 190},
            // A quarter of the light of white (ISO 3664 allows a tenth to six tenths around a print).
            .ground = {140, 140, 140}};
}

ThemeColours strengthened(ThemeColours colours, Theme theme) {
    const bool dark = theme == Theme::Dark;
    colours.text = dark ? QColor(255, 255, 255) : QColor(0, 0, 0);
    colours.quiet_text = dark ? QColor(232, 232, 234) : QColor(20, 20, 22);
    colours.faint_text = dark ? QColor(176, 176, 180) : QColor(76, 76, 80);
    colours.very_faint = colours.faint_text;
    colours.line = dark ? QColor(156, 156, 160) : QColor(84, 84, 88);
    colours.edge = colours.line;
    colours.chosen = dark ? QColor(34, 66, 98) : QColor(174, 206, 238);
    colours.chosen_text = colours.text;
    colours.warning = dark ? QColor(255, 226, 160) : QColor(84, 44, 0);
    return colours;
}

ThemeColours colours_of(Theme theme, Contrast contrast) {
    const ThemeColours usual = theme == Theme::Dark ? dark_colours() : light_colours();
    return contrast == Contrast::High ? strengthened(usual, theme) : usual;
}

struct Used {
    std::optional<Theme> theme;
    Contrast contrast = Contrast::Usual;
    ThemeColours colours = dark_colours();
};

Used& used() {
    static Used used;
    return used;
}

QPalette palette_of(const ThemeColours& colours) {
    QPalette palette(colours.button, colours.window);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(role, colours.text);
        palette.setColor(QPalette::Disabled, role, colours.faint_text);
    }
    palette.setColor(QPalette::Base, colours.field);
    palette.setColor(QPalette::AlternateBase, colours.window);
    palette.setColor(QPalette::Highlight, colours.accent);
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, colours.accent);
    palette.setColor(QPalette::PlaceholderText, colours.faint_text);
    palette.setColor(QPalette::ToolTipBase, colours.field);
    palette.setColor(QPalette::ToolTipText, colours.text);
    return palette;
}

}  // namespace

std::string_view name_of(Theme theme) {
    return theme == Theme::Dark ? "dark" : "light";
}

std::optional<Theme> theme() {
    return used().theme;
}

const ThemeColours& colours() {
    return used().colours;
}

void apply_theme(QApplication& application, Theme theme) {
    used().theme = theme;
    used().colours = colours_of(theme, used().contrast);
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(palette_of(colours()));
    application.setStyleSheet(style_sheet(colours()));
}

void set_contrast(QApplication& application, Contrast contrast) {
    if (used().contrast == contrast) return;
    used().contrast = contrast;
    if (used().theme) apply_theme(application, *used().theme);
}

void scale_text(double scale) {
    static const QFont usual = QApplication::font();
    QFont scaled = usual;
    if (usual.pointSizeF() > 0.0)
        scaled.setPointSizeF(scale * usual.pointSizeF());
    else
        scaled.setPixelSize(std::max(1, static_cast<int>(std::lround(scale * usual.pixelSize()))));
    if (scaled == QApplication::font()) return;
    QApplication::setFont(scaled);
    // A widget below a style sheet takes up the font of the application only when it is styled anew.
    qApp->setStyleSheet(qApp->styleSheet());
}

}  // namespace pastoso::appearance
