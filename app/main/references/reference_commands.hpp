// The board of references beside the canvas, or in a window of its own above it: pictures come to it,
// and their colours go into the hand.
#pragma once

#include "document/references.hpp"
#include "main/files/loading.hpp"
#include "main/studio.hpp"

#include <functional>
#include <optional>
#include <vector>

#include <QObject>
#include <QPointF>
#include <QStringList>

class QDockWidget;
class QImage;
class QMimeData;

namespace pastoso::panels {
class ReferencePanel;
}

namespace pastoso::main {

class ReferenceCommands : public QObject {
    Q_OBJECT
  public:
    ReferenceCommands(Studio& studio, Loading& loading, panels::ReferencePanel* panel,
                      QDockWidget* dock);

    /// Reads pictures beside the window and lays them on the board, beside what lies there or the first
    /// one about a point. What is no picture is told, and the others come.
    void add_files(const QStringList& paths, std::optional<QPointF> middle_mm = std::nullopt);

    /// The same of one that is in memory.
    void add_picture(const QImage& image, std::optional<QPointF> middle_mm = std::nullopt);

    /// The same of files that are dragged or copied, of a picture out of a browser or the clipboard.
    void add_dragged(const QMimeData& data, std::optional<QPointF> middle_mm);

  private:
    struct Packed {
        std::string name;
        document::SharedReferencePicture picture;
    };
    struct Source {
        QString name;
        std::function<pigment::Picture()> read;
    };

    void listen();
    void ask_for_pictures();
    void add(const QString& what, std::vector<Source> sources, std::optional<QPointF> middle_mm);
    void lay(const std::vector<Packed>& pictures, std::optional<QPointF> middle_mm);
    void take_colour(const pigment::Srgb8& colour);

    Studio& studio_;
    Loading& loading_;
    panels::ReferencePanel* panel_;
    QDockWidget* dock_;
};

}  // namespace pastoso::main
