#include "panels/canvas/navigator_panel.hpp"

#include "panels/canvas/navigator_map.hpp"
#include "panels/parts/section.hpp"
#include "panels/parts/value_row.hpp"

#include <QGridLayout>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr double kPercent = 100.0;

}  // namespace

NavigatorPanel::NavigatorPanel(const std::vector<QAction*>& nearness,
                               const std::vector<QAction*>& standing, double least_zoom,
                               double most_zoom, QWidget* parent)
    : QWidget(parent), map_(new NavigatorMap) {
    map_->setObjectName(QStringLiteral("navigator_map"));
    map_->setAccessibleName(tr("The whole canvas"));
    map_->setToolTip(tr("Drag the frame, or click, to go there\nWheel: closer, farther"));
    auto* column = new QVBoxLayout(this);
    column->setSpacing(6);
    column->addWidget(map_, 1);
    auto* values = new QWidget;
    auto* grid = new QGridLayout(values);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    zoom_ = new ValueRow(grid, QStringLiteral("navigator_zoom"), tr("Zoom"),
                         tr("Screen pixels for a pixel of the saved picture"),
                         {kPercent * least_zoom, kPercent * most_zoom, 1, tr(" %"), true});
    angle_ =
        new ValueRow(grid, QStringLiteral("navigator_angle"), tr("Turned"),
                     tr("How far the canvas is turned, clockwise"), {-180.0, 180.0, 1, tr("\u00b0")});
    column->addWidget(values);
    column->addWidget(button_row(nearness));
    column->addWidget(button_row(standing));
    connect(zoom_, &ValueRow::chosen, this,
            [this](double percent) { Q_EMIT zoom_chosen(percent / kPercent); });
    connect(angle_, &ValueRow::chosen, this, &NavigatorPanel::angle_chosen);
}

void NavigatorPanel::show_view(double zoom, double angle_deg) {
    zoom_->show_value(kPercent * zoom);
    angle_->show_value(angle_deg);
}

}  // namespace pastoso::panels
