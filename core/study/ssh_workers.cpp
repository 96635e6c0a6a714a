#include "core/study/ssh_workers.h"

#include "core/base/child_process.h"
#include "core/base/text.h"
#include "core/study/slurm.h"

#include <filesystem>
#include <vector>

namespace facetmill {

namespace {

std::vector<std::string> ssh_words(const std::string& host, const std::string& command) {
    return {"-o", "BatchMode=yes", "-o", "ConnectTimeout=20", host, command};
}

bool host_answers(const std::filesystem::path& ssh, const std::string& host) {
    const MemoryFile nothing("facetmill-study");
    return ChildProcess(ssh, ssh_words(host, "true"), nothing, nothing).wait() == 0;
}

} // namespace

StudyWorkers workers_by_ssh(const StudyWorkers& own, const std::string& host, const std::string& program) {
    const std::string where = "ssh:" + printable(host, 200);
    // What begins with a dash would be an option of ssh.
    if (host.empty() || host[0] == '-')
        throw Error(ErrorCode::usage, where, "'" + printable(host) + "' is no host",
                    "give ssh:HOST, the host as ssh knows it");
    StudyWorkers workers = own;
    const std::string there = program.empty() ? own.program.string() : program;
    workers.program = program_on_path("ssh");
    if (workers.program.empty())
        throw Error(ErrorCode::not_found, "ssh", "there is no such program",
                    "install it (Debian: openssh-client), or let this machine do the work");
    workers.arguments = [=, words = own.arguments](const StudyWork& w) {
        std::string command = "exec " + shell_word(there);
        for (const std::string& word : words(w))
            command += " " + shell_word(word);
        return ssh_words(host, command);
    };
    workers.judge_status = [=, ssh = workers.program](int status) {
        constexpr int no_connection = 255, no_program = 127, no_right = 126;
        if (status == no_connection && host_answers(ssh, host))
            return true; // its status where a signal ended it
        if (status == no_connection)
            throw Error(ErrorCode::not_found, where, "the host cannot be reached without a password",
                        "see what ssh says to it");
        if (status == no_program || status == no_right)
            throw Error(ErrorCode::not_found, where, "there is no program " + printable(there, 200),
                        "install the same one there, or name it: --remote-program");
        return false;
    };
    return workers;
}

} // namespace facetmill
