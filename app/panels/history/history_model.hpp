// What was done to the painting, as a list for Qt's views.
#pragma once

#include "session/paint_session.hpp"

#include <QAbstractListModel>

namespace pastoso::panels {

/// Row 0 is how the painting was before all that is kept, row i how it was after the i-th step. Rows
/// after the present one were undone.
class HistoryModel : public QAbstractListModel {
    Q_OBJECT
  public:
    static constexpr int kUndoneRole = Qt::UserRole, kDetailRole = Qt::UserRole + 1;

    using QAbstractListModel::QAbstractListModel;

    void show(const session::Steps& steps);

    int present_row() const { return present_row_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

  private:
    std::vector<document::UndoStep> steps_;
    int present_row_ = 0;
};

}  // namespace pastoso::panels
