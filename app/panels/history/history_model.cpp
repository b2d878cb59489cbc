#include "panels/history/history_model.hpp"

#include "panels/history/step_words.hpp"

#include <algorithm>

#include <QColor>

namespace pastoso::panels {

void HistoryModel::show(const session::Steps& steps) {
    std::vector<document::UndoStep> next;
    for (const document::KeptStep& kept : steps.past)
        next.push_back(kept.step);
    for (auto kept = steps.future.rbegin(); kept != steps.future.rend(); ++kept)
        next.push_back(kept->step);
    const auto present = static_cast<int>(steps.past.size());
    if (next == steps_ && present == present_row_) return;
    beginResetModel();
    steps_ = std::move(next);
    present_row_ = present;
    endResetModel();
}

int HistoryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : 1 + static_cast<int>(steps_.size());
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const document::UndoStep* step =
        index.row() == 0 ? nullptr : &steps_[static_cast<std::size_t>(index.row()) - 1];
    const bool undone = index.row() > present_row_;
    switch (role) {
        case Qt::DisplayRole:
            return step == nullptr ? tr("As far back as is kept") : step_words(*step);
        case kDetailRole:
            return step == nullptr ? QString() : step_detail(*step);
        case kUndoneRole:
            return undone;
        case Qt::ToolTipRole:
            return undone ? tr("Click: do again up to here") : tr("Click: go back to this moment");
        default:
            return {};
    }
}

}  // namespace pastoso::panels
