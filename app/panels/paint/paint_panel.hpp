// The tubes of paint: all of them or a set, in the painter's order.
#pragma once

#include "tools/drawdown.hpp"

#include <vector>

#include <QColor>
#include <QIcon>
#include <QString>
#include <QStringList>
#include <QWidget>

class QLabel;
class QListWidgetItem;
class QPoint;

namespace pastoso::panels {

class ChoiceList;
class TubeMenu;

struct PaintEntry {
    QString pigment;  ///< Colour Index name, empty for the medium alone
    QString name;
};

class PaintPanel : public QWidget {
    Q_OBJECT
  public:
    explicit PaintPanel(const std::vector<PaintEntry>& paints, QWidget* parent = nullptr);

    /// Shows all paint as it looks there from now on.
    void show_swatches(const tools::SwatchView& view);

    /// Shows these tubes alone, by their Colour Index names, in this order.
    void show_tubes(const QStringList& tubes);
    QStringList tubes() const;

    /// The painter's sets of tubes.
    TubeMenu& sets() { return *sets_; }

    /// Shows what the brush is dipped in, without a signal; nothing when it is from no tube.
    void show_paint(const QString& pigment);

    const std::vector<PaintEntry>& paints() const { return paints_; }

    /// As a click on it does.
    void choose(const QString& pigment) { Q_EMIT paint_chosen(pigment); }

  Q_SIGNALS:
    /// Also when the same paint is chosen again, which means a fresh dip.
    void paint_chosen(const QString& pigment);

    void arranged();  ///< tubes() stand in another order
    void put_into_set(const QString& pigment, const QString& set);
    void taken_out(const QString& pigment);  ///< of the set that is shown

  protected:
    void changeEvent(QEvent* event) override;

  private:
    /// The colours of a tube's icon.
    struct Colours {
        QColor ink, chosen_ink;  ///< of the mark
        pigment::Srgb8 paint{}, tint{};
        tools::Drawdown drawdown;
        friend bool operator==(const Colours&, const Colours&) = default;
    };
    static QString words_of(const PaintEntry& paint, const Colours& colours, double film_mm);
    void draw_icons();
    void draw(QListWidgetItem& item) const;
    static QIcon icon_of(const Colours& colours, double pixel_ratio);
    void make_grid();
    QWidget* make_head();
    void give_name_room();
    void offer_sets(const QPoint& place);

    std::vector<PaintEntry> paints_;
    tools::SwatchView view_;
    ChoiceList* list_ = nullptr;
    TubeMenu* sets_ = nullptr;
    QLabel* name_ = nullptr;  ///< of the tube in hand
    QString in_hand_;
    std::vector<Colours> shown_;  ///< of each paint
};

}  // namespace pastoso::panels
