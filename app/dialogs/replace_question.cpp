#include "dialogs/replace_question.hpp"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace pastoso::dialogs {
namespace {

QString words(const char* text) {
    return QCoreApplication::translate("pastoso::dialogs", text);
}

}  // namespace

Replacing ask_replacing(const QString& sentence, QWidget* parent) {
    QMessageBox question(QMessageBox::Question, words(QT_TR_NOOP("Save")), sentence, QMessageBox::Cancel,
                         parent);
    question.setObjectName(QStringLiteral("replace_question"));
    QPushButton* replace =
        question.addButton(words(QT_TR_NOOP("Replace")), QMessageBox::DestructiveRole);
    QPushButton* save_as = question.addButton(words(QT_TR_NOOP("Save as...")), QMessageBox::AcceptRole);
    question.setDefaultButton(save_as);
    question.exec();
    if (question.clickedButton() == replace) return Replacing::Replace;
    return question.clickedButton() == save_as ? Replacing::SaveAs : Replacing::Cancel;
}

}  // namespace pastoso::dialogs
