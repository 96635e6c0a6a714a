// Asks for a folder into which several files go: a path that can be typed, what is said of it as it is typed,
// and a button to look for one.
#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;

namespace facetmill::ui {

class FolderDialog : public QDialog {
    Q_OBJECT
public:
    /// Its absolute path.
    QString folder() const;

protected:
    /// `name`: what the names of the dialog and of its parts begin with.
    FolderDialog(const QString& name, QWidget* parent);
    struct Words {
        QString question; ///< rich text
        QString question_tip, browse_tip, accept;
    };
    /// Called once, at the end of a constructor.
    void build(const Words& words, const QString& start);

    /// What is typed, with '/' between folders.
    QString typed() const;
    /// Why the folder will not do; the dialog cannot be accepted then.
    virtual QString trouble() const = 0;
    /// What will come of it, where it will do.
    virtual QString note() const { return {}; }
    /// The folder that is meant where another one was looked for; empty where none was.
    virtual QString browsed() = 0;

private:
    void browse();
    void judge();

    QString name_;
    QLineEdit* folder_ = nullptr;
    QLabel* said_ = nullptr;
    QPushButton* accept_ = nullptr;
};

} // namespace facetmill::ui
