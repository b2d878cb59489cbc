// The pop-up palette: which tools and paints lie in it, and what choosing there does.
#pragma once

#include "main/program/remembered_file.hpp"
#include "main/studio.hpp"
#include "session/thumbnail_painter.hpp"
#include "tools/tool_slots.hpp"

#include <memory>
#include <set>
#include <string>
#include <vector>

#include <QObject>

namespace pastoso::panels {
class ColourPanel;
class PopupPalette;
}  // namespace pastoso::panels

namespace pastoso::main {

class BrushJar;
class Swatches;

class PopupCommands : public QObject {
    Q_OBJECT
  public:
    PopupCommands(Studio& studio, BrushJar& brushes, const Swatches& swatches,
                  const panels::ColourPanel* colours);

    /// The tools that were used. A file that cannot be read is told, and left as it is.
    void recall();
    void remember();

  private:
    void make_palette();
    void open(const QPoint& place);
    void open_at_pointer();
    void show_content();
    void want_thumbnails();

    Studio& studio_;
    BrushJar& brushes_;
    const Swatches& swatches_;
    const panels::ColourPanel* colours_;
    panels::PopupPalette* palette_ = nullptr;
    std::unique_ptr<session::ThumbnailPainter> thumbnails_;
    tools::ToolSlots slots_ = tools::first_tool_slots();
    std::set<std::string> shown_;                ///< tools whose thumbnails were asked for
    std::vector<document::PaintRecipe> paints_;  ///< as they lie in the palette
    RememberedFile file_;
};

}  // namespace pastoso::main
