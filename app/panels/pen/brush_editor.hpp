// Every number of the tool in hand, its curves, and the stroke that it paints.
#pragma once

#include "brush/preset.hpp"
#include "core/fault.hpp"

#include <vector>

#include <QDialog>

class QAction;
class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace pastoso::panels {

class CurvesPanel;
class PresetPageView;
class StrokeStrip;

class BrushEditor : public QDialog {
    Q_OBJECT
  public:
    /// `own_actions` become buttons: save, rename, delete. `tell` hears, on any thread, why a stroke
    /// cannot be painted.
    BrushEditor(const std::vector<QAction*>& own_actions, const core::Tell& tell, QWidget* parent);

    /// Shows the tool in hand, as wide as it is held, without a signal; `kept` is what Revert returns
    /// to.
    void show_tool(const brush::Preset& in_hand, const brush::Preset& kept);

    /// Which of its pages the painter has opened, from 0 on.
    int open_page() const;
    void open_page(int page);

  Q_SIGNALS:
    /// What the tool in hand is like from now on, its width among the rest.
    void edited(const brush::Preset& preset);
    /// How wide the same tool is held from now on: its other measures go with that, as with the size.
    void width_chosen(double width_mm);
    /// It has come, or gone.
    void shown(bool visible);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    QWidget* make_strips(const core::Tell& tell);
    QWidget* make_actions(const std::vector<QAction*>& own_actions);
    QWidget* make_pages();
    void add_page(const QString& words, QWidget* page);
    void edit(const brush::Preset& preset);
    void show_all();
    void show_page();
    void show_strips();

    brush::Preset tool_, kept_;
    QLabel* name_ = nullptr;
    StrokeStrip* strip_ = nullptr;
    StrokeStrip* kept_strip_ = nullptr;
    QToolButton* compare_ = nullptr;
    QPushButton* revert_ = nullptr;
    QListWidget* contents_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    std::vector<PresetPageView*> numbers_;  ///< the first of the pages
    int open_page_ = 0;
    CurvesPanel* curves_ = nullptr;
};

}  // namespace pastoso::panels
