// What a new study asks: what may vary, what is wanted, limits, and how many candidates.
#pragma once

#include "ui/study_draft.h"

#include <QWidget>

#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QSpinBox;
class QTreeWidget;
class QTreeWidgetItem;

namespace facetmill::ui {

class StudyForm : public QWidget {
    Q_OBJECT
public:
    explicit StudyForm(QWidget* parent = nullptr);

    void set_draft(StudyDraft draft);
    const StudyDraft& draft() const { return draft_; }
    /// What the study will take, below the rest.
    void show_estimate(const QString& words, bool alarm);

    QTreeWidget* vary() { return vary_; }
    QTreeWidget* measures() { return measures_; }

signals:
    void changed();

private:
    void build_vary();
    void build_measures();
    QWidget* build_options();
    void fill_vary();
    void fill_measures();
    void add_choices(QTreeWidgetItem* row, std::size_t variation);
    void add_field(QTreeWidgetItem* row, std::size_t variation);
    void take_check(QTreeWidgetItem* item);
    void tell_counts();
    void order_tabs();

    StudyDraft draft_;
    std::vector<QLineEdit*> vary_fields_, limit_fields_;
    QTreeWidget *vary_ = nullptr, *measures_ = nullptr;
    QComboBox* first_ = nullptr;
    QSpinBox* samples_ = nullptr;
    QLabel* estimate_ = nullptr;
    bool filling_ = false;
};

} // namespace facetmill::ui
