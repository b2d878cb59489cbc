#include "appearance/style_sheet.hpp"

#include "core/error.hpp"
#include "core/resources.hpp"

namespace pastoso::appearance {
namespace {

/// <window>, <edge> ... stand for the theme's colours.
const char* const kRules = R"(
QToolTip { background: <field>; color: <text>; border: 1px solid <line>; padding: 4px; }
QLabel#heading { font-weight: 600; color: <quiet_text>; }
QLabel#reading { color: <quiet_text>; }
QLabel#canvas_note { background: <window>; color: <text>; border: 1px solid <line>; border-radius: 4px; padding: 5px 9px; }
QFrame#message_bar { background: <window>; border: 1px solid <warning>; border-left: 5px solid <warning>; border-radius: 4px; }
QToolBar { background: <window>; border: none; border-bottom: 1px solid <edge>; spacing: 4px; padding: 4px; }
QToolBar:left { border-bottom: none; border-right: 1px solid <edge>; }
QToolBar:right { border-bottom: none; border-left: 1px solid <edge>; }
QMenuBar { background: <window>; border-bottom: 1px solid <edge>; }
QMenuBar::item { padding: 5px 7px; background: transparent; }
QMenuBar::item:selected { background: <button>; border-radius: 4px; }
QMenu { background: <window>; border: 1px solid <line>; padding: 4px; }
QMenu::item { padding: 5px 28px 5px 22px; border-radius: 3px; }
QMenu::item:selected { background: <chosen>; }
QMenu::item:disabled { color: <faint_text>; }
QMenu::separator { height: 1px; background: <line>; margin: 4px 6px; }
QStatusBar { background: <window>; border-top: 1px solid <edge>; color: <quiet_text>; }
QStatusBar::item { border: none; }
QStatusBar QToolButton { padding: 3px 7px; }
QStatusBar QLabel { color: <quiet_text>; padding: 0px 7px; }
QWidget#pace_notice QLabel { color: <text>; padding: 0px 4px; }
QWidget#pace_notice QPushButton { padding: 5px 8px; }
QListView, QTreeView, QComboBox, QAbstractSpinBox { background: <field>; border: 1px solid <line>; border-radius: 4px; }
QListView { padding: 2px; outline: none; }
QListView::item { padding: 3px 4px; border-radius: 3px; }
QListView::item:hover { background: <window>; }
QListView::item:selected { background: <chosen>; color: <chosen_text>; }
QTreeView { padding: 2px 0px; outline: none; }
QFrame#command_palette { background: <window>; border: 1px solid <line>; }
#command_palette QLineEdit, #keys_dialog QLineEdit, QLineEdit#brush_search { background: <field>; border: 1px solid <line>; border-radius: 4px; padding: 5px 8px; }
#command_palette QLineEdit:focus, #keys_dialog QLineEdit:focus, QLineEdit#brush_search:focus { border-color: <accent>; }
#command_palette QListView { border: none; background: transparent; }
#keys_dialog QTreeView::item:hover { background: <window>; }
#keys_dialog QTreeView::item:selected { background: <chosen>; color: <chosen_text>; }
#keys_dialog QToolButton { background: transparent; border: none; padding: 4px 5px; color: <quiet_text>; }
#keys_dialog QToolButton:hover { color: <chosen_text>; }
#keys_dialog QToolButton:focus { border: 1px solid <focus>; padding: 3px 4px; }
#keys_dialog QLabel#sentence { color: <warning>; }
QComboBox { padding: 4px 8px; }
QComboBox[fast="true"] { background: <chosen>; border-color: <accent>; color: <chosen_text>; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox[upright="true"] { padding: 4px 3px; }
QComboBox[upright="true"]::drop-down { width: 12px; }
QComboBox::down-arrow { image: url("<icons>/box_down.svg"); width: 10px; height: 10px; }
QComboBox QAbstractItemView { background: <field>; color: <text>; selection-background-color: <chosen>; selection-color: <chosen_text>; }
QAbstractSpinBox { padding: 3px 4px; }
QAbstractSpinBox[buttonSymbols="UpDownArrows"]::up-button, QAbstractSpinBox[buttonSymbols="UpDownArrows"]::down-button { border: none; width: 16px; }
QAbstractSpinBox[buttonSymbols="UpDownArrows"]::up-arrow { image: url("<icons>/box_up.svg"); width: 9px; height: 9px; }
QAbstractSpinBox[buttonSymbols="UpDownArrows"]::down-arrow { image: url("<icons>/box_down.svg"); width: 9px; height: 9px; }
QInputDialog > QLineEdit { min-width: 280px; }
QDialogButtonBox, QMessageBox { dialogbuttonbox-buttons-have-icons: 0; }
QPushButton { background: <button>; border: 1px solid <line>; border-radius: 4px; padding: 5px 14px; }
QPushButton:hover { background: <hovered>; }
QPushButton:default { background: <chosen>; border-color: <accent>; color: <chosen_text>; }
QPushButton:disabled { color: <faint_text>; background: <window>; border-color: <button>; }
QToolButton { background: <button>; border: 1px solid <line>; border-radius: 4px; padding: 5px 9px; }
QToolButton[small="true"] { background: transparent; border: 1px solid transparent; padding: 2px 4px; }
QToolBar QToolButton { padding: 5px 7px; }
QToolButton[popupMode="InstantPopup"] { padding-right: 20px; }
QPushButton::menu-indicator, QToolButton::menu-indicator { image: url("<icons>/box_down.svg"); width: 9px; height: 9px; subcontrol-origin: padding; subcontrol-position: right center; right: 5px; }
QToolButton#qt_toolbar_ext_button, QToolButton#qt_menubar_ext_button { padding: 0px; }
QTabBar QToolButton { padding: 0px; }
QTabBar QToolButton::left-arrow { image: url("<icons>/box_left.svg"); width: 10px; height: 10px; }
QTabBar QToolButton::right-arrow { image: url("<icons>/box_right.svg"); width: 10px; height: 10px; }
QFileDialog QToolButton { padding: 4px; }
QMainWindow > QTabBar { qproperty-elideMode: ElideNone; qproperty-usesScrollButtons: true; }
QToolButton:hover { background: <hovered>; }
QToolButton:pressed, QToolButton:checked { background: <chosen>; border-color: <accent>; color: <chosen_text>; }
QToolButton:disabled { color: <faint_text>; background: <window>; border-color: <button>; }
QScrollBar:vertical { background: transparent; width: 9px; margin: 0px; }
QScrollBar::handle:vertical { background: <line>; border-radius: 4px; min-height: 24px; }
QScrollBar::add-line, QScrollBar::sub-line { height: 0px; }
QSlider::groove:horizontal { height: 4px; background: <edge>; border-radius: 2px; }
QSlider::sub-page:horizontal { background: <accent>; border-radius: 2px; }
QSlider::handle:horizontal { width: 14px; margin: -5px 0px; border-radius: 7px; background: <text>; }
QSlider::groove:vertical { width: 4px; background: <edge>; border-radius: 2px; }
QSlider::add-page:vertical { background: <accent>; border-radius: 2px; }
QSlider::handle:vertical { height: 14px; margin: 0px -5px; border-radius: 7px; background: <text>; }
QPushButton:focus, QToolButton:focus, QComboBox:focus, QAbstractSpinBox:focus, QLineEdit:focus, QPlainTextEdit:focus, QListView:focus, QTreeView:focus { border: 1px solid <focus>; }
QSlider::handle:focus { background: <focus>; border: 2px solid <text>; }
QSlider::sub-page:horizontal:disabled, QSlider::add-page:vertical:disabled { background: <line>; }
QSlider::handle:disabled { background: <very_faint>; }
)";

struct NamedColour {
    const char* name;
    QColor ThemeColours::*colour;
};
constexpr NamedColour kColours[] = {
    {"<window>", &ThemeColours::window},
    {"<edge>", &ThemeColours::edge},
    {"<field>", &ThemeColours::field},
    {"<button>", &ThemeColours::button},
    {"<hovered>", &ThemeColours::hovered},
    {"<line>", &ThemeColours::line},
    {"<text>", &ThemeColours::text},
    {"<quiet_text>", &ThemeColours::quiet_text},
    {"<faint_text>", &ThemeColours::faint_text},
    {"<very_faint>", &ThemeColours::very_faint},
    {"<accent>", &ThemeColours::accent},
    {"<focus>", &ThemeColours::focus},
    {"<chosen>", &ThemeColours::chosen},
    {"<chosen_text>", &ThemeColours::chosen_text},
    {"<warning>", &ThemeColours::warning},
};

/// Of the arrows in boxes, whose grey is seen in any theme: a style sheet takes pictures from files
/// alone.
QString icon_folder() {
    try {
        return QString::fromStdString(core::resource_path("icons").generic_string());
    } catch (const core::InputError&) {
        return {};  // a box without an arrow is a box still
    }
}

}  // namespace

QString style_sheet(const ThemeColours& colours) {
    QString rules = QString::fromUtf8(kRules);
    for (const NamedColour& named : kColours)
        rules.replace(QLatin1String(named.name), (colours.*named.colour).name());
    rules.replace(QLatin1String("<icons>"), icon_folder());
    return rules;
}

}  // namespace pastoso::appearance
