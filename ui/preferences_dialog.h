// What belongs to the user and not to a project: how the view is turned, colours, language, what new projects
// begin with, how often work is kept, how many threads it gets, where libraries and templates lie.
#pragma once

#include "ui/settings.h"

#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QGroupBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace facetmill::ui {

class UsualProjectBox;

/// What the buttons of the mouse do in a style, a line each: "Turn: middle button".
QStringList navigation_words(NavigationStyle style);

class PreferencesDialog : public QDialog {
    Q_OBJECT
public:
    explicit PreferencesDialog(QWidget* parent = nullptr);

    /// Keeps what was chosen.
    void accept() override;

private:
    QGroupBox* make_view();
    QGroupBox* make_new_projects();
    QGroupBox* make_work();
    void add_language(QFormLayout& form);
    void add_folder(QFormLayout& form);
    QString shown_folder() const;
    void judge_folder();

    QComboBox *style_ = nullptr, *orbit_ = nullptr, *colors_ = nullptr, *language_ = nullptr;
    QLabel* buttons_ = nullptr;
    UsualProjectBox* usual_ = nullptr;
    QSpinBox *autosave_ = nullptr, *threads_ = nullptr;
    QLineEdit* folder_ = nullptr;
    QLabel* trouble_ = nullptr;
    QDialogButtonBox* buttons_box_ = nullptr;
};

} // namespace facetmill::ui
