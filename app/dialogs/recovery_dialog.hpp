// Offers the paintings that a program left unfinished.
#pragma once

#include "dialogs/growing_dialog.hpp"
#include "dialogs/unfinished_pictures.hpp"
#include "journal/recovery.hpp"

#include <functional>
#include <vector>

class QLabel;
class QListWidget;
class QPushButton;

namespace pastoso::dialogs {

/// Accepted: the chosen painting is wanted back. Rejected: not now; all of them stay.
class RecoveryDialog : public GrowingDialog {
    Q_OBJECT
  public:
    /// Asked before a painting is given up for good.
    using Confirm = std::function<bool(const QString& question)>;

    /// `paintings` are not empty. Without `confirm`, a message box asks.
    explicit RecoveryDialog(std::vector<journal::Unfinished> paintings, QWidget* parent = nullptr,
                            Confirm confirm = {});

    /// The painting in the list that is marked.
    const journal::Unfinished& chosen() const;

    int count() const { return static_cast<int>(paintings_.size()); }

    QPushButton* recover_button() { return recover_; }
    QPushButton* discard_button() { return discard_; }

  private:
    void list_paintings();
    void show_picture(const journal::Unfinished& painting);
    void show_chosen();
    void discard_chosen();

    std::vector<journal::Unfinished> paintings_;
    Confirm confirm_;
    QListWidget* list_ = nullptr;
    QLabel* fault_ = nullptr;
    QPushButton* recover_ = nullptr;
    QPushButton* discard_ = nullptr;
    UnfinishedPictures pictures_;
};

}  // namespace pastoso::dialogs
