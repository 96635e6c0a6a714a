// A list of records with described parameters as a table that is edited in place, with buttons that add and
// remove rows.
#pragma once

#include "core/base/parameter.h"

#include <QWidget>

#include <functional>

class QLabel;
class QTableWidget;
class QToolButton;
class QVBoxLayout;

namespace facetmill::ui {

class RecordTable : public QWidget {
    Q_OBJECT
public:
    struct Words {
        QString name;        ///< of the table, for those who look for it
        QString row;         ///< "section": what the buttons' names end in
        QString called;      ///< "Holder section": what a message begins with
        QString add, remove; ///< what the buttons say
        QString none;        ///< what stands in its place where it is empty
    };
    /// A column for each field. `new_record`: what a new row begins with, from the rows before it.
    RecordTable(std::vector<const ParameterInfo*> fields, LengthUnit unit, const Words& words,
                std::function<std::vector<ParameterValue>(const ParameterRecords&)> new_record,
                QWidget* parent);

    void set_records(const ParameterRecords& records);
    /// What stands in the table; as before where `problem` says that it cannot be read.
    const ParameterRecords& records() const { return records_; }
    /// The first cell that cannot be read; empty where there is none.
    const QString& problem() const { return problem_; }
    /// Beside the table, below the two buttons.
    void add_button(QToolButton* button);

signals:
    void edited();

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void fit_columns();
    void show();
    void show_none();
    void show_row(int row, const std::vector<ParameterValue>& record);
    void read();
    void add_row();
    void remove_row();
    /// Empty for a number that nobody has said.
    QString shown(const ParameterValue& value, const ParameterInfo& field) const;
    ParameterValue entered(int row, int column, const QString& entry) const;

    std::vector<const ParameterInfo*> fields_;
    LengthUnit unit_;
    QString called_;
    std::function<std::vector<ParameterValue>(const ParameterRecords&)> new_record_;
    ParameterRecords records_;
    QString problem_;
    QTableWidget* table_ = nullptr;
    QLabel* none_ = nullptr;
    QVBoxLayout* buttons_ = nullptr;
    bool filling_ = false;
};

} // namespace facetmill::ui
