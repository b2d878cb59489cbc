#include "panels/layers/layer_panel.hpp"

#include "panels/layers/layer_tree.hpp"
#include "panels/parts/section.hpp"
#include "panels/parts/value_row.hpp"

#include <utility>

#include <QAction>
#include <QGridLayout>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

using tools::LayerRow;

constexpr int kFollowing_ms = 400;

/// Every rest of the slider is a step that Undo returns to.
constexpr int kFading_ms = 250;

bool has_row(const document::LayerStack& stack, const LayerRow& row) {
    return !tools::layers_in(stack, {row}).empty();
}

LayerRow active_row(const document::LayerStack& stack) {
    return {.layer = stack.layers[stack.active].id};
}

}  // namespace

LayerPanel::LayerPanel(const std::vector<QAction*>& buttons, const std::vector<QAction*>& menu,
                       QWidget* parent)
    : QWidget(parent), tree_(new LayerTree), stack_(document::single_layer()) {
    setFocusProxy(tree_);
    tree_->setObjectName(QStringLiteral("layer_list"));
    tree_->setAccessibleName(tr("Layers"));
    tree_->setContextMenuPolicy(Qt::ActionsContextMenu);
    for (QAction* action : menu) {
        auto* separator = new QAction(tree_);
        separator->setSeparator(true);
        tree_->addAction(action != nullptr ? action : separator);
    }
    auto* column = new QVBoxLayout(this);
    column->setSpacing(6);
    auto* values = new QWidget;
    make_opacity_row(values);
    column->addWidget(values);
    column->addWidget(tree_, 1);
    column->addWidget(icon_row(buttons));
    for (QTimer* timer : {&following_, &fading_})
        timer->setSingleShot(true);
    following_.setInterval(kFollowing_ms);
    fading_.setInterval(kFading_ms);
    connect(&following_, &QTimer::timeout, this, &LayerPanel::take_latest);
    connect(&fading_, &QTimer::timeout, this, &LayerPanel::post_opacity);
    connect_tree();
    chosen_ = active_row(stack_);
    refresh();
}

void LayerPanel::make_opacity_row(QWidget* parent) {
    auto* grid = new QGridLayout(parent);
    grid->setContentsMargins(0, 0, 0, 0);
    opacity_ = new ValueRow(grid, QStringLiteral("layer_opacity"), tr("Opacity"),
                            tr("Fades what its paint does to light; its relief stays"),
                            {0.0, 100.0, 0, tr(" %")});
    connect(opacity_, &ValueRow::chosen, this, [this] {
        faded_ = chosen_;
        fading_.start();
    });
}

void LayerPanel::connect_tree() {
    connect(tree_, &LayerTree::chosen, this, &LayerPanel::choose);
    connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &LayerPanel::choice_changed);
    connect(tree_, &LayerTree::eye_clicked, this, [this](const LayerRow& row) {
        document::LayerLook look = tools::look_of(stack_, row);
        look.visible = !look.visible;
        set_look(row, look);
    });
    connect(tree_, &LayerTree::bare_clicked, this, [this](const LayerRow& row) {
        document::LayerLook look = tools::look_of(stack_, row);
        look.bare_locked = !look.bare_locked;
        set_look(row, look);
    });
    connect(tree_, &LayerTree::lock_clicked, this, [this](const LayerRow& row) {
        document::LayerLook look = tools::look_of(stack_, row);
        look.locked = !look.locked;
        set_look(row, look);
    });
    connect(&tree_->layers(), &LayerModel::renamed, this,
            [this](const LayerRow& row, const QString& name) {
                document::LayerLook look = tools::look_of(stack_, row);
                look.name = name.toStdString();
                set_look(row, look);
            });
    connect(&tree_->layers(), &LayerModel::dropped, this,
            [this](const LayerRow& row, const tools::LayerGap& gap) {
                if (const auto move = tools::move_to(stack_, row, gap)) Q_EMIT wanted(*move);
            });
}

void LayerPanel::show_layers(std::shared_ptr<const document::LayerStack> stack) {
    if (stack == nullptr || stack == latest_) return;
    latest_ = std::move(stack);
    const bool same_rows = tools::layer_entries(*latest_) == tools::layer_entries(stack_);
    if (!same_rows || !following_.isActive()) take_latest();
}

void LayerPanel::take_latest() {
    following_.stop();
    if (latest_ != nullptr) take(*latest_);
}

/// Another layer that is painted on is chosen too.
void LayerPanel::take(const document::LayerStack& stack) {
    const LayerRow before = active_row(stack_);
    stack_ = stack;
    if (active_row(stack_) != before || !has_row(stack_, chosen_)) {
        post_opacity();
        chosen_ = active_row(stack_);
    }
    refresh();
}

void LayerPanel::refresh() {
    tree_->show(stack_, chosen_);
    show_opacity();
    Q_EMIT choice_changed();
}

void LayerPanel::show_opacity() {
    if (!faded_) opacity_->show_value(100.0 * tools::look_of(stack_, chosen_).opacity);
}

void LayerPanel::choose(const LayerRow& row) {
    if (!has_row(stack_, row)) return;
    post_opacity();
    chosen_ = row;
    if (row.layer != 0 && row != active_row(stack_)) {
        stack_.active = document::place_of(stack_, row.layer);
        following_.start();
        Q_EMIT wanted(document::SelectLayer{row.layer});
    }
    refresh();
}

void LayerPanel::set_look(const LayerRow& row, const document::LayerLook& look) {
    if (row != chosen_) post_opacity();
    if (look == tools::look_of(stack_, row)) return;
    if (row.group != 0)
        document::group_of(stack_, row.group).look = look;
    else
        stack_.layers[document::place_of(stack_, row.layer)].look = look;
    following_.start();
    Q_EMIT wanted(tools::set_look(row, look));
    refresh();
}

void LayerPanel::post_opacity() {
    fading_.stop();
    const auto row = std::exchange(faded_, std::nullopt);
    if (!row || !has_row(stack_, *row)) return;
    document::LayerLook look = tools::look_of(stack_, *row);
    look.opacity = opacity_->value() / 100.0;
    set_look(*row, look);
}

std::vector<LayerRow> LayerPanel::selected() const {
    return tree_->selected();
}

void LayerPanel::edit_name() {
    tree_->edit_name(chosen_);
}

void LayerPanel::set_carried(std::function<QMimeData*(const LayerRow& row)> carried) {
    tree_->set_carried(std::move(carried));
}

void LayerPanel::set_picture(document::LayerId layer, const QImage& picture, bool wet) {
    tree_->layers().set_picture(layer, picture, wet);
}

void LayerPanel::forget_pictures() {
    tree_->layers().forget_pictures();
}

}  // namespace pastoso::panels
