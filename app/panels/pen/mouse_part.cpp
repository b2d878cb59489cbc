#include "panels/pen/mouse_part.hpp"

#include "panels/parts/labels.hpp"
#include "panels/parts/value_row.hpp"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace pastoso::panels {

MousePart::MousePart(const tools::MouseSettings& mouse, QWidget* parent)
    : QWidget(parent), mouse_(mouse) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    auto* rows = new QWidget;
    auto* grid = new QGridLayout(rows);
    grid->setContentsMargins(0, 0, 0, 0);
    auto* pressure = new ValueRow(grid, QStringLiteral("mouse_pressure"), tr("Pressure"),
                                  tr("How hard the brush is pressed"),
                                  {100.0 * tools::kLeastMousePressure, 100.0, 0, tr(" %")});
    pressure->show_value(100.0 * mouse_.pressure);
    connect(pressure, &ValueRow::chosen, this, [this](double value) {
        mouse_.pressure = 0.01 * value;
        Q_EMIT changed(mouse_);
    });
    auto* by_speed = new QCheckBox(tr("Lighter the faster it goes"));
    by_speed->setObjectName(QStringLiteral("mouse_by_speed"));
    by_speed->setToolTip(tr("A slow line is pressed as set above, a fast one down to a quarter of it"));
    by_speed->setChecked(mouse_.by_speed);
    connect(by_speed, &QCheckBox::toggled, this, [this](bool on) {
        mouse_.by_speed = on;
        Q_EMIT changed(mouse_);
    });
    column->addWidget(
        note(tr("A mouse, or a finger on the screen, does not tell how hard it presses.")));
    column->addWidget(rows);
    column->addWidget(by_speed);
    column->addStretch(1);
}

}  // namespace pastoso::panels
