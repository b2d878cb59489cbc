// The part of the start page that puts up a fresh canvas with one click.
#pragma once

#include "dialogs/support_choices.hpp"
#include "panels/parts/gallery.hpp"
#include "start/canvas_choices.hpp"

#include <vector>

#include <QImage>
#include <QWidget>

class QGridLayout;
class QToolButton;

namespace pastoso::start {

class NewCanvasSection : public QWidget {
    Q_OBJECT
  public:
    explicit NewCanvasSection(QWidget* parent = nullptr);

    /// The same support and orientation as a canvas has, on cells that keep pace with the hand.
    void propose(const document::CanvasSettings& canvas, double live_px_per_mm);

    void fit(int width);

    panels::Gallery* sizes() { return sizes_; }

  Q_SIGNALS:
    void wanted(const pastoso::document::CanvasSettings& canvas);
    void more_wanted();  ///< other sizes, and supports of the painter's own

  private:
    void add_supports();
    void lay_supports(int columns);
    void add_orientations(QLayout* row);
    QToolButton* make_choice(const QString& words, const QString& hint);
    void show_sizes();
    panels::Tile tile_of(const document::CanvasSettings& canvas, const QString& name) const;
    void choose(int number);
    document::CanvasSettings canvas(int number) const;
    bool upright() const;
    std::size_t support() const;

    const std::vector<CanvasSize> canvas_sizes_ = start::canvas_sizes();
    const std::vector<dialogs::Support> supports_ = dialogs::supports();
    std::vector<QImage> support_pictures_;
    std::vector<QToolButton*> support_buttons_;
    QGridLayout* support_grid_ = nullptr;
    Machine machine_;
    QToolButton* lying_ = nullptr;
    QToolButton* upright_ = nullptr;
    panels::Gallery* sizes_;
};

}  // namespace pastoso::start
