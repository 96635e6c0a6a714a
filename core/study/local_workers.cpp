#include "core/study/local_workers.h"

#include "core/base/child_process.h"
#include "core/base/strict_json.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <deque>
#include <memory>
#include <optional>
#include <thread>

namespace facetmill {

namespace {

constexpr int max_ended = 5, max_crashed = 2;
constexpr auto worker_poll = std::chrono::milliseconds(5);

/// The error in what a worker has printed; nothing where there is none.
std::optional<Error> worker_error(const std::string& said) {
    try {
        const Json line = parse_strict_json(said, "worker");
        const Json& e = line.at("error");
        for (const ErrorCode code : {ErrorCode::unwritable, ErrorCode::newer_version, ErrorCode::not_found,
                                     ErrorCode::unreadable, ErrorCode::out_of_range})
            if (code_name(code) == e.at("code").get<std::string>())
                return Error(code, e.at("where").get<std::string>(), e.at("what").get<std::string>(),
                             e.at("remedy").get<std::string>());
        return Error(ErrorCode::internal, e.at("where").get<std::string>(), e.at("what").get<std::string>(),
                     e.at("remedy").get<std::string>());
    } catch (const Error&) {
        return std::nullopt;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

/// Ended by somebody or by the system, not by what it did itself.
bool ended_from_without(int status) {
    return status == -SIGKILL || status == -SIGTERM || status == -SIGINT || status == -SIGHUP;
}

class Pool {
public:
    Pool(const StudyWorkers& workers, const std::vector<StudyWork>& work)
        : workers_(workers), nothing_("facetmill-study"), count_(work.size()) {
        for (const StudyWork& w : work)
            waiting_.push_back({w, 0, 0});
    }

    std::map<std::string, std::string> run(const Progress& progress) {
        while (!waiting_.empty() || !running_.empty()) {
            while (!waiting_.empty() && running_.size() < workers_.count)
                start();
            progress.set(double(done_) / double(count_));
            if (!collect()) std::this_thread::sleep_for(worker_poll);
        }
        return lost_;
    }

private:
    struct Asked {
        StudyWork work;
        int ended = 0, crashed = 0;
    };
    struct Running {
        Asked asked;
        std::unique_ptr<ChildProcess> process;
        std::string said;
    };

    void start() {
        Asked asked = waiting_.front();
        waiting_.pop_front();
        auto process = std::make_unique<ChildProcess>(workers_.program, workers_.arguments(asked.work),
                                                      nothing_, nothing_);
        running_.push_back({std::move(asked), std::move(process), {}});
    }

    /// True where one has ended.
    bool collect() {
        for (std::size_t i = 0; i < running_.size(); ++i) {
            if (running_[i].process->read(running_[i].said, 0)) continue;
            Running ended = std::move(running_[i]);
            running_.erase(running_.begin() + std::ptrdiff_t(i));
            judge(std::move(ended));
            return true;
        }
        return false;
    }

    void judge(Running ended) {
        const int status = ended.process->wait();
        if (status == 0) return end(ended.asked);
        if (const auto error = worker_error(ended.said)) {
            if (error->code() != ErrorCode::internal) throw Error(*error);
            return lose(ended.asked, error->what());
        }
        const bool from_without =
            ended_from_without(status) || (workers_.judge_status && workers_.judge_status(status));
        int& times = from_without ? ended.asked.ended : ended.asked.crashed;
        const int most = from_without ? max_ended : max_crashed;
        if (++times < most) return waiting_.push_back(std::move(ended.asked));
        lose(ended.asked, status < 0 ? "its worker was ended by signal " + std::to_string(-status)
                                     : "its worker ended with status " + std::to_string(status));
    }

    void lose(const Asked& asked, const std::string& why) {
        lost_[asked.work.key] = why;
        end(asked);
    }

    void end(const Asked& asked) {
        ++done_;
        if (workers_.ended) workers_.ended(asked.work);
    }

    const StudyWorkers& workers_;
    MemoryFile nothing_;
    std::size_t count_, done_ = 0;
    std::deque<Asked> waiting_;
    std::vector<Running> running_;
    std::map<std::string, std::string> lost_;
};

} // namespace

std::string worker_error_line(const Error& error) {
    return Json{{"error",
                 {{"code", std::string(code_name(error.code()))},
                  {"where", printable(error.where(), 400)},
                  {"what", printable(error.message(), 2000)},
                  {"remedy", printable(error.remedy(), 400)}}}}
               .dump()
           + "\n";
}

StudyWorkers own_workers(const StudyFolder& folder, const std::filesystem::path& program, std::size_t count,
                         std::size_t threads) {
    StudyWorkers workers;
    workers.count = count;
    workers.program = program;
    const std::string place = std::filesystem::absolute(folder.path()).string();
    workers.arguments = [=](const StudyWork& w) {
        return std::vector<std::string>{"study",
                                        "work",
                                        place,
                                        "--candidate",
                                        w.key,
                                        "--rung",
                                        std::string(rung_name(w.rung)),
                                        "--threads",
                                        std::to_string(threads),
                                        "--ends-with-parent"};
    };
    return workers;
}

StudyEngine work_by_processes(const StudyWorkers& workers) {
    return [workers](const StudyFolder&, const std::vector<StudyWork>& work, const Progress& progress) {
        return Pool(workers, work).run(progress);
    };
}

} // namespace facetmill
