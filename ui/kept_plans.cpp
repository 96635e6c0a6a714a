#include "ui/kept_plans.h"

#include "core/base/file.h"
#include "core/job/kept_result.h"
#include "ui/document_keys.h"
#include "ui/text.h"
#include "ui/verification_controller.h"
#include "ui/verification_run.h"
#include "ui/worded.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QStandardPaths>

#include <algorithm>
#include <cstring>
#include <functional>
#include <set>

namespace facetmill::ui {

namespace fs = std::filesystem;

namespace {

constexpr const char *plan_kind = "plan", *failure_kind = "failure", *verdict_kind = "verdict",
                     *rest_kind = "rest";

/// Tells one that is in memory from another.
std::size_t identity_of(const void* known) {
    return std::hash<const void*>()(known);
}

/// The key of this user, made where there is none. Throws Error.
HashKey user_key() {
    const fs::path folder =
        path_of(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/kept"));
    const fs::path file = folder / "key";
    HashKey key;
    try {
        const InputFile known(file);
        if (known.bytes().size() == sizeof key.words) {
            std::memcpy(key.words.data(), known.bytes().data(), sizeof key.words);
            return key;
        }
    } catch (const Error&) {
        // There is none yet.
    }
    std::error_code ec;
    fs::create_directories(folder, ec);
    fs::permissions(folder, fs::perms::owner_all, ec); // before there is something to see
    for (std::uint64_t& word : key.words)
        word = QRandomGenerator::system()->generate64();
    OutputFile out(file);
    out.write({reinterpret_cast<const char*>(key.words.data()), sizeof key.words});
    out.commit();
    return key;
}

/// Another text for another build: what an older one planned may be wrong by what a newer one knows.
std::string program_text() {
    const QFileInfo program(QCoreApplication::applicationFilePath());
    return utf8(QStringLiteral("%1 %2 %3")
                    .arg(QCoreApplication::applicationVersion())
                    .arg(program.size())
                    .arg(program.lastModified().toMSecsSinceEpoch()));
}

/// Every operation of every setup: the view on the setup, and the place in it.
template <class Body>
void for_each_operation(const Project& project, const Body& body) {
    for (std::size_t k = 0; k < setup_count(project); ++k) {
        const Project view = view_of_setup(project, k);
        for (std::size_t i = 0; i < view.operations.size(); ++i)
            body(view, k, i);
    }
}

} // namespace

std::string FileContents::text(const fs::path& path, const Progress& progress) {
    const std::string stamp = file_stamp(path);
    {
        const std::lock_guard lock(mutex_);
        if (const auto it = known_.find(stamp); it != known_.end()) return it->second;
    }
    std::string text = content_text(path, key_, progress);
    if (file_stamp(path) != stamp)
        throw Error(ErrorCode::unreadable, path.string(), "it was written meanwhile", "try again");
    const std::lock_guard lock(mutex_);
    return known_[stamp] = std::move(text);
}

struct KeptPlans::Entry {
    std::size_t setup = 0, operation = 0;
    std::shared_ptr<const OperationResult> result; ///< null: planning came to none
    std::string failure;                           ///< why, then
    std::string fingerprint;                       ///< as planned
};

struct KeptPlans::Writing {
    KeptFolder folder;
    Project project;
    std::vector<Entry> entries;
    std::map<std::size_t, std::shared_ptr<const PreparedPart>> parts;  ///< by setup
    std::map<std::size_t, std::shared_ptr<const CarriedStock>> stocks; ///< with which setups begin
    std::shared_ptr<const VerificationOutcome> verdict;                ///< of the shown setup
    bool saved = false; ///< the project is on disk as it is: what is of no use to it goes
    // What became of it.
    std::size_t written = 0;
    bool too_much = false;
    QString failure;

    void run(FileContents& contents, const Progress& progress);

private:
    void write(const std::string& name, const std::function<std::string()>& bytes, const Progress& progress);
    std::set<std::string> names(const FileText& texts) const;
};

void KeptPlans::Writing::write(const std::string& name, const std::function<std::string()>& bytes,
                               const Progress& progress) {
    if (folder.has(name)) return;
    if (folder.write(name, bytes(), progress))
        ++written;
    else
        too_much = true;
}

/// Of all that the project could have kept.
std::set<std::string> KeptPlans::Writing::names(const FileText& texts) const {
    std::set<std::string> all;
    for_each_operation(project, [&](const Project& view, std::size_t, std::size_t i) {
        all.insert(folder.name_of(plan_kind, ui::fingerprint(view, i, texts)));
        all.insert(folder.name_of(failure_kind, ui::fingerprint(view, i, texts)));
        all.insert(folder.name_of(verdict_kind, verdict_source(view, i + 1, texts)));
        if (i == 0) all.insert(folder.name_of(rest_kind, stock_source(view, texts)));
    });
    return all;
}

void KeptPlans::Writing::run(FileContents& contents, const Progress& progress) {
    try {
        const FileText texts = contents.texts(progress);
        if (saved && !folder.empty()) folder.keep_only(names(texts));
        for (const Entry& e : entries) {
            const Project view = view_of_setup(project, e.setup);
            // What its files are now is what they were then.
            if (ui::fingerprint(view, e.operation) != e.fingerprint) continue;
            if (!e.result) {
                const std::string name =
                    folder.name_of(failure_kind, ui::fingerprint(view, e.operation, texts));
                if (!folder.has(name))
                    folder.write(name, e.failure, progress); // a few words: not worth telling
                continue;
            }
            write(
                folder.name_of(plan_kind, ui::fingerprint(view, e.operation, texts)),
                [&] { return result_bytes(*e.result, *parts.at(e.setup), progress); }, progress);
        }
        for (const auto& [setup, stock] : stocks) {
            const Project view = view_of_setup(project, setup);
            if (stock->source != stock_source(view)) continue;
            write(
                folder.name_of(rest_kind, stock_source(view, texts)),
                [&, s = stock] { return carried_bytes(*s, progress); }, progress);
        }
        if (verdict)
            write(
                folder.name_of(verdict_kind,
                               verdict_source(project, verdict->setups.front().ids.size(), texts)),
                [&] {
                    return verdict_bytes({verdict->posted_blocks, verdict->verification}, progress);
                },
                progress);
    } catch (const Error& e) {
        failure = worded(e);
    } catch (const Cancelled&) {
        return; // nobody can
    }
}

KeptPlans::KeptPlans(Document& document, std::shared_ptr<Planner> planner,
                     std::shared_ptr<SetupPlanners> planners, BackgroundJob& job,
                     VerificationController& verification, QObject* window)
    : Controller(window), document_(document), planner_(std::move(planner)), planners_(std::move(planners)),
      job_(job), verification_(verification) {
    try {
        key_ = user_key();
        contents_ = std::make_shared<FileContents>(*key_);
    } catch (const Error&) {
        key_.reset(); // then plans are made again, as without what is kept
    }
    timer_.setSingleShot(true);
    timer_.setInterval(0);
    connect(&timer_, &QTimer::timeout, this, &KeptPlans::keep);
    connect(&verification_.model(), &VerificationModel::changed, this, &KeptPlans::keep_soon);
    // What a job of the window works on is looked at when it is through.
    connect(&job_, &BackgroundJob::ended, this, [this] {
        part_changed();
        if (due_) timer_.start();
    });
}

KeptPlans::~KeptPlans() {
    if (thread_.joinable()) thread_.join();
    if (!due_ || job_.running()) return;
    if (const auto writing = collect()) writing->run(*contents_, {});
}

std::optional<KeptFolder> KeptPlans::folder() const {
    if (!key_ || document_.project().path.empty()) return std::nullopt;
    return KeptFolder(document_.project().path, *key_, program_text());
}

void KeptPlans::keep_soon() {
    // What is kept may be wanted still: nothing of it goes before.
    if (wanted_ || !key_ || document_.project().path.empty() || !document_.has_part()) return;
    due_ = true;
    timer_.start();
}

std::shared_ptr<KeptPlans::Writing> KeptPlans::collect() {
    auto writing = std::make_shared<Writing>(Writing{.folder = *folder(), .project = document_.project()});
    writing->saved = !document_.modified();
    const std::size_t shown = chosen_setup(writing->project);
    std::vector<std::size_t> now{writing->saved ? std::size_t(1) : 0};
    for_each_operation(writing->project, [&](const Project& view, std::size_t k, std::size_t i) {
        const std::string fingerprint = Document::fingerprint(view, i);
        auto result = document_.result_of(document_.setup_ids()[k][i], fingerprint);
        const auto part = k == shown ? document_.part() : planners_->at(k).prepared();
        if (!result && k == shown && document_.state(i) == OperationState::failed) {
            std::string failure = utf8(document_.failure(i));
            now.push_back(std::hash<std::string>()(failure + fingerprint));
            writing->entries.push_back({k, i, nullptr, std::move(failure), fingerprint});
        }
        if (!result || !part) return;
        now.push_back(identity_of(result.get()));
        writing->parts[k] = part;
        writing->entries.push_back({k, i, std::move(result), {}, fingerprint});
    });
    for (std::size_t k = 0; k < setup_count(writing->project); ++k)
        if (const auto stock = planners_->known_rest(view_of_setup(writing->project, k))) {
            now.push_back(identity_of(stock.get()));
            writing->stocks[k] = stock;
        }
    const VerificationModel& model = verification_.model();
    if (model.current() && !model.outcome().program && model.outcome().setups.size() == 1
        && model.outcome().setups.front().place == shown) {
        writing->verdict = model.outcome_shared();
        now.push_back(identity_of(writing->verdict.get()));
    }
    const std::string path = writing->folder.path().string();
    if (now == last_ && path == last_path_) return nullptr;
    last_ = std::move(now);
    last_path_ = path;
    return writing;
}

void KeptPlans::keep() {
    if (!due_ || writing_ || job_.running()) return; // when that is through
    due_ = false;
    const auto writing = folder() ? collect() : nullptr;
    if (!writing) {
        emit settled();
        return;
    }
    writing_ = true;
    if (thread_.joinable()) thread_.join();
    thread_ = std::thread([this, writing, contents = contents_] {
        writing->run(*contents, {});
        QMetaObject::invokeMethod(
            this, [this, writing] { end_writing(*writing); }, Qt::QueuedConnection);
    });
}

void KeptPlans::end_writing(const Writing& written) {
    writing_ = false;
    const QString where = path_text(written.folder.path());
    const double mb = double(written.folder.size()) / 1e6;
    if (!written.failure.isEmpty() && !written.entries.empty())
        emit said(MessageBar::Kind::warning,
                  tr("What was planned is not kept with the project: %1.").arg(written.failure), false);
    else if (written.too_much)
        emit said(MessageBar::Kind::warning,
                  tr("Not all that was planned is kept with the project: it would be more than %1 MB. It is "
                     "planned again when the project is opened.")
                      .arg(count_text(KeptFolder::largest_total / 1'000'000)),
                  false);
    else if (written.written > 0)
        emit said(MessageBar::Kind::information,
                  tr("Kept with the project what was planned and verified: %1 MB in %2.")
                      .arg(QLocale().toString(mb, 'f', 1), where),
                  false);
    if (due_) timer_.start();
    emit settled();
}

void KeptPlans::project_opened() {
    due_ = starting_ = false;
    last_.clear();
    const auto kept = folder();
    wanted_ = kept && !kept->empty();
}

void KeptPlans::part_changed() {
    if (!wanted_ || starting_ || !document_.part_is_current()) return;
    starting_ = true;
    // Behind what the part does elsewhere.
    QTimer::singleShot(0, this, [this] {
        if (!std::exchange(starting_, false) || !wanted_ || job_.running()) return;
        take_up();
    });
}

struct KeptPlans::Reading {
    struct Verdict {
        std::size_t operations = 0; ///< so many of the shown setup's were judged
        KeptVerdict kept;
        DeviationDisplayPtr display;
    };
    KeptFolder folder;
    Project project;
    std::vector<std::vector<int>> ids;
    std::shared_ptr<const PreparedPart> part; ///< of the shown setup
    std::vector<OperationOutcome> outcomes;
    std::optional<Verdict> verdict;
    QStringList damaged; ///< names of operations

    void run(Planner& planner, SetupPlanners& planners, FileContents& contents, const Progress& progress);

private:
    void read_setup(std::size_t setup, Planner& planner, Planner* shown, const FileText& texts,
                    const Progress& progress);
    void read_verdict(const FileText& texts, const Progress& progress);
};

void KeptPlans::Reading::read_setup(std::size_t setup, Planner& planner, Planner* shown,
                                    const FileText& texts, const Progress& progress) {
    const Project view = view_of_setup(project, setup);
    if (const std::string source = stock_source(view); !source.empty())
        if (const auto bytes = folder.read(folder.name_of(rest_kind, stock_source(view, texts)), progress)) {
            const auto stock = carried_from_bytes(*bytes, progress);
            stock->source = source;
            planner.carry(stock);
        }
    std::shared_ptr<const PreparedPart> own = shown ? part : nullptr;
    const auto n = double(view.operations.size());
    for (std::size_t i = 0; i < view.operations.size(); ++i) {
        const Progress reading = progress.part(double(i) / n, double(i + 1) / n);
        const std::string fingerprint = ui::fingerprint(view, i);
        const std::string name = folder.name_of(plan_kind, ui::fingerprint(view, i, texts));
        if (!folder.has(name)) {
            const auto failure =
                folder.read(folder.name_of(failure_kind, ui::fingerprint(view, i, texts)), reading);
            if (failure) outcomes.push_back({ids[setup][i], nullptr, ui::text(*failure), fingerprint});
            continue;
        }
        if (!own) {
            try {
                own = planner.prepare(view, reading.part(0, 0.1));
            } catch (const Error&) {
                return; // what it begins with is not known: it is planned again
            }
        }
        try {
            const auto bytes = folder.read(name, reading.part(0.1, 0.5));
            if (!bytes) throw Error(ErrorCode::syntax, name, "it is not as it was written", "plan again");
            const auto result = result_from_bytes(*bytes, view, i, *own, reading.part(0.5, 1));
            planner.adopt(result);
            if (shown) shown->adopt(result);
            outcomes.push_back({ids[setup][i], result, {}, fingerprint});
        } catch (const Error&) {
            damaged << ui::text(view.operations[i]->common().name);
        }
    }
}

void KeptPlans::Reading::read_verdict(const FileText& texts, const Progress& progress) {
    const Project& shown = project;
    for (std::size_t n = shown.operations.size(); n > 0; --n) {
        const auto bytes =
            folder.read(folder.name_of(verdict_kind, verdict_source(shown, n, texts)), progress.part(0, 0.3));
        if (!bytes) continue;
        Verdict found{n, verdict_from_bytes(*bytes, progress.part(0.3, 0.5)), nullptr};
        const Verification& v = *found.kept.verification;
        found.display = prepare_deviation_display(v.surface, default_scale(v, shown.unit),
                                                  progress.part(0.5, 1, "Preparing the view"));
        verdict = std::move(found);
        return;
    }
}

void KeptPlans::Reading::run(Planner& planner, SetupPlanners& planners, FileContents& contents,
                             const Progress& progress) {
    const FileText texts = contents.texts(progress);
    const auto n = double(setup_count(project));
    const std::size_t shown = chosen_setup(project);
    for (std::size_t k = 0; k < setup_count(project); ++k)
        read_setup(k, planners.at(k), k == shown ? &planner : nullptr, texts,
                   progress.part(0.7 * double(k) / n, 0.7 * double(k + 1) / n));
    if (!outcomes.empty()) read_verdict(texts, progress.part(0.7, 1));
}

void KeptPlans::take_up() {
    wanted_ = false;
    auto reading = std::make_shared<Reading>(Reading{.folder = *folder(), .project = document_.project()});
    reading->ids = document_.setup_ids();
    reading->part = document_.part();
    job_.start(
        tr("Reading what was planned"),
        [reading, planner = planner_, planners = planners_, contents = contents_](const Progress& progress) {
            try {
                reading->run(*planner, *planners, *contents, progress);
            } catch (const Error&) {
                reading->verdict.reset(); // whatever it is, it can be planned again
            }
        },
        [this, reading](const JobEnd& end) { taken(*reading, end); });
}

void KeptPlans::taken(Reading& reading, const JobEnd& end) {
    if (!end.done() || document_.program() || document_.setup_ids() != reading.ids) return;
    if (!reading.damaged.isEmpty())
        emit said(MessageBar::Kind::information,
                  tr("What was kept of %1 is damaged, and is not used: plan again.")
                      .arg(reading.damaged.join(QStringLiteral(", "))),
                  false);
    // What was planned meanwhile is newer.
    std::erase_if(reading.outcomes, [&](const OperationOutcome& o) {
        const auto i = document_.index_of(o.id);
        return i && document_.state(*i) != OperationState::not_planned;
    });
    if (reading.outcomes.empty()) return;
    document_.take(reading.outcomes);
    const auto planned = std::count_if(reading.outcomes.begin(), reading.outcomes.end(),
                                       [](const OperationOutcome& o) { return o.result != nullptr; });
    if (planned > 0)
        emit said(
            MessageBar::Kind::information,
            planned == 1
                ? tr("One operation is as it was planned: it was kept with the project.")
                : tr("%1 operations are as they were planned: they were kept with the project.").arg(planned),
            false);
    emit taken_up();
    if (!reading.verdict || !document_.part_is_current()) return;
    std::optional<std::size_t> up_to;
    if (reading.verdict->operations < document_.operation_count()) up_to = reading.verdict->operations - 1;
    if (!can_judge(document_, up_to)) return;
    const auto plan = plan_as_it_stands(document_, up_to);
    const auto outcome = outcome_to_be(document_, *plan, up_to);
    outcome->posted_blocks = reading.verdict->kept.posted_blocks;
    outcome->across = plan->part->box.diagonal();
    outcome->verification = reading.verdict->kept.verification;
    outcome->setups.front().display = reading.verdict->display;
    verification_.model().take(outcome);
    emit verification_.verified();
}

} // namespace facetmill::ui
