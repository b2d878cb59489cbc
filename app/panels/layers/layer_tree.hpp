// The list of layers as a view: eyes, locks, names that are edited in place, rows that are dragged.
#pragma once

#include "panels/layers/layer_model.hpp"

#include <functional>
#include <memory>
#include <set>
#include <utility>

#include <QMimeData>
#include <QPointer>
#include <QTreeView>

namespace pastoso::panels {

class LayerTree : public QTreeView {
    Q_OBJECT
  public:
    explicit LayerTree(QWidget* parent = nullptr);

    LayerModel& layers() { return model_; }
    const LayerModel& layers() const { return model_; }

    tools::LayerRow current() const { return model_.row_at(currentIndex()); }
    std::vector<tools::LayerRow> selected() const;

    /// Shows the layers with that row chosen, without a signal of that.
    void show(const document::LayerStack& stack, const tools::LayerRow& chosen);
    void edit_name(const tools::LayerRow& row);

    /// What a row that is dragged carries besides its place in the list, for other windows and programs;
    /// null: nothing. The drag's.
    using Carried = std::function<QMimeData*(const tools::LayerRow& row)>;
    void set_carried(Carried carried) { carried_ = std::move(carried); }
    /// All that a drag of the row carries.
    std::unique_ptr<QMimeData> dragged(const QModelIndex& index) const;

    /// One row is seen where there is no room for more.
    QSize minimumSizeHint() const override;
    /// As high as its rows, two of them at least.
    QSize sizeHint() const override;

  Q_SIGNALS:
    void chosen(const tools::LayerRow& row);
    void eye_clicked(const tools::LayerRow& row);
    void bare_clicked(const tools::LayerRow& row);
    void lock_clicked(const tools::LayerRow& row);

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void drawBranches(QPainter* painter, const QRect& place, const QModelIndex& index) const override;
    void startDrag(Qt::DropActions actions) override;
    void dropEvent(QDropEvent* event) override;
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;
    void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

  private:
    bool click_icon(const QMouseEvent& event);
    void unfold();
    int shown_rows() const;
    QPixmap dragged_picture(const QModelIndex& index);

    LayerModel model_;
    Carried carried_;
    std::set<document::GroupId> folded_;
    bool showing_ = false;  ///< the choice is not the painter's
    bool icon_pressed_ = false;
    QPointer<QWidget> focus_before_;  ///< a name was edited
};

}  // namespace pastoso::panels
