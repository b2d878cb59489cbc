#include "panels/theme.hpp"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace pastoso::panels {
namespace {

constexpr QColor kWindow(43, 43, 45);
constexpr QColor kField(33, 33, 35);
constexpr QColor kButton(58, 58, 61);
constexpr QColor kText(218, 218, 220);
constexpr QColor kFaintText(122, 122, 126);
constexpr QColor kAccent(104, 138, 172);

const char* const kStyleSheet = R"(
QToolTip { background: #1d1d1f; color: #dadadc; border: 1px solid #55555a; padding: 4px; }
QLabel#heading { font-weight: 600; color: #a9a9ae; }
QLabel#reading { color: #a9a9ae; }
QLabel#canvas_note { background: #2b2b2d; color: #dadadc; border: 1px solid #55555a; border-radius: 4px; padding: 5px 9px; }
QToolBar { background: #2b2b2d; border: none; border-bottom: 1px solid #1f1f21; spacing: 4px; padding: 4px; }
QMenuBar { background: #2b2b2d; border-bottom: 1px solid #1f1f21; }
QMenuBar::item { padding: 5px 10px; background: transparent; }
QMenuBar::item:selected { background: #3f3f43; border-radius: 4px; }
QMenu { background: #2b2b2d; border: 1px solid #4a4a4e; padding: 4px; }
QMenu::item { padding: 5px 28px 5px 22px; border-radius: 3px; }
QMenu::item:selected { background: #45607c; }
QMenu::item:disabled { color: #7a7a7e; }
QMenu::separator { height: 1px; background: #424246; margin: 4px 6px; }
QStatusBar { background: #2b2b2d; border-top: 1px solid #1f1f21; color: #a9a9ae; }
QStatusBar::item { border: none; }
QStatusBar QLabel { color: #a9a9ae; padding: 0px 7px; }
QListView, QTreeView, QComboBox, QAbstractSpinBox { background: #212123; border: 1px solid #38383b; border-radius: 4px; }
QListView { padding: 2px; outline: none; }
QListView::item { padding: 3px 4px; border-radius: 3px; }
QListView::item:hover { background: #2f2f32; }
QListView::item:selected { background: #45607c; color: #ffffff; }
QTreeView { padding: 2px 0px; outline: none; }
QFrame#command_palette { background: #2b2b2d; border: 1px solid #5a5a60; }
#command_palette QLineEdit, #keys_dialog QLineEdit { background: #212123; border: 1px solid #38383b; border-radius: 4px; padding: 5px 8px; }
#command_palette QLineEdit:focus, #keys_dialog QLineEdit:focus { border-color: #688aac; }
#command_palette QListView { border: none; background: transparent; }
#keys_dialog QTreeView::item:hover { background: #2f2f32; }
#keys_dialog QTreeView::item:selected { background: #45607c; color: #ffffff; }
#keys_dialog QToolButton { background: transparent; border: none; padding: 4px 5px; color: #a9a9ae; }
#keys_dialog QToolButton:hover { color: #ffffff; }
#keys_dialog QLabel#sentence { color: #e0c48a; }
QComboBox { padding: 4px 8px; }
QAbstractSpinBox { padding: 3px 4px; }
QDialogButtonBox, QMessageBox { dialogbuttonbox-buttons-have-icons: 0; }
QPushButton { background: #3a3a3d; border: 1px solid #48484c; border-radius: 4px; padding: 5px 14px; }
QPushButton:hover { background: #46464a; }
QPushButton:default { background: #45607c; border-color: #688aac; color: #ffffff; }
QPushButton:disabled { color: #6c6c70; background: #313133; border-color: #3a3a3d; }
QToolButton { background: #3a3a3d; border: 1px solid #48484c; border-radius: 4px; padding: 5px 9px; }
QToolButton:hover { background: #46464a; }
QToolButton:pressed, QToolButton:checked { background: #45607c; border-color: #688aac; color: #ffffff; }
QToolButton:disabled { color: #6c6c70; background: #313133; border-color: #3a3a3d; }
QScrollBar:vertical { background: transparent; width: 9px; margin: 0px; }
QScrollBar::handle:vertical { background: #55555a; border-radius: 4px; min-height: 24px; }
QScrollBar::add-line, QScrollBar::sub-line { height: 0px; }
QSlider::groove:horizontal { height: 4px; background: #1f1f21; border-radius: 2px; }
QSlider::sub-page:horizontal { background: #688aac; border-radius: 2px; }
QSlider::handle:horizontal { width: 14px; margin: -5px 0px; border-radius: 7px; background: #dadadc; }
QSlider::sub-page:horizontal:disabled { background: #38383b; }
QSlider::handle:horizontal:disabled { background: #5c5c60; }
)";

QPalette dark_palette() {
    QPalette palette(kButton, kWindow);
    palette.setColor(QPalette::WindowText, kText);
    palette.setColor(QPalette::Text, kText);
    palette.setColor(QPalette::ButtonText, kText);
    palette.setColor(QPalette::Base, kField);
    palette.setColor(QPalette::AlternateBase, kWindow);
    palette.setColor(QPalette::Highlight, kAccent);
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::PlaceholderText, kFaintText);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, kFaintText);
    }
    return palette;
}

}  // namespace

void apply_theme(QApplication& application) {
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(dark_palette());
    application.setStyleSheet(QString::fromUtf8(kStyleSheet));
}

}  // namespace pastoso::panels
