// The part of the start page that goes on with paintings that were opened or saved last.
#pragma once

#include "start/painting_reader.hpp"

#include <filesystem>
#include <vector>

#include <QWidget>

class QLabel;

namespace pastoso::panels {
class Gallery;
}

namespace pastoso::start {

class Gallery;

class RecentSection : public QWidget {
    Q_OBJECT
  public:
    explicit RecentSection(QWidget* parent = nullptr);

    /// Shows these, the latest first; their pictures come as they are read.
    void show_paintings(const std::vector<std::filesystem::path>& paths);

    void fit(int width);

    panels::Gallery* gallery() { return gallery_; }

    /// Whether all that was shown has been read.
    bool all_read() const;

    const std::vector<PaintingFile>& paintings() const { return paintings_; }

  Q_SIGNALS:
    void wanted(const std::filesystem::path& painting);
    void removal_wanted(const std::filesystem::path& painting);  ///< from the list, not from the disk
    void open_wanted();                                          ///< one that is not in the list

  private:
    void note(const PaintingFile& file);
    const PaintingFile& painting(int number) const;

    PaintingReader reader_;
    std::vector<PaintingFile> paintings_;
    std::size_t to_read_ = 0;
    panels::Gallery* gallery_;
    QLabel* none_yet_;
};

}  // namespace pastoso::start
