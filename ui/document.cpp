#include "ui/document.h"

#include "core/job/asked_operations.h"
#include "core/job/new_operation.h"
#include "core/job/project_inputs.h"
#include "core/job/stock_solid.h"
#include "core/output/post/post.h"
#include "ui/aside.h"
#include "ui/operation_list.h"
#include "ui/text.h"
#include "ui/tool_list.h"

#include <QUndoCommand>

#include <algorithm>
#include <set>
#include <utility>

namespace facetmill::ui {

namespace {

std::vector<std::filesystem::path> files_of(const Project& project) {
    std::vector<std::filesystem::path> files;
    for (const ProjectInput& input : project_inputs(project))
        files.push_back(input.path);
    return files;
}

/// Parts that saving has copied beside the project, by where they were.
using Copies = std::map<std::filesystem::path, std::filesystem::path>;

void note_copy(Copies& copies, const std::filesystem::path& before, const std::filesystem::path& now) {
    if (now.lexically_normal() != before.lexically_normal()) copies[before] = now;
}

/// Names the files of a step of the history from where the project lies now.
void move_step(Project& project, const std::filesystem::path& path, const Copies& copies) {
    const auto copy = copies.find(project.part_path());
    if (!path.empty() && project.path != path) move_project(project, path);
    project.path = path;
    if (copy != copies.end()) set_input(project, {ProjectInput::Kind::part, {}}, copy->second);
}

} // namespace

/// One step of the history: the project before and after. Projects hold no meshes, so whole copies are cheap
/// and no step can be undone wrongly.
class ProjectStep : public QUndoCommand {
public:
    ProjectStep(Document& document, const QString& what, Document::SnapshotPtr before,
                Document::SnapshotPtr after)
        : QUndoCommand(what), document_(document), before_(std::move(before)), after_(std::move(after)) {}

    void undo() override { document_.restore(*before_); }
    void redo() override { document_.restore(*after_); }

private:
    Document& document_;
    Document::SnapshotPtr before_, after_;
};

Document::Document(QObject* parent) : QObject(parent) {
    undo_.setUndoLimit(200);
    connect(&undo_, &QUndoStack::cleanChanged, this, &Document::modified_changed);
    connect(&files_, &FileWatch::settled, this, [this] {
        // Reading anew would displace a plan that is being made; it reads what has changed by itself.
        if (std::any_of(records_.begin(), records_.end(), [](const auto& r) { return r.second.planning; }))
            return files_.wait_again();
        files_.watch(files_of(project_));
        emit states_changed();
        if (has_part() && !part_is_current()) emit part_changed();
    });
}

Document::~Document() {
    // A history that goes says once more that it is clean. Whoever then asks the document would read plans
    // that are gone already.
    undo_.disconnect(this);
}

QString Document::name() const {
    if (!project_.path.empty()) return path_text(project_.path.filename());
    return name_;
}

bool Document::modified() const {
    const bool planned = std::any_of(records_.begin(), records_.end(),
                                     [](const auto& record) { return record.second.result != nullptr; });
    return never_saved_ || !undo_.isClean() || (planned && project_.path.empty());
}

void Document::open(Project project, const QString& name, bool unsaved) {
    project_ = std::move(project);
    ids_.clear();
    for (std::size_t k = 0; k < setup_count(project_); ++k) {
        ids_.emplace_back();
        for (std::size_t i = 0; i < setup_at(project_, k).operations.size(); ++i)
            ids_.back().push_back(next_id_++);
    }
    name_ = name;
    never_saved_ = unsaved;
    for (auto& [id, record] : records_)
        let_go(std::move(record.result));
    records_.clear();
    let_go(std::exchange(program_, nullptr));
    let_go(std::exchange(part_, nullptr));
    part_key_.clear();
    copies_.clear();
    undo_.clear();
    undo_.setClean();
    files_.watch(files_of(project_));
    emit opened();
    emit part_changed();
    emit states_changed();
    emit modified_changed();
}

void Document::clear() {
    open(Project(), QString(), false);
}

void Document::saved(const Project& written, bool as_it_is) {
    // Part and stock are the same files under other names: what was read from them stays current.
    const bool current = part_is_current();
    const auto for_each_result = [this](const auto& take) {
        for (std::size_t k = 0; k < setup_count(project_); ++k) {
            const Project view = view_of_setup(project_, k);
            for (std::size_t i = 0; i < ids_[k].size(); ++i)
                if (const auto it = records_.find(ids_[k][i]); it != records_.end())
                    take(it->first, it->second, fingerprint(view, i));
        }
    };
    std::set<int> good;
    for_each_result([&](int id, const Record& record, const std::string& now) {
        if (record.fingerprint == now) good.insert(id);
    });
    const std::filesystem::path before = project_.part_path();
    project_.path = written.path;
    take_inputs(project_, written);
    note_copy(copies_, before, project_.part_path());
    if (current) part_key_ = part_key(project_);
    for_each_result([&](int id, Record& record, const std::string& now) {
        if (good.count(id)) record.fingerprint = now;
    });
    never_saved_ = false;
    as_it_is ? undo_.setClean() : undo_.resetClean();
    files_.watch(files_of(project_));
    emit modified_changed();
    emit changed();
}

void Document::change(const QString& what, const std::function<void(Project&)>& edit) {
    Snapshot after = snapshot();
    edit(after.project);
    push(what, std::move(after));
}

void Document::push(const QString& what, Snapshot after) {
    undo_.push(new ProjectStep(*this, what, std::make_shared<Snapshot>(snapshot()),
                               std::make_shared<Snapshot>(std::move(after))));
}

void Document::restore(const Snapshot& snapshot) {
    // Where the project lies on disk is no matter of its history.
    const std::filesystem::path path = project_.path;
    if (chosen_setup(snapshot.project) != chosen_setup(project_))
        program_ = nullptr; // it is of the other setup
    project_ = snapshot.project;
    move_step(project_, path, copies_);
    ids_ = snapshot.ids;
    files_.watch(files_of(project_));
    emit changed();
    emit states_changed();
    if (has_part() && !part_is_current()) emit part_changed();
}

std::optional<std::size_t> Document::index_of(int id) const {
    const auto it = std::find(ids().begin(), ids().end(), id);
    if (it == ids().end()) return std::nullopt;
    return std::size_t(it - ids().begin());
}

std::string Document::free_operation_name(const std::string& wish) const {
    return facetmill::free_operation_name(project_, wish);
}

std::size_t Document::add_operation(const std::string& kind, const OperationWish& wish) {
    NewOperation made = new_operation(kind, project_, wish);
    made.operation->common().name = free_operation_name(first_name_of(kind));
    std::vector<std::unique_ptr<Operation>> one;
    one.push_back(std::move(made.operation));
    std::vector<Tool> tools;
    if (made.tool) {
        made.tool->name = usual_tool_name_said(*made.tool, project_.unit);
        tools.push_back(*made.tool);
    }
    add_operations(tr("Add operation"), made.place, std::move(one), tools);
    if (made.tool) emit tool_added(*made.tool);
    return made.place;
}

void Document::add_operations(const QString& what, std::size_t place,
                              std::vector<std::unique_ptr<Operation>> operations,
                              const std::vector<Tool>& tools) {
    Snapshot after = snapshot();
    after.project.tools.insert(after.project.tools.end(), tools.begin(), tools.end());
    for (auto& operation : operations) {
        const auto at = std::ptrdiff_t(place++);
        after.project.operations.insert(after.project.operations.begin() + at, std::move(operation));
        after.own().insert(after.own().begin() + at, next_id_++);
    }
    push(what, std::move(after));
}

void Document::replace_operations(const QString& what, Project project) {
    Snapshot after{std::move(project), ids_};
    after.own().clear();
    for (std::size_t i = 0; i < after.project.operations.size(); ++i)
        after.own().push_back(next_id_++);
    push(what, std::move(after));
}

void Document::remove_operation(std::size_t i) {
    Snapshot after = snapshot();
    after.project.operations.erase(after.project.operations.begin() + std::ptrdiff_t(i));
    after.own().erase(after.own().begin() + std::ptrdiff_t(i));
    push(tr("Remove operation"), std::move(after));
}

void Document::change_setups(
    const QString& what, std::size_t chosen,
    const std::function<void(std::vector<Setup>&, std::vector<std::vector<int>>&)>& edit) {
    Snapshot after = snapshot();
    std::vector<Setup> setups = take_setups(after.project);
    edit(setups, after.ids);
    put_setups(after.project, std::move(setups), chosen);
    push(what, std::move(after));
}

long Document::free_tool_number() const {
    return facetmill::free_tool_number(project_.tools);
}

void Document::set_part(std::shared_ptr<const PreparedPart> part, const std::string& key) {
    let_go(std::exchange(part_, std::move(part)));
    part_key_ = key;
    emit part_changed();
    emit states_changed();
}

OperationState Document::state(std::size_t i) const {
    if (is_off(i)) return OperationState::off;
    const auto it = records_.find(ids()[i]);
    if (it == records_.end()) return OperationState::not_planned;
    const Record& record = it->second;
    if (record.planning) return OperationState::planning;
    if (!record.result && record.failure.isEmpty()) return OperationState::not_planned;
    const bool current = record.fingerprint == fingerprint(project_, i);
    if (!record.failure.isEmpty()) return current ? OperationState::failed : OperationState::not_planned;
    return current ? OperationState::planned : OperationState::stale;
}

bool Document::all_planned(std::optional<std::size_t> up_to) const {
    bool any = false;
    for (std::size_t i = 0; i < operation_count() && i <= up_to.value_or(i); ++i) {
        const OperationState now = state(i);
        if (now != OperationState::planned && now != OperationState::off) return false;
        any = any || now == OperationState::planned;
    }
    return any;
}

std::shared_ptr<const OperationResult> Document::result(std::size_t i) const {
    const auto it = records_.find(ids()[i]);
    return it == records_.end() || is_off(i) ? nullptr : it->second.result;
}

std::shared_ptr<const OperationResult> Document::result_of(int id, const std::string& fingerprint) const {
    const auto it = records_.find(id);
    if (it == records_.end() || it->second.planning || it->second.fingerprint != fingerprint) return nullptr;
    return it->second.result;
}

QString Document::failure(std::size_t i) const {
    const auto it = records_.find(ids()[i]);
    return it == records_.end() ? QString() : it->second.failure;
}

void Document::set_planning(const std::vector<int>& ids) {
    for (auto& [id, record] : records_)
        record.planning = false;
    for (const int id : ids)
        records_[id].planning = true;
    emit states_changed();
}

void Document::take(const std::vector<OperationOutcome>& outcomes) {
    let_go(std::exchange(program_, nullptr));
    for (const auto& o : outcomes) {
        Record& record = records_[o.id];
        let_go(std::exchange(
            record.result,
            o.result)); // a failed operation has none: an old path beside a failure would mislead
        record.failure = o.failure;
        record.fingerprint = o.fingerprint;
        record.planning = false;
    }
    emit states_changed();
    emit modified_changed();
}

void Document::show_program(std::shared_ptr<const OpenedProgram> program) {
    if (program == program_) return;
    program_ = std::move(program);
    emit states_changed();
}

std::shared_ptr<const PlanResult> Document::complete_plan(std::optional<std::size_t> only) const {
    if (!part_is_current() || !has_stock()) return nullptr;
    if (only ? state(*only) != OperationState::planned : !all_planned()) return nullptr;
    auto plan = std::make_shared<PlanResult>();
    plan->part = part_;
    plan->stock = stock_solid(project_.stock, *part_);
    plan->stock_warnings = stock_warnings(project_.stock, *part_, project_.unit);
    for (std::size_t i = 0; i < operation_count(); ++i) {
        if (only && *only != i) continue;
        if (const auto planned = result(i))
            for (auto& program : programs_of(planned))
                plan->operations.push_back(std::move(program));
    }
    return plan;
}

} // namespace facetmill::ui
