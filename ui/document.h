// What the workbench works on: the project with its undo history, the part as it was read, and what was
// planned, with the state of every operation. No widgets; the window listens.
#pragma once

#include "core/job/new_operation.h"
#include "core/job/opened_program.h"
#include "core/job/planner.h"
#include "core/job/project.h"
#include "ui/document_keys.h"
#include "ui/file_watch.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace facetmill::ui {

enum class OperationState { not_planned, planning, planned, stale, failed, off };

/// What planning one operation came to: a result, or why there is none.
struct OperationOutcome {
    int id = 0;
    std::shared_ptr<const OperationResult> result;
    QString failure;
    std::string fingerprint; ///< says everything the result depends on
};

class Document : public QObject {
    Q_OBJECT
public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    /// False before the first part: an empty window.
    bool has_part() const { return !project_.part.file.empty(); }
    const Project& project() const { return project_; }
    LengthUnit unit() const { return project_.unit; }
    /// "concave.facetmill", or what an unsaved project is called.
    QString name() const;
    /// There is something to lose: changes, or what was planned of a project that is nowhere on disk. A mesh
    /// that was only opened is not.
    bool modified() const;
    QUndoStack& undo_stack() { return undo_; }

    /// Takes another project; the history and all results are gone. `name` is shown while the project has no
    /// path; `unsaved` makes it modified from the start (work that was lost and found again).
    void open(Project project, const QString& name, bool unsaved);
    void clear();
    /// After the project was written, with this path and these files, as it is now or, where it has been
    /// changed since, as it was.
    void saved(const Project& written, bool as_it_is = true);

    /// Changes a copy of the project by `edit` and takes it as one step of the history. Where `edit` throws
    /// nothing changes.
    void change(const QString& what, const std::function<void(Project&)>& edit);

    // operations; they keep their id through edits, moves and undo
    std::size_t operation_count() const { return project_.operations.size(); }
    const Operation& operation(std::size_t i) const { return *project_.operations[i]; }
    /// Switched off: it is in the project, and else left out of everything.
    bool is_off(std::size_t i) const { return operation(i).common().off; }
    int operation_id(std::size_t i) const { return ids()[i]; }
    /// The operations of each setup.
    const std::vector<std::vector<int>>& setup_ids() const { return ids_; }
    std::optional<std::size_t> index_of(int id) const;
    /// Where machining asks for it, as new_operation makes it; returns its place.
    std::size_t add_operation(const std::string& kind, const OperationWish& wish = {});
    /// As one step, with tools that they need.
    void add_operations(const QString& what, std::size_t place,
                        std::vector<std::unique_ptr<Operation>> operations, const std::vector<Tool>& tools);
    /// As one step: the project with other operations in its shown setup, under new ids.
    void replace_operations(const QString& what, Project project);
    void remove_operation(std::size_t i);

    /// Changes the list of setups, with the ids of their operations, and chooses one of them: see
    /// setup_list.h. Throws what put_setups does.
    void change_setups(const QString& what, std::size_t chosen,
                       const std::function<void(std::vector<Setup>&, std::vector<std::vector<int>>&)>& edit);
    int new_id() { return next_id_++; }

    // tools
    long free_tool_number() const;

    // the part as read
    void set_part(std::shared_ptr<const PreparedPart> part, const std::string& key);
    const std::shared_ptr<const PreparedPart>& part() const { return part_; }
    // document_keys.h
    static std::string part_key(const Project& project) { return ui::part_key(project); }
    static std::string posting_key(const Project& project) { return ui::posting_key(project); }
    static std::string fingerprint(const Project& project, std::size_t i) {
        return ui::fingerprint(project, i);
    }
    /// False when the project says something else than what was read.
    bool part_is_current() const { return part_ && part_key_ == part_key(project_); }
    /// False where the stock is a mesh that could not be read with the part, or a rest that is not known yet.
    bool has_stock() const {
        const bool as_mesh =
            project_.stock.kind == StockSpec::Kind::mesh || project_.stock.kind == StockSpec::Kind::rest;
        return part_ && (!as_mesh || part_->stock_mesh);
    }

    // results
    OperationState state(std::size_t i) const;
    /// Every operation that is not switched off, up to one (none: all), is planned as it stands, and there is
    /// one.
    bool all_planned(std::optional<std::size_t> up_to = std::nullopt) const;
    /// Null for one that is switched off.
    std::shared_ptr<const OperationResult> result(std::size_t i) const;
    QString failure(std::size_t i) const;
    /// What an operation of any setup came to when it had this fingerprint; null where that is another now,
    /// or planning is under way.
    std::shared_ptr<const OperationResult> result_of(int id, const std::string& fingerprint) const;
    void set_planning(const std::vector<int>& ids);
    void take(const std::vector<OperationOutcome>& outcomes);
    /// The results of all operations in order, in the project's present unit; null when one is missing or
    /// stale. `only`: that of one operation alone.
    std::shared_ptr<const PlanResult> complete_plan(std::optional<std::size_t> only = std::nullopt) const;
    /// A program from a file that is shown in place of the plan; null: the plan is. Another project, and
    /// whatever is planned, put it away.
    const std::shared_ptr<const OpenedProgram>& program() const { return program_; }
    void show_program(std::shared_ptr<const OpenedProgram> program);
    /// "Finish", or "Finish 2" when that is taken by another operation.
    std::string free_operation_name(const std::string& wish) const;

signals:
    /// Another project: everything changed.
    void opened();
    /// Values, tools or operations changed; also on undo and redo.
    void changed();
    void part_changed();
    void states_changed();
    void modified_changed();
    /// A new operation brought a tool that the list had not.
    void tool_added(const facetmill::Tool& tool);

private:
    friend class ProjectStep;
    struct Snapshot {
        Project project;
        std::vector<std::vector<int>> ids; ///< of the operations of each setup
        std::vector<int>& own() { return ids[chosen_setup(project)]; }
    };
    struct Record {
        std::shared_ptr<const OperationResult> result;
        QString failure;
        std::string fingerprint;
        bool planning = false;
    };
    using SnapshotPtr = std::shared_ptr<const Snapshot>;

    void restore(const Snapshot& snapshot);
    void push(const QString& what, Snapshot after);
    Snapshot snapshot() const { return {project_, ids_}; }
    const std::vector<int>& ids() const { return ids_[chosen_setup(project_)]; }

    Project project_;
    std::vector<std::vector<int>> ids_ =
        std::vector<std::vector<int>>(1); ///< of the operations of each setup
    int next_id_ = 1;
    QString name_;
    bool never_saved_ = false;
    QUndoStack undo_;
    std::shared_ptr<const PreparedPart> part_;
    std::string part_key_;
    std::map<int, Record> records_;
    std::shared_ptr<const OpenedProgram> program_;
    std::map<std::filesystem::path, std::filesystem::path> copies_; ///< of parts that saving took along
    FileWatch files_;                                               ///< those that the project names
};

} // namespace facetmill::ui
