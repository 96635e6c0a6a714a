// The candidates of a study as a table that is sorted by any column.
#pragma once

#include "ui/study_figures.h"

#include <QTableView>

#include <optional>
#include <vector>

namespace facetmill::ui {

class StudyTableModel;
class StudyTableOrder;

class StudyTable : public QTableView {
    Q_OBJECT
public:
    explicit StudyTable(QWidget* parent = nullptr);

    void show_figures(const StudyFiguresPtr& figures);
    void choose(std::optional<std::size_t> candidate);
    /// Others are not listed; empty: all are.
    void set_kept(std::vector<char> kept);
    /// The candidates from the first row to the last.
    std::vector<std::size_t> listed() const;
    QSize minimumSizeHint() const override { return {200, 90}; }

signals:
    /// By the user.
    void candidate_chosen(std::size_t candidate);

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

private:
    void fit_columns();

    StudyTableModel* model_ = nullptr;
    StudyTableOrder* order_ = nullptr;
    bool choosing_ = false;
};

} // namespace facetmill::ui
