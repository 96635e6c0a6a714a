// The scan room beside the view: what is wrong with the mesh file, the steps of the recipe with what each of
// them came to, and the buttons that try the recipe and take it over.
#pragma once

#include "core/repair/recipe.h"
#include "ui/parameter_editor.h"

#include <QWidget>

#include <optional>
#include <vector>

class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;
class QRadioButton;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;
class QVBoxLayout;

namespace facetmill::ui {

class ElidedLabel;
class ParameterForm;

class ScanPanel : public QWidget {
    Q_OBJECT
public:
    /// A line of the survey, with lines of its own below it: pieces, holes.
    struct Line {
        QString what, now, after, help;
        bool flaw = false; ///< something is wrong
        std::vector<Line> parts;
    };
    struct Step {
        QString name, result, help;
        bool off = false, failed = false;
    };
    /// What can be done.
    struct Can {
        bool edit = false, preview = false, apply = false, reset = false;
    };
    enum Column { what_column, now_column, after_column };

    explicit ScanPanel(QWidget* parent = nullptr);

    QTreeWidget* survey() { return survey_; }
    QListWidget* steps() { return steps_; }
    ParameterForm* form() { return form_; }
    QSize sizeHint() const override { return {330, 560}; }
    QSize minimumSizeHint() const override { return {190, 120}; }

    /// File and size; with `note` in place of all the rest where there is nothing to show.
    void show_head(const QString& title, const QString& subtitle, const QString& note);
    void show_survey(const std::vector<Line>& lines);
    /// The last column anew, of the same lines; `after` of lines and of their parts.
    void show_after(const std::vector<Line>& lines);
    /// `chosen`: the step whose parameters are shown; none where there is none.
    void show_steps(const std::vector<Step>& steps, std::optional<std::size_t> chosen);
    std::optional<std::size_t> chosen() const;
    /// The parameters of the chosen step; null: none is. `remark` is told below it.
    void show_parameters(RepairStep* step, LengthUnit unit, const NamedLengths& names);
    void show_remark(const QString& remark, bool alarm);
    void show_can(const Can& can);
    /// A preview is on its way; below 0: none is.
    void show_progress(double fraction, const QString& label);
    /// Whether there is something to see, and which side of it is, if any.
    void show_sides(bool there, std::optional<bool> after);
    void show_summary(const QString& summary);

signals:
    void add_wanted(facetmill::RepairStep::Kind kind);
    void remove_wanted();
    void move_wanted(int by);
    void switched(std::size_t step, bool on);
    void step_chosen();
    void edited(const std::string& key, const facetmill::ParameterValue& value);
    void suggest_wanted();
    void preview_wanted();
    void stop_wanted();
    void side_wanted(bool after);
    void apply_wanted();
    void reset_wanted();
    /// A part of a line of the survey was chosen.
    void part_chosen(std::size_t line, std::size_t part);

private:
    void build_survey(QVBoxLayout* column);
    void build_steps(QVBoxLayout* column);
    void build_trial(QVBoxLayout* column);
    void fill_line(QTreeWidgetItem* item, const Line& line) const;

    ElidedLabel* title_ = nullptr;
    QLabel *subtitle_ = nullptr, *note_ = nullptr, *empty_ = nullptr, *remark_ = nullptr, *summary_ = nullptr;
    QWidget *content_ = nullptr, *footer_ = nullptr, *running_ = nullptr;
    QTreeWidget* survey_ = nullptr;
    QListWidget* steps_ = nullptr;
    ParameterForm* form_ = nullptr;
    std::optional<RepairStep::Kind> form_kind_;
    LengthUnit form_unit_ = LengthUnit::mm;
    QToolButton *add_ = nullptr, *remove_ = nullptr, *up_ = nullptr, *down_ = nullptr;
    QPushButton *suggest_ = nullptr, *preview_ = nullptr, *stop_ = nullptr, *apply_ = nullptr,
                *reset_ = nullptr;
    QRadioButton *before_ = nullptr, *after_ = nullptr;
    QProgressBar* progress_ = nullptr;
    bool filling_ = false, can_edit_ = false;
};

} // namespace facetmill::ui
