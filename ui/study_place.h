// Where a study's candidates are worked on: this computer, another one by ssh, or a Slurm cluster; and how
// many at once.
#pragma once

#include "ui/study_runner.h"

#include <QWidget>

class QComboBox;
class QLineEdit;
class QSpinBox;

namespace facetmill::ui {

class StudyPlaceForm : public QWidget {
    Q_OBJECT
public:
    explicit StudyPlaceForm(QWidget* parent = nullptr);

    StudyPlace place() const;
    /// Why nobody can work there; empty: somebody can.
    QString problem() const;

signals:
    void changed();

private:
    void tell_host();

    QComboBox* where_ = nullptr;
    QLineEdit* host_ = nullptr;
    QSpinBox* workers_ = nullptr;
};

} // namespace facetmill::ui
