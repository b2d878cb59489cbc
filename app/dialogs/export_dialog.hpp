// Asks what to make of the painting for other programs, how, and where to put it.
#pragma once

#include "dialogs/export_summary.hpp"
#include "dialogs/growing_dialog.hpp"
#include "tools/export_settings.hpp"

#include <filesystem>
#include <map>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace pastoso::dialogs {

class ExportDialog : public GrowingDialog {
    Q_OBJECT
  public:
    /// `proposal` is a whole path whose ending does not count. Where `may_replace`, it stays the name
    /// whatever lies there; otherwise a free name beside it is proposed.
    ExportDialog(ExportSubject subject, const tools::ExportSettings& settings,
                 std::filesystem::path proposal, bool may_replace, QWidget* parent = nullptr);

    const tools::ExportSettings& settings() const { return settings_; }

    /// The file, or the folder for numbered pictures, whole and with its ending; empty without a name.
    std::filesystem::path path() const;

  private:
    struct Number {
        const char* name;
        double least, most;
        int decimals;
        QString unit, hint;
    };
    QDoubleSpinBox* add_number(const Number& number, double& value);
    QDoubleSpinBox* add_number(QDoubleSpinBox* box, const Number& number, double& value);
    QComboBox* add_choice(const char* name, const QString& hint);
    void make_form_box();
    QWidget* make_path_row();
    QWidget* make_size_row();
    void make_colour_box();
    void make_picture_boxes();
    void make_numbers();
    void add_row(const QString& words, QWidget* field, QWidget* buddy = nullptr);
    void show_row(QWidget* field, bool shown);
    void lay_out();

    void choose_form(tools::ExportForm form);
    void choose_format(std::size_t format);
    void follow_name(const QString& text);
    void propose_name();
    void browse();
    void choose_colours();
    void list_formats();
    void list_colours();
    int cells_across() const;
    void show_rows();
    void show_size();
    void show_outcome();

    ExportSubject subject_;
    tools::ExportSettings settings_;
    std::filesystem::path proposal_;
    bool named_;  ///< by the painter: the name stays

    QGridLayout* rows_ = nullptr;
    std::map<QWidget*, QLabel*> labels_;  ///< of the rows, by what stands beside them
    QComboBox* form_ = nullptr;
    QLabel* explanation_ = nullptr;
    QLineEdit* path_ = nullptr;
    QWidget* path_row_ = nullptr;
    QComboBox* format_ = nullptr;
    QSpinBox* quality_ = nullptr;
    QComboBox* surface_ = nullptr;
    QDoubleSpinBox* scale_ = nullptr;
    QSpinBox* width_ = nullptr;
    QWidget* size_row_ = nullptr;
    QComboBox* colours_ = nullptr;
    QCheckBox* lit_ = nullptr;
    QDoubleSpinBox* base_ = nullptr;
    QDoubleSpinBox* exaggeration_ = nullptr;
    QDoubleSpinBox* resolution_ = nullptr;
    QDoubleSpinBox* speed_ = nullptr;
    QDoubleSpinBox* fps_ = nullptr;
    QDoubleSpinBox* film_cells_ = nullptr;
    QLabel* outcome_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
    QPushButton* export_ = nullptr;
};

}  // namespace pastoso::dialogs
