// The part of the start page that brings back paintings that a program left unfinished.
#pragma once

#include "dialogs/unfinished_pictures.hpp"
#include "journal/recovery.hpp"

#include <filesystem>
#include <map>
#include <vector>

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace pastoso::start {

class UnfinishedSection : public QWidget {
    Q_OBJECT
  public:
    explicit UnfinishedSection(QWidget* parent = nullptr);

    /// The latest stand here, the others behind a button. Hidden where there are none.
    void show_paintings(const std::vector<journal::Unfinished>& paintings);

  Q_SIGNALS:
    void wanted(const std::filesystem::path& journal);
    void all_wanted();  ///< to choose among them, or to discard some

  private:
    QWidget* row(const journal::Unfinished& painting);
    void show_picture(const journal::Unfinished& painting);

    QVBoxLayout* rows_;
    QWidget* shown_ = nullptr;
    std::map<std::filesystem::path, QLabel*> pictures_of_;  ///< by the journal's folder
    dialogs::UnfinishedPictures pictures_;
};

}  // namespace pastoso::start
