// The jar of brushes, and how wide the one in hand is.
#pragma once

#include "panels/pen/brush_finder.hpp"
#include "panels/pen/brush_list.hpp"
#include "tools/steadying.hpp"

#include <map>
#include <set>
#include <vector>

#include <QImage>
#include <QString>
#include <QStringList>
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
    /// `own_actions` become buttons: edit, favourite, save, rename, delete.
    explicit BrushPanel(const std::vector<QAction*>& own_actions, QWidget* parent = nullptr);

    /// Lists these in place of what was there; their thumbnails are asked for anew.
    void show_brushes(std::vector<BrushEntry> brushes);

    /// Marks the favourites and puts the tools in the painter's order. Which were used last counts when
    /// they are listed the next time, so that none moves away under the pointer.
    void show_shelf(const tools::BrushShelf& shelf);

    void show_thumbnail(const QString& name, const QImage& image);

    /// Shows what is in hand, without a signal.
    void show_brush(const QString& name, double width_mm);

    /// Shows how the hand is steadied, without a signal.
    void show_stabiliser(const brush::Stabiliser& stabiliser);
    void show_steadying(const tools::Steadying& steadying);
    const tools::Steadying& steadying() const { return steadying_; }

    BrushList& list() { return *list_; }
    /// All, whichever are listed.
    const std::vector<BrushEntry>& brushes() const { return brushes_; }

    /// As a click on it does.
    void take(const BrushEntry& brush) { Q_EMIT brush_taken(brush.name, brush.width_mm); }

    /// As "New tag..." in the list's menu does for the tool in hand.
    void want_tag() { Q_EMIT new_tag_wanted(in_hand_); }

    /// Takes the brush so many places on in the list, around its ends.
    void take_next(int places);

  Q_SIGNALS:
    void brush_taken(const QString& name, double width_mm);
    void thumbnail_wanted(const QString& name);
    void faulty_clicked(const QString& fault);  ///< a file that cannot be taken
    /// Of the tool in hand.
    void rename_wanted();
    void removal_wanted();
    void width_chosen(double width_mm);
    /// These tools, which are all that are shown of `choice`, stand in another order.
    void arranged(const BrushChoice& choice, const QStringList& tools);
    void tagged(const QString& name, const QString& tag, bool tagged);
    void new_tag_wanted(const QString& name);
    void stabiliser_chosen(const brush::Stabiliser& stabiliser);

  private:
    void list_chosen();
    void mark_in_hand();
    void want_thumbnail(int entry);
    void tell_arranged();
    void offer_tags(const QPoint& place);
    QWidget* make_width_row();
    QWidget* make_stabiliser_rows();
    void take_strength(int place);
    void write_steadying();

    std::vector<BrushEntry> brushes_, listed_;
    tools::BrushShelf shelf_;
    QString in_hand_;
    std::set<QString> asked_;               ///< tools whose thumbnails were asked for
    std::map<QString, QImage> thumbnails_;  ///< those that came
    BrushFinder* finder_ = nullptr;
    BrushList* list_ = nullptr;
    QSlider* slider_ = nullptr;
    QDoubleSpinBox* width_ = nullptr;
    tools::Steadying steadying_;
    QComboBox* steady_mode_ = nullptr;
    QSlider* strength_ = nullptr;
    QLabel* strength_reading_ = nullptr;
};

}  // namespace pastoso::panels
