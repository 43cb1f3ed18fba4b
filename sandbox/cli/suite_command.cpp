// suite: draws and measures many states in one run, compares them with references, and writes a report to look at. The
// code in suite/ defines and judges the entries; this file contains only the command.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <system_error>

#include "cli/commands.h"
#include "cli/headless.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/output.h"
#include "platform/child_process.h"
#include "platform/ending_signals.h"
#include "platform/file.h"
#include "suite/report.h"
#include "suite/suite_run.h"
#include "suite/worker.h"
#include "text/hash.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

using Clock = std::chrono::steady_clock;

/// The options as typed; the first word is the action.
struct TypedSuite {
    std::vector<std::string> words, only;
    std::optional<std::string> jobs, shard, times, entry_timeout, device;
    bool accept_new = false, cache = false, github = false, allow_outside = false;
};

struct Shard {
    int index = 1, of = 1;
};

void declare(Options& options, TypedSuite& typed) {
    options.group("What to do");
    options.positionals("run|accept|merge", typed.words,
                        "run SUITE…: draws, compares, and writes SUITE's report; accept SUITE [NAME…]: makes the "
                        "results of the last run the references, for these entries or all that are different; merge "
                        "SUITE REPORT…: merges the reports of shards. SUITE is a .json file, or a folder of states");
    options.group("For run");
    options.texts("--only", "NAME", typed.only,
                  "Runs only this entry; repeatable. The report keeps its results of the others");
    options.flag("--accept-new", typed.accept_new, "Entries without a reference do not cause exit status 1");
    options.text("--jobs", "N", typed.jobs, "Number of processes that draw, 1 to 256; default 1");
    options.text("--entry-timeout", "S", typed.entry_timeout,
                 "Fails an entry that takes longer than S seconds; default 60");
    options.flag(
        "--cache", typed.cache,
        "Does not redraw entries that passed if their state, scene, references, program and driver are unchanged");
    options.text("--shard", "I/N", typed.shard, "Runs the I-th of N parts, with its own report (merge joins them)");
    options.text(
        "--times", "REPORT", typed.times,
        "Folder of an earlier report, whose times balance the shards; default: equally many entries in each shard");
    options.flag("--github", typed.github, "Also prints entries that did not pass as GitHub annotations");
    add_device_option(options, typed.device);
    options.flag("--allow-outside", typed.allow_outside,
                 "Lets states name scenes and meshes outside their own folder and the program's");
}

// ---- run -----------------------------------------------------------------------------------------------------------

Shard shard_option(const Options& options, const std::optional<std::string>& text) {
    if (!text) return {};
    const std::size_t slash = text->find('/');
    if (slash == std::string::npos) options.refuse("--shard: must be I/N, the I-th of N parts, such as 2/5");
    constexpr int most = 10'000;
    Shard shard;
    shard.of = whole_option(options, "--shard", text->substr(slash + 1), 1, most);
    shard.index = whole_option(options, "--shard", text->substr(0, slash), 1, shard.of);
    return shard;
}

std::map<std::string, double> times_of(const std::optional<std::string>& folder) {
    std::map<std::string, double> seconds;
    if (!folder) return seconds;
    const RunResult earlier = value_or_end(read_run(*folder));
    for (const EntryResult& entry : earlier.entries)
        if (!entry.is_kept && entry.outcome != Outcome::not_drawn) seconds[entry.name] = entry.seconds;
    return seconds;
}

std::vector<std::size_t> chosen_of(const Suite& suite, const TypedSuite& typed, const Shard& shard) {
    std::vector<std::string> known;
    for (const SuiteEntry& entry : suite.entries) known.push_back(entry.name);
    for (const std::string& name : typed.only)
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw Failure(ExitStatus::bad_input,
                          "--only " + one_line(name) + ": the suite has no such entry" + suggestion(name, known));
    std::vector<std::size_t> chosen = entries_of_shard(suite, shard.index, shard.of, times_of(typed.times));
    if (!typed.only.empty())
        std::erase_if(chosen, [&](std::size_t entry) {
            return std::find(typed.only.begin(), typed.only.end(), known[entry]) == typed.only.end();
        });
    return chosen;
}

std::map<std::string, std::string> known_keys(const Suite& suite) {
    std::map<std::string, std::string> keys;
    if (const Result<RunResult> earlier = last_run(suite))
        for (const EntryResult& entry : earlier->entries)
            if ((entry.outcome == Outcome::passed || entry.outcome == Outcome::not_drawn) && !entry.key.empty())
                keys[entry.name] = entry.key;
    return keys;
}

std::vector<std::string> worker_of(const Suite& suite, const TypedSuite& typed) {
    if (own_program().empty())
        throw Failure(ExitStatus::internal_error,
                      "cannot find the file of this program, which a suite starts again: /proc is missing");
    std::vector<std::string> words{own_program(), "suite", "worker", suite.argument.string()};
    if (typed.device) words.insert(words.end(), {"--device", *typed.device});
    if (typed.allow_outside) words.emplace_back("--allow-outside");
    if (typed.cache) words.emplace_back("--cache");
    return words;
}

/// Returns, for example, "64/s, 2 min 20 s left".
std::string pace(std::size_t done, std::size_t of, double seconds) {
    if (seconds <= 0.0 || done == 0) return "";
    const double rate = static_cast<double>(done) / seconds;
    const auto left_s = static_cast<int>(static_cast<double>(of - done) / rate + 0.5);
    const std::string left = left_s < 60 ? std::to_string(left_s) + " s"
                                         : std::to_string(left_s / 60) + " min " + std::to_string(left_s % 60) + " s";
    return figures(rate) + "/s, " + left + " left";
}

/// Prints the progress: on a terminal, on one line that is redrawn; elsewhere, if there are more than 20 entries, on a
/// new line after each tenth of them. Each entry that did not pass also gets a line.
class Progress {
public:
    Progress(std::size_t of, std::size_t kept_for_shown) : of_(of), step_(std::max<std::size_t>(kept_for_shown, 1)) {}

    void tell(const EntryResult& entry, std::size_t done) {
        const std::string line = grouped_number(static_cast<std::int64_t>(done)) + " of " +
                                 grouped_number(static_cast<std::int64_t>(of_)) + ", " +
                                 pace(done, of_, std::chrono::duration<double>(Clock::now() - begun_).count());
        if (is_terminal_) std::fputs("\r\033[K", stderr);
        if (entry.outcome != Outcome::passed)
            print(std::string(name_of(entry.outcome)) + "  " + one_line(entry.name) + ": " +
                  (entry.reasons.empty() ? "" : one_line(entry.reasons.front())) + "\n");
        if (is_terminal_ && done < of_)
            std::fputs(line.c_str(), stderr);
        else if (!is_terminal_ && of_ > 20 && done % step_ == 0 && done < of_)
            print(line + "\n");
        if (is_terminal_) std::fflush(stderr);
    }

private:
    std::size_t of_, step_;
    Clock::time_point begun_ = Clock::now();
    bool is_terminal_ = ::isatty(STDERR_FILENO) == 1;
};

/// Returns a result in the format of GitHub's workflow commands.
std::string annotation(const Suite& suite, const EntryResult& entry) {
    const auto plain = [](const std::string& text, bool is_property) {
        std::string safe;
        for (const char c : text) {
            const bool is_reserved = c == '%' || c == '\n' || c == '\r' || (is_property && (c == ':' || c == ','));
            safe += is_reserved ? percent_encoded(c) : std::string(1, c);
        }
        return safe;
    };
    return "::" + std::string(entry.outcome == Outcome::fresh ? "warning" : "error") +
           " file=" + plain(one_line(suite.argument.string()), true) +
           ",title=" + plain(one_line(entry.name) + ": " + name_of(entry.outcome), true) +
           "::" + plain(reasons_in_lines(entry), false) + "\n";
}

/// Gives each shard its own report.
Suite with_report_of(Suite suite, const Shard& shard) {
    if (shard.of > 1) suite.report += "-" + std::to_string(shard.index) + "-of-" + std::to_string(shard.of);
    return suite;
}

/// The outcome of running one suite.
struct RunEnd {
    bool is_good = true;
    std::int64_t not_drawn = 0;
    int ended_by = 0;  ///< the signal that ended it early, else 0
};

RunEnd run_one(const Suite& whole, const TypedSuite& typed, const Shard& shard, const RunWish& like) {
    const Suite suite = with_report_of(whole, shard);
    RunWish wish = like;
    wish.chosen = chosen_of(suite, typed, shard);
    wish.worker = worker_of(suite, typed);
    if (shard.of > 1) wish.worker.insert(wish.worker.end(), {"--shard", *typed.shard});
    if (typed.cache) wish.known_keys = known_keys(suite);
    if (!typed.only.empty() && wish.chosen.empty()) return {};  // the entries belong to another shard
    value_or_end(prepare_report(suite));
    Progress progress(wish.chosen.size(), wish.chosen.size() / 10);
    wish.tell = [&](const EntryResult& entry, std::size_t done) { progress.tell(entry, done); };
    const auto begun = Clock::now();
    GatheredResults gathered = run_entries(suite, wish);
    if (gathered.failure) {
        const int status = gathered.failure->exit_status;
        const bool is_known = status > 1 && status <= static_cast<int>(ExitStatus::internal_error);
        std::string why = gathered.failure->complaint;
        while (!why.empty() && why.back() == '\n') why.pop_back();
        throw Failure(is_known ? static_cast<ExitStatus>(status) : ExitStatus::internal_error, why);
    }
    RunResult run{suite.name,
                  suite.argument.string(),
                  VIEWING_SANDBOX_VERSION,
                  gathered.renderer,
                  shard.index,
                  shard.of,
                  std::chrono::duration<double>(Clock::now() - begun).count(),
                  std::move(gathered.entries)};
    value_or_end(write_report(suite.report, typed.only.empty() ? run : with_earlier_results(run, suite)));
    if (typed.github)
        for (const EntryResult& entry : run.entries)
            if (entry.outcome != Outcome::passed && entry.outcome != Outcome::not_drawn)
                print(annotation(suite, entry));
    const std::vector<std::string> strays = stray_references(suite);
    if (!strays.empty())
        print(counted(std::ssize(strays), "reference belongs", "references belong") +
              " to no entry: " + one_line(joined(strays)) + "\n");
    print(one_line(suite.name) + ": " + summary_of(run) + ": " + (suite.report / "index.html").string() + "\n");
    return {run.is_good(typed.accept_new), static_cast<std::int64_t>(run.count(Outcome::not_drawn)), gathered.ended_by};
}

/// Runs one suite after another. A signal or --timeout ends the run early, with reports of the entries drawn so far;
/// then the process ends as the signal or --timeout would have ended it.
ExitStatus run_all(const std::vector<Suite>& suites, const TypedSuite& typed, const Shard& shard, const RunWish& like) {
    RunEnd all;
    {
        const EndingNote note;
        for (const Suite& suite : suites) {
            const RunEnd one = run_one(suite, typed, shard, like);
            all = {all.is_good && one.is_good, all.not_drawn + one.not_drawn, std::max(all.ended_by, one.ended_by)};
        }
    }
    if (all.ended_by == 0) return all.is_good ? ExitStatus::done : ExitStatus::different;
    const std::string rest = ": " + counted(all.not_drawn, "entry was not drawn", "entries were not drawn");
    if (const std::string out_of_time = TimeLimit::sentence(); is_timeout(all.ended_by))
        throw Failure(ExitStatus::out_of_time, out_of_time + rest);
    std::fputs(("ended by " + std::string(name_of_ending_signal(all.ended_by)) + rest + "\n").c_str(), stderr);
    end_by_signal(all.ended_by);
}

ExitStatus run_suites(const Options& options, const TypedSuite& typed, const std::vector<Suite>& suites) {
    const Shard shard = shard_option(options, typed.shard);
    RunWish like;
    constexpr int most_jobs = 256;
    like.jobs = typed.jobs ? whole_option(options, "--jobs", *typed.jobs, 1, most_jobs) : 1;
    if (typed.entry_timeout)
        like.entry_timeout_s = number_option(options, "--entry-timeout", *typed.entry_timeout, 0.1, 1e6);
    std::vector<fs::path> reports;
    for (const Suite& suite : suites) {
        const fs::path report = fs::absolute(suite.report).lexically_normal();
        if (std::find(reports.begin(), reports.end(), report) != reports.end())
            throw Failure(ExitStatus::bad_input,
                          one_line(suite.argument.string()) +
                              ": another suite of this run has the same report folder; name another with \"report\"");
        reports.push_back(report);
    }
    for (const Suite& suite : suites) value_or_end(check_masks(suite));
    return run_all(suites, typed, shard, like);
}

// ---- the other actions ---------------------------------------------------------------------------------------------

ExitStatus accept(const Suite& suite, const std::vector<std::string>& names) {
    const std::size_t count = value_or_end(accept_results(suite, names));
    print(counted(static_cast<std::int64_t>(count), "reference") + " accepted\n");
    return ExitStatus::done;
}

ExitStatus merge(const Options& options, const Suite& suite, const std::vector<std::string>& folders) {
    if (folders.empty()) options.refuse("merge needs the folders of the shards' reports");
    const RunResult run = value_or_end(merge_reports(suite, {folders.begin(), folders.end()}));
    value_or_end(write_report(suite.report, run));
    print(one_line(suite.name) + ": " + summary_of(run) + ": " + (suite.report / "index.html").string() + "\n");
    return run.is_good(false) ? ExitStatus::done : ExitStatus::different;
}

/// Runs a worker process. Internal: the action `run` starts it.
ExitStatus work(const Options& options, const TypedSuite& typed, const Suite& whole) {
    const Suite suite = with_report_of(whole, shard_option(options, typed.shard));
    Headless headless(device_option(options, typed.device));
    // Hash the program, so that results cached by another build are not used.
    const std::string program = typed.cache ? std::to_string(fnv1a(all_bytes(own_program()))) : "";
    serve_entries(suite, {typed.allow_outside, typed.cache, "", program}, headless.renderer(), headless.log(), std::cin,
                  stdout);
    return ExitStatus::done;
}

ExitStatus run_suite(const Command& self, const Arguments& arguments) {
    Options options(self);
    TypedSuite typed;
    declare(options, typed);
    if (!options.parse(arguments)) return ExitStatus::done;
    constexpr std::array verbs{"run", "accept", "merge"};
    if (typed.words.size() < 2) options.refuse("an action and a suite are required: " + std::string(self.synopsis));
    const std::string verb = typed.words.front();
    const bool works = verb == "worker";  // a run with several jobs starts workers
    const std::size_t choice = works ? verbs.size() : choice_option(options, "the action", verb, verbs);
    const std::vector<std::string> rest(typed.words.begin() + 2, typed.words.end());
    if (verb != "run" && !works &&
        (!typed.only.empty() || typed.jobs || typed.shard || typed.times || typed.cache || typed.github))
        options.refuse(verb + " does not take options of run");
    if (verb == "run") {
        std::vector<Suite> suites;
        for (std::size_t i = 1; i < typed.words.size(); ++i) suites.push_back(value_or_end(load_suite(typed.words[i])));
        return run_suites(options, typed, suites);
    }
    constexpr std::size_t accepts = 1, merges = 2;
    if (works) end_with_parent();
    const Suite suite = value_or_end(load_suite(typed.words[1]));
    if (choice == accepts) return accept(suite, rest);
    if (choice == merges) return merge(options, suite, rest);
    return work(options, typed, suite);
}

}  // namespace

constinit const Command suite_command{
    "suite",
    "run|accept|merge SUITE… [OPTIONS]",
    "checks many states against their references, with a report to look at",
    "A suite is a .json file, or a folder of states with default settings. run draws every entry in one process "
    "(--jobs: in several), computes the requested numbers, and compares both with the references in the folder that "
    "the suite names; a missing reference is written, and its entry reported as new. A run never changes an existing "
    "reference: accept does that. report/index.html shows each entry with the expected picture, the actual one, and "
    "where they differ; junit.xml and report.json beside it are for programs. An entry that crashes, has a GL error or "
    "takes too long fails alone. A run that a signal or --timeout ends early writes its report too, with the rest as "
    "not drawn. The exit status is 1 if an entry is different, new (without --accept-new) or failed.",
    "suite run states\n"
    "suite run suite.json --jobs 4 --cache\n"
    "suite accept suite.json opening shadow-without-stencil\n"
    "suite run suite.json --shard 2/5 --times report\n"
    "suite merge suite.json report-1-of-2 report-2-of-2",
    "012389",
    run_suite};

}  // namespace viewing
