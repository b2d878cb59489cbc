// Tiles with pictures in rows, to be chosen with a click, or with the arrow keys and Enter.
#pragma once

#include <QListView>
#include <QPixmap>

class QStandardItemModel;

namespace pastoso::panels {

struct Tile {
    QString name;
    QString detail{};  ///< small words below it
    QString hint{};
    QPixmap picture{};
    bool faint = false;      ///< it cannot be had now
    bool removable = false;  ///< by its cross, or the Delete key
};

class Gallery : public QListView {
    Q_OBJECT
  public:
    /// `picture` is the room for one, `detail_lines` how many lines of small words stand below.
    explicit Gallery(const QSize& picture, int detail_lines = 1, QWidget* parent = nullptr);

    void show_tiles(const std::vector<Tile>& tiles);
    void show_tile(int number, const Tile& tile);
    int count() const;

    /// As tall as all tiles need in that width.
    void fit(int width);

    /// The middle of a tile, where it is clicked.
    QPoint middle(int number) const;

  Q_SIGNALS:
    void chosen(int number);
    void removal_wanted(int number);

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;

  private:
    bool take_key(int key);

    QStandardItemModel* model_;
};

}  // namespace pastoso::panels
