#include "panels/paint/well_panel.hpp"

#include "panels/parts/section.hpp"

#include <QAction>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

QHBoxLayout* left_row(const std::vector<QAction*>& actions) {
    auto* row = new QHBoxLayout;
    for (QAction* action : actions) {
        QToolButton* button = action_button(action);
        button->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
        row->addWidget(button);
    }
    row->addStretch();
    return row;
}

}  // namespace

QDockWidget* well_panel(QWidget* well, const std::vector<QAction*>& actions) {
    auto* dock = new QDockWidget(QObject::tr("Mixing well"));
    dock->setObjectName(QStringLiteral("well_panel"));
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(6, 6, 6, 6);
    column->addWidget(well);
    column->addLayout(left_row(actions));
    column->addStretch(1);
    dock->setWidget(content);
    return dock;
}

}  // namespace pastoso::panels
