#include "cli/ending_report.h"

#include <array>
#include <cmath>
#include <exception>
#include <new>

#include "cli/exit_status.h"
#include "cli/signals.h"
#include "cli/time_limit.h"
#include "platform/last_words.h"
#include "text/words.h"

namespace viewing {

EndingReport::EndingReport(const Command& command, const Options& options, const std::optional<std::string>& target,
                           std::function<NamedFiles()> files)
    : command_(command), options_(options), target_(target), files_(std::move(files)) {}

EndingReport::~EndingReport() {
    forget_last_words();
}

ExitStatus EndingReport::guard(const std::function<ExitStatus()>& work) {
    try {
        return work();
    } catch (const Failure& failure) {
        write_failure(failure.status, failure.what());
        throw;
    } catch (const std::bad_alloc&) {
        write_failure(ExitStatus::internal_error, not_enough_memory);
        throw;
    } catch (const std::exception& error) {
        write_failure(ExitStatus::internal_error, std::string("internal error: ") + error.what());
        throw;
    }
}

void EndingReport::begin() {
    const NamedFiles files = files_();
    check_outputs(options_, files.outputs, files.inputs);
    is_watching_ = target_.has_value();
    prepare_last_words();
}

void EndingReport::tell(const char* name, Json value) {
    facts_[name] = std::move(value);
    prepare_last_words();
}

void EndingReport::finish(Outputs& results, ExitStatus status, const std::string& sentence) {
    if (target_) results.add(*target_, text(status, sentence, seconds_so_far()));
    // A write to a pipe may block after part of the report. A timeout must not write a second report then.
    if (target_ && !is_plain_file(*target_)) forget_last_words();
    results.write();
    is_written_ = true;
    forget_last_words();
}

std::string EndingReport::text(ExitStatus status, const std::string& sentence, std::optional<double> duration_s) const {
    Json report = {{"command", command_.name},
                   {"version", VIEWING_SANDBOX_VERSION},
                   {"status", static_cast<int>(status)},
                   {"meaning", meaning(status)},
                   {"sentence", sentence.empty() ? Json() : Json(printable(sentence))},
                   {"duration_s", duration_s ? Json(std::round(*duration_s * 1e3) / 1e3) : Json()}};
    report.update(facts_);
    return print_document(report) + "\n";
}

double EndingReport::seconds_so_far() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
}

void EndingReport::prepare_last_words() const {
    if (!is_watching_) return;
    const auto ending = [this](ExitStatus status, const std::string& sentence, std::optional<double> duration_s) {
        return std::pair(static_cast<int>(status), text(status, sentence, duration_s));
    };
    set_last_words(*target_, {ending(ExitStatus::out_of_time, TimeLimit::sentence(), TimeLimit::seconds()),
                              ending(ExitStatus::internal_error, fault_sentence, std::nullopt)});
}

void EndingReport::write_failure(ExitStatus status, const std::string& sentence) {
    if (!target_ || is_written_) return;
    try {
        const NamedFiles files = files_();
        const FileArgument own{"--json", *target_};
        check_outputs(options_, {&own, 1}, files.inputs);
        for (const FileArgument& other : files.outputs)
            if (other.option != own.option) check_apart(options_, std::array{own, other}, {});
        Outputs alone;
        finish(alone, status, sentence);
    } catch (const std::bad_alloc&) {
        say_last_words(static_cast<int>(ExitStatus::internal_error));
    } catch (const std::exception&) {
        // Let the command's own failure be the one that is reported.
    }
}

Json name_as_json(const std::optional<std::string>& name) {
    return name ? Json(printable(*name)) : Json();
}

}  // namespace viewing
