// What the brush holds, and how it is dipped.
#pragma once

#include "brush/load_profile.hpp"
#include "tools/hand.hpp"
#include "tools/swatch.hpp"

#include <vector>

#include <QWidget>

class QAction;
class QComboBox;
class QLabel;

namespace pastoso::panels {

class LoadBar;
class PaintSwatch;
class ValueRow;

class LoadPanel : public QWidget {
    Q_OBJECT
  public:
    /// `actions` become buttons, as many as have room in a row; `swap` stands between the two paints.
    LoadPanel(const std::vector<QAction*>& actions, QAction* swap, QWidget* parent = nullptr);

    /// Shows the brush's paints and how it is dipped, without a signal.
    void show_hand(const tools::Hand& hand);

    /// Shows all paint as it looks there from now on.
    void show_swatches(const tools::SwatchView& view);

    /// Shows what the brush holds now.
    void show_load(const brush::LoadProfile& load);

  Q_SIGNALS:
    void dip_chosen(const tools::Dip& dip);

  private:
    QWidget* paints_row(QAction* swap);
    void emit_dip();
    void show_way(tools::Dip::Way way);
    void show_paints();

    document::PaintRecipe paint_, second_paint_;
    tools::SwatchView view_;
    LoadBar* bar_ = nullptr;
    QLabel* fullness_ = nullptr;
    QComboBox* way_ = nullptr;
    PaintSwatch* first_ = nullptr;
    PaintSwatch* second_ = nullptr;
    ValueRow* fill_ = nullptr;
    ValueRow* share_ = nullptr;
};

}  // namespace pastoso::panels
