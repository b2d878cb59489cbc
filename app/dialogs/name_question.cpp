#include "dialogs/name_question.hpp"

#include <QDialogButtonBox>
#include <QInputDialog>
#include <QPushButton>

namespace pastoso::dialogs {

std::optional<QString> ask_name(const AskedName& asked, QWidget* parent) {
    QInputDialog dialog(parent);
    dialog.setWindowTitle(asked.title);
    dialog.setLabelText(asked.label);
    if (!asked.choices.isEmpty()) {
        dialog.setComboBoxItems(asked.choices);
        dialog.setComboBoxEditable(true);
    }
    dialog.setTextValue(asked.proposal);
    dialog.adjustSize();  // makes its buttons
    QPushButton* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    const auto need_name = [ok](const QString& typed) { ok->setEnabled(!typed.trimmed().isEmpty()); };
    QObject::connect(&dialog, &QInputDialog::textValueChanged, &dialog, need_name);
    need_name(dialog.textValue());
    const bool accepted = dialog.exec() == QDialog::Accepted;
    const QString name = dialog.textValue().trimmed();
    return accepted && !name.isEmpty() ? std::optional(name) : std::nullopt;
}

}  // namespace pastoso::dialogs
