// The jar of brushes, and how wide the one in hand is.
#pragma once

#include "panels/pen/brush_list.hpp"
#include "tools/steadying.hpp"

#include <vector>

#include <QString>
#include <QWidget>

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace pastoso::panels {

class BrushPanel : public QWidget {
    Q_OBJECT
  public:
    /// `own_actions` become buttons: save, rename, delete.
    explicit BrushPanel(const std::vector<QAction*>& own_actions, QWidget* parent = nullptr);

    /// Lists these in place of what was there.
    void show_brushes(std::vector<BrushEntry> brushes);

    /// Shows what is in hand, without a signal.
    void show_brush(const QString& name, double width_mm);

    /// Shows how the hand is steadied, without a signal.
    void show_stabiliser(const brush::Stabiliser& stabiliser);
    void show_steadying(const tools::Steadying& steadying);
    const tools::Steadying& steadying() const { return steadying_; }

    BrushList& list() { return *list_; }
    const std::vector<BrushEntry>& brushes() const { return brushes_; }

    /// As a click on it does.
    void take(const BrushEntry& brush) { Q_EMIT brush_taken(brush.name, brush.width_mm); }

    /// Takes the brush so many places on in the list, around its ends.
    void take_next(int places);

  Q_SIGNALS:
    void brush_taken(const QString& name, double width_mm);
    void thumbnail_wanted(const QString& name);
    void faulty_clicked(const QString& fault);  ///< a file that cannot be taken
    void width_chosen(double width_mm);
    void stabiliser_chosen(const brush::Stabiliser& stabiliser);

  private:
    QWidget* make_width_row();
    QWidget* make_stabiliser_rows();
    void take_strength(int place);
    void write_steadying();

    std::vector<BrushEntry> brushes_;
    BrushList* list_ = nullptr;
    QSlider* slider_ = nullptr;
    QDoubleSpinBox* width_ = nullptr;
    tools::Steadying steadying_;
    QComboBox* steady_mode_ = nullptr;
    QSlider* strength_ = nullptr;
    QLabel* strength_reading_ = nullptr;
};

}  // namespace pastoso::panels
