#include "ui/kept_plans.h"

#include "core/base/file.h"
#include "core/base/parallel.h"
#include "ui/kept_reading.h"
#include "ui/text.h"
#include "ui/verification_controller.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QStandardPaths>

#include <algorithm>
#include <cstring>
#include <functional>

namespace facetmill::ui {

namespace fs = std::filesystem;

namespace {

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

} // namespace

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

void KeptPlans::collect_plans(KeptWriting& writing, std::vector<std::size_t>& now) const {
    const std::size_t shown = chosen_setup(writing.project);
    for (std::size_t k = 0; k < setup_count(writing.project); ++k) {
        const Project view = view_of_setup(writing.project, k);
        const auto part = k == shown ? document_.part() : planners_->at(k).prepared();
        for (std::size_t i = 0; i < view.operations.size(); ++i) {
            std::string fingerprint = Document::fingerprint(view, i), failure;
            auto result = document_.result_of(document_.setup_ids()[k][i], fingerprint);
            if (!result && k == shown) {
                const OperationState state = document_.state(i);
                if (state == OperationState::failed) failure = utf8(document_.failure(i));
                if (state == OperationState::stale) result = document_.result(i);
                // Of which values it was is not said by the file's name.
                if (result) now.push_back(std::hash<std::string>()(std::exchange(fingerprint, {})));
            }
            if (!failure.empty()) now.push_back(std::hash<std::string>()(failure + fingerprint));
            if (result && part) {
                now.push_back(identity_of(result.get()));
                writing.parts[k] = part;
            }
            if (!failure.empty() || (result && part))
                writing.plans.push_back({k, i, result, std::move(failure), fingerprint, file_of(result)});
        }
        if (auto stock = planners_->known_rest(view)) {
            now.push_back(identity_of(stock.get()));
            writing.stocks[k] = std::move(stock);
        }
    }
}

void KeptPlans::collect_verdict(KeptWriting& writing, std::vector<std::size_t>& now) const {
    const VerificationModel& model = verification_.model();
    if (!model.any() || model.outcome().program) return;
    if (model.current())
        writing.verdict = model.outcome_shared();
    else if (model.outcome().setups.size() == 1 && model.shown_setup())
        writing.stale_verdict = model.outcome_shared();
    else
        return;
    writing.stale_verdict_as = file_of(model.outcome().verification);
    writing.ids = document_.setup_ids()[chosen_setup(writing.project)];
    now.push_back(identity_of(model.outcome_shared().get()) + (model.current() ? 1 : 0));
}

std::shared_ptr<KeptWriting> KeptPlans::collect() {
    auto writing =
        std::make_shared<KeptWriting>(KeptWriting{.folder = *folder(), .project = document_.project()});
    writing->saved = !document_.modified();
    std::vector<std::size_t> now{writing->saved ? std::size_t(1) : 0};
    collect_plans(*writing, now);
    collect_verdict(*writing, now);
    const std::string path = writing->folder.path().string();
    if (now == last_ && path == last_path_) return nullptr;
    last_ = std::move(now);
    last_path_ = path;
    return writing;
}

void KeptPlans::remember(const KeptAs& kept_as) {
    std::erase_if(kept_as_, [](const auto& known) { return known.first.expired(); });
    for (const auto& [what, name] : kept_as)
        kept_as_.emplace_back(what, name);
}

std::string KeptPlans::file_of(const std::shared_ptr<const void>& what) const {
    for (const auto& [known, name] : kept_as_)
        if (what && known.lock() == what) return name;
    return {};
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
        lower_thread_priority();
        writing->run(*contents, {});
        QMetaObject::invokeMethod(
            this, [this, writing] { end_writing(*writing); }, Qt::QueuedConnection);
    });
}

void KeptPlans::end_writing(const KeptWriting& written) {
    writing_ = false;
    remember(written.kept_as);
    const QString where = path_text(written.folder.path());
    const double mb = double(written.folder.size()) / 1e6;
    if (!written.failed.isEmpty() && !written.plans.empty())
        emit said(MessageBar::Kind::warning,
                  tr("What was planned is not kept with the project: %1.").arg(written.failed), false);
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

void KeptPlans::take_up() {
    wanted_ = false;
    auto reading =
        std::make_shared<KeptReading>(KeptReading{.folder = *folder(), .project = document_.project()});
    reading->ids = document_.setup_ids();
    reading->part = document_.part();
    job_.start(
        tr("Reading what was planned"),
        [reading, planner = planner_, planners = planners_, contents = contents_](const Progress& progress) {
            try {
                reading->run(*planner, *planners, *contents, progress);
            } catch (const Error&) {
                reading->verdicts.clear(); // whatever it is, it can be planned again
            }
        },
        [this, reading](const JobEnd& end) { taken(*reading, end); });
}

void KeptPlans::taken(KeptReading& reading, const JobEnd& end) {
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
    remember(reading.kept_as);
    document_.take(reading.outcomes);
    const auto planned =
        std::count_if(reading.outcomes.begin(), reading.outcomes.end(), [](const OperationOutcome& o) {
            return o.result && o.fingerprint != KeptReading::other_values;
        });
    if (planned > 0)
        emit said(
            MessageBar::Kind::information,
            planned == 1
                ? tr("One operation is as it was planned: it was kept with the project.")
                : tr("%1 operations are as they were planned: they were kept with the project.").arg(planned),
            false);
    emit taken_up();
    if (!document_.part_is_current()) return;
    for (const auto& verdict : reading.verdicts)
        verification_.model().take(verdict);
    if (verification_.model().current()) emit verification_.verified();
}

} // namespace facetmill::ui
