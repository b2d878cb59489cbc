// The page that lies over the canvas when the program starts: what there is to paint on.
#pragma once

#include "document/events.hpp"
#include "journal/recovery.hpp"
#include "start/example_paintings.hpp"

#include <filesystem>
#include <vector>

#include <QFrame>

class QCheckBox;
class QLabel;
class QPushButton;
class QScrollArea;

namespace pastoso::start {

class ExamplesSection;
class NewCanvasSection;
class RecentSection;
class UnfinishedSection;

/// Only tells what the painter chooses. It is as large as it needs to be and no larger than the place it
/// lies on.
class StartPage : public QFrame {
    Q_OBJECT
  public:
    /// Hidden, over `parent`.
    explicit StartPage(QWidget* parent);

    /// Shows itself over `place` of its parent and takes the keys. `begun`: there is a painting to go
    /// back to. New canvases have at most `live_px_per_mm` cells a millimetre.
    void open(const QRect& place, const document::CanvasSettings& on_easel, bool begun,
              double live_px_per_mm, const std::vector<std::filesystem::path>& recent,
              const std::vector<journal::Unfinished>& unfinished);

    /// The place that it lies on has changed.
    void lie_on(const QRect& place);

    void show_recent(const std::vector<std::filesystem::path>& recent);
    void show_unfinished(const std::vector<journal::Unfinished>& unfinished);

    void set_shown_at_start(bool shown);
    bool shown_at_start() const;

    NewCanvasSection* new_canvas() { return new_canvas_; }
    RecentSection* recent() { return recent_; }
    ExamplesSection* examples() { return examples_; }
    UnfinishedSection* unfinished() { return unfinished_; }

  Q_SIGNALS:
    void dismissed();

  protected:
    void showEvent(QShowEvent* event) override;
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override;

  private:
    QWidget* make_content();
    QLayout* make_greeting();
    QLayout* make_foot();
    void fit();

    UnfinishedSection* unfinished_;
    NewCanvasSection* new_canvas_;
    RecentSection* recent_;
    ExamplesSection* examples_;
    QPushButton* paint_;
    QLabel* easel_words_;
    QCheckBox* at_start_;
    QScrollArea* scrolled_;
    QRect place_;
};

}  // namespace pastoso::start
