#include "tea/panel_parts.hpp"

#include "panels/section.hpp"

#include <QAction>
#include <QCoreApplication>
#include <QGridLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace pastoso::tea {
namespace {

constexpr const char* kBack = QT_TR_NOOP("Back to the painting");
constexpr const char* kBackHint = QT_TR_NOOP("The glass waits as it is, and so did the painting");

}  // namespace

QToolButton* back_button(QAction* back) {
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("back_to_painting"));
    button->setText(QCoreApplication::translate("pastoso::tea", kBack));
    button->setIcon(back->icon());
    button->setToolTip(QCoreApplication::translate("pastoso::tea", kBackHint));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    panels::keep_keys_for_canvas(button);
    QObject::connect(button, &QToolButton::clicked, back, &QAction::trigger);
    return button;
}

QGridLayout* rows_under(QVBoxLayout* column) {
    auto* widget = new QWidget;
    auto* grid = new QGridLayout(widget);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    column->addWidget(widget);
    return grid;
}

}  // namespace pastoso::tea
