#include "panels/paint/well_panel.hpp"

#include "panels/parts/section.hpp"

#include <QAction>
#include <QDockWidget>
#include <QVBoxLayout>

namespace pastoso::panels {
QDockWidget* well_panel(QWidget* well, const std::vector<QAction*>& of_brush,
                        const std::vector<QAction*>& of_well) {
    auto* dock = new QDockWidget(QObject::tr("Mixing well"));
    dock->setObjectName(QStringLiteral("well_panel"));
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    column->addWidget(well, 1);
    column->addWidget(button_row(of_brush));
    column->addWidget(button_row(of_well));
    dock->setWidget(content);
    return dock;
}

}  // namespace pastoso::panels
