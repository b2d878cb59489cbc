// The tools by family, each with its thumbnail.
#pragma once

#include "panels/parts/choice_list.hpp"

#include <vector>

#include <QString>
#include <QStringList>

namespace pastoso::panels {

struct BrushEntry {
    QString name;            ///< as it is kept in its file
    QString family;          ///< its heading; entries of one family follow each other
    double width_mm = 10.0;  ///< the tool's own
    bool own = false;        ///< the painter's
    QString fault{};         ///< why it cannot be taken; empty where it can
    bool favourite = false;  ///< has a star
    friend bool operator==(const BrushEntry&, const BrushEntry&) = default;
};

/// As the list names it.
QString shown_name(const BrushEntry& entry);

/// Size of the thumbnails, in pixels of the layout.
inline constexpr QSize kThumbnailSize(67, 24);

class BrushList : public ChoiceList {
    Q_OBJECT
  public:
    explicit BrushList(QWidget* parent = nullptr);

    /// Lists these in place of what was there; their thumbnails are asked for anew.
    void show_entries(const std::vector<BrushEntry>& entries);

    /// Says these words in place of entries.
    void show_none(const QString& words);

    /// Marks the entry of that number, without a signal, and brings it into view; none where there is no
    /// such entry.
    void show_entry(int entry);
    /// The entry that is marked, -1 if none.
    int current_entry() const;
    /// The name of the tool at that place of the viewport, or else of the one that is marked; empty:
    /// none.
    QString name_at(const QPoint& place) const;
    /// As the entries stand, by their names; those that cannot be taken are left out.
    QStringList names() const;
    void set_thumbnail(const QString& name, const QImage& image);

  Q_SIGNALS:
    /// Or chosen by key.
    void entry_clicked(int entry);
    /// The entry has come into view and has no thumbnail yet; once for each.
    void thumbnail_wanted(int entry);
    /// The tool that is marked is to be given another name.
    void rename_wanted();

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void add_heading(const QString& words);
    void add_entry(const BrushEntry& entry);
    void draw_thumbnail(QListWidgetItem& item);
    void scroll_to_current();
    void ask_for_thumbnails();

    std::vector<QListWidgetItem*> items_;  ///< by entry
    std::vector<bool> asked_;
};

}  // namespace pastoso::panels
