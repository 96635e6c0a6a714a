#include "ui/study_table.h"

#include "ui/study_words.h"
#include "ui/text.h"
#include "ui/theme.h"

#include <QHeaderView>
#include <QSortFilterProxyModel>

#include <algorithm>

namespace facetmill::ui {

namespace {

constexpr int study_sort_role = Qt::UserRole;
constexpr int widest_column = 260;
enum StudyColumn { number_of_candidate, standing_of_candidate, looked_at, first_variation };

} // namespace

class StudyTableModel : public QAbstractTableModel {
public:
    using QAbstractTableModel::QAbstractTableModel;

    void take(const StudyFiguresPtr& figures) {
        const bool same_shape = figures && figures_ && figures->rows.size() == figures_->rows.size()
                                && figures->variations == figures_->variations
                                && figures->unit == figures_->unit;
        if (same_shape) {
            figures_ = figures;
            if (!figures->rows.empty())
                emit dataChanged(index(0, 0), index(rowCount({}) - 1, columnCount({}) - 1));
            return;
        }
        beginResetModel();
        figures_ = figures;
        endResetModel();
    }
    const StudyFiguresPtr& figures() const { return figures_; }

    int rowCount(const QModelIndex& parent) const override {
        return figures_ && !parent.isValid() ? int(figures_->rows.size()) : 0;
    }
    int columnCount(const QModelIndex& parent) const override {
        return figures_ && !parent.isValid() ? first_measure() + int(all_measures().size()) + 1 : 0;
    }

    QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
        if (orientation != Qt::Horizontal || role != Qt::DisplayRole || !figures_) return {};
        if (section == number_of_candidate) return StudyTable::tr("No.");
        if (section == standing_of_candidate) return StudyTable::tr("Standing");
        if (section == looked_at) return StudyTable::tr("Looked at");
        if (section < first_measure()) return figures_->variations[section - first_variation];
        if (const auto measure = measure_of(section)) return measure_head(*measure, figures_->unit);
        return StudyTable::tr("Why not");
    }

    QVariant data(const QModelIndex& at, int role) const override {
        if (!figures_ || !at.isValid()) return {};
        const auto i = std::size_t(at.row());
        if (role == Qt::DisplayRole) return shown(i, at.column());
        if (role == Qt::ToolTipRole) return shown(i, at.column());
        if (role == study_sort_role) return key(i, at.column());
        if (role == Qt::TextAlignmentRole && (at.column() == number_of_candidate || measure_of(at.column())))
            return int(Qt::AlignRight | Qt::AlignVCenter);
        return {};
    }

private:
    int first_measure() const { return first_variation + int(figures_->variations.size()); }
    std::optional<Measure> measure_of(int column) const {
        const int m = column - first_measure();
        if (m < 0 || m >= int(all_measures().size())) return std::nullopt;
        return all_measures()[std::size_t(m)];
    }
    QString looked(const StudyRow& row) const {
        for (std::size_t r = all_rungs.size(); r-- > 0;)
            if (row.looks[r]) return rung_label(all_rungs[r]);
        return row.waiting ? StudyTable::tr("waits") : QString();
    }

    QString shown(std::size_t i, int column) const {
        const StudyRow& row = figures_->rows[i];
        if (column == number_of_candidate) return QString::number(i);
        if (column == standing_of_candidate)
            return row.waiting && !row.looks[0] ? QStringLiteral("–") : standing_label(row.standing);
        if (column == looked_at) return looked(row);
        if (column < first_measure()) {
            const int v = column - first_variation;
            return row.chosen.empty()
                       ? StudyTable::tr("as it stands")
                       : figures_->choices[std::size_t(v)][qsizetype(row.chosen[std::size_t(v)])];
        }
        const auto measure = measure_of(column);
        if (!measure) return row.why;
        const auto v = row.measures[*measure];
        return v ? measure_text(*measure, *v) : QString();
    }

    /// What a column is sorted by; what is not known comes last.
    QVariant key(std::size_t i, int column) const {
        const StudyRow& row = figures_->rows[i];
        if (column == number_of_candidate) return qulonglong(i);
        if (column == standing_of_candidate) return int(row.standing);
        if (column == looked_at) {
            int looks = 0;
            for (const auto& look : row.looks)
                looks += look ? 1 : 0;
            return -looks;
        }
        if (column < first_measure()) {
            const auto v = std::size_t(column - first_variation);
            return row.chosen.empty() ? -1 : int(row.chosen[v]);
        }
        if (const auto measure = measure_of(column)) return row.measures[*measure].value_or(infinity);
        return row.why;
    }

    StudyFiguresPtr figures_;
};

class StudyTableOrder : public QSortFilterProxyModel {
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;
    void set_kept(std::vector<char> kept) {
        kept_ = std::move(kept);
        invalidateFilter();
    }

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
        const auto i = std::size_t(row);
        return !parent.isValid() && (i >= kept_.size() || kept_[i]);
    }

private:
    std::vector<char> kept_;
};

StudyTable::StudyTable(QWidget* parent)
    : QTableView(parent), model_(new StudyTableModel(this)), order_(new StudyTableOrder(this)) {
    setObjectName(QStringLiteral("study_table"));
    setAccessibleName(tr("Candidates"));
    order_->setSourceModel(model_);
    order_->setSortRole(study_sort_role);
    setModel(order_);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setAlternatingRowColors(true);
    setTabKeyNavigation(false);
    setWordWrap(false);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    horizontalHeader()->setSectionsMovable(true);
    setSortingEnabled(true);
    sortByColumn(standing_of_candidate, Qt::AscendingOrder);
}

void StudyTable::show_figures(const StudyFiguresPtr& figures) {
    const int columns = model_->columnCount({});
    const std::optional<QModelIndex> current =
        currentIndex().isValid() ? std::optional(order_->mapToSource(currentIndex())) : std::nullopt;
    choosing_ = true;
    model_->take(figures);
    if (current && current->row() < model_->rowCount({})) choose(std::size_t(current->row()));
    choosing_ = false;
    if (columns != model_->columnCount({})) fit_columns();
}

void StudyTable::fit_columns() {
    resizeColumnsToContents();
    for (int c = 0; c < model_->columnCount({}); ++c)
        setColumnWidth(
            c, std::min(std::max(columnWidth(c), horizontalHeader()->sectionSizeHint(c)), widest_column));
}

void StudyTable::choose(std::optional<std::size_t> candidate) {
    const bool before = std::exchange(choosing_, true);
    if (!candidate || int(*candidate) >= model_->rowCount({})) {
        clearSelection();
        setCurrentIndex({});
    } else if (const QModelIndex at = order_->mapFromSource(model_->index(int(*candidate), 0));
               at.isValid()) {
        setCurrentIndex(at.siblingAtColumn(std::max(currentIndex().column(), 0)));
        scrollTo(at);
    }
    choosing_ = before;
}

void StudyTable::set_kept(std::vector<char> kept) {
    choosing_ = true;
    order_->set_kept(std::move(kept));
    choosing_ = false;
}

std::vector<std::size_t> StudyTable::listed() const {
    std::vector<std::size_t> all;
    for (int row = 0; row < order_->rowCount(); ++row)
        all.push_back(std::size_t(order_->mapToSource(order_->index(row, 0)).row()));
    return all;
}

void StudyTable::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    QTableView::currentChanged(current, previous);
    if (choosing_ || !current.isValid() || current.row() == previous.row()) return;
    emit candidate_chosen(std::size_t(order_->mapToSource(current).row()));
}

} // namespace facetmill::ui
