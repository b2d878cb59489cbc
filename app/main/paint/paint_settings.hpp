// The painter's own paints, found again at the next start and saved for others, and palettes to choose
// from.
#pragma once

#include "main/files/loading.hpp"
#include "main/program/remembered_file.hpp"
#include "main/studio.hpp"

#include <filesystem>
#include <functional>

#include <QObject>
#include <QTimer>

namespace pastoso::panels {
class ColourPanel;
}

namespace pastoso::main {

class PaintSettings : public QObject {
    Q_OBJECT
  public:
    PaintSettings(Studio& studio, Loading& loading, panels::ColourPanel* colours);

    /// A file that cannot be read is told, and left as it is.
    void recall();
    /// What has changed since: another window may have kept other paints meanwhile.
    void remember();

    /// Shows the colours of a .gpl file to choose from. What is none is told.
    void open_palette(const QString& path);

    /// Finds so many colours of a picture and shows them in the same way, made beside the window.
    void open_picture(const QString& path, int colours);

    /// Writes the painter's palette as a .gpl file.
    void save_palette(const QString& path);

    /// Writes the painter's palette and mixes as a file, and adds those of such a file.
    void export_paints(const QString& path);
    void import_paints(const QString& path);

  private:
    void keep();
    void ask_palette();
    void ask_picture(int colours);
    void ask_save_palette();
    void ask_export();
    void ask_import();
    void write(const QString& what, const QString& path,
               const std::function<void(const std::filesystem::path&)>& work);

    Studio& studio_;
    Loading& loading_;
    panels::ColourPanel* colours_;
    QTimer changed_;  ///< soon after the last of several changes
    RememberedFile file_;
};

}  // namespace pastoso::main
