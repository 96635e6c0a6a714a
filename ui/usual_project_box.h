// What new projects begin with: machine, control, and the unit that meshes are in.
#pragma once

#include "ui/settings.h"

#include <QWidget>

class QComboBox;

namespace facetmill::ui {

class UsualProjectBox : public QWidget {
    Q_OBJECT
public:
    explicit UsualProjectBox(QWidget* parent = nullptr);

    settings::UsualProject usual() const;
    void set_usual(const settings::UsualProject& usual);

signals:
    /// The user chose something.
    void chosen();

private:
    QComboBox *machine_ = nullptr, *post_ = nullptr, *unit_ = nullptr;
};

} // namespace facetmill::ui
