#include "suite/entry_check.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "image/png.h"
#include "platform/file.h"
#include "report/as_json.h"
#include "state/file/state_json.h"
#include "suite/entry_drawing.h"
#include "suite/numbers_apart.h"
#include "suite/picture_script.h"
#include "text/hash.h"
#include "text/numbers.h"
#include "text/per_enum.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

/// Thrown to end the check of an entry that cannot be drawn or whose files cannot be written; caught by Check::run().
struct Broken : Refusal {
    using Refusal::Refusal;
};

template <typename T>
T or_broken(Result<T> result) {
    if (!result) throw Broken(result.error());
    return *std::move(result);
}

class Check {
public:
    Check(const Suite& suite, const SuiteEntry& entry, const CheckWish& wish, Renderer& renderer)
        : suite_(suite),
          entry_(entry),
          wish_(wish),
          renderer_(renderer),
          files_(files_of(suite.report, entry.file_name)),
          result_(result_for(entry)) {}

    EntryResult run(gl::DebugLog& log) {
        try {
            const std::size_t known = log.errors().size();
            const SuiteSubject subject = or_broken(subject_of(entry_, renderer_, wish_.allows_outside));
            if (is_unchanged(subject)) return std::move(result_);
            forget_earlier_files();
            result_.outcome = Outcome::passed;
            const std::vector<Problem> problems = problems_of(subject);
            check_problems(problems);
            if (entry_.checks_picture) check_picture(subject);
            check_numbers(subject, problems);
            if (wish_.makes_keys) result_.key = key_of(subject);  // computed again with the current references
            for (std::size_t i = known; i < log.errors().size(); ++i)
                worsen(Outcome::failed, "GL error: " + log.errors()[i]);
        } catch (const Refusal& refusal) {
            worsen(Outcome::failed, refusal.what());
        }
        return std::move(result_);
    }

private:
    void worsen(Outcome outcome, std::string reason) {
        // A difference outweighs a new entry; a failure outweighs both.
        static constexpr PerEnum<Outcome, int, outcome_count> weight{0, 2, 1, 3, 0};
        if (weight[outcome] > weight[result_.outcome]) result_.outcome = outcome;
        result_.reasons.push_back(std::move(reason));
    }

    std::string key_of(const SuiteSubject& subject) const {
        const std::string all = wish_.program + "\n" + fingerprint(entry_, subject) + "\n" +
                                all_bytes(reference_picture(suite_, entry_)) +
                                all_bytes(reference_numbers(suite_, entry_));
        return std::to_string(fnv1a(all));
    }

    bool is_unchanged(const SuiteSubject& subject) {
        if (!wish_.makes_keys) return false;
        result_.key = key_of(subject);
        if (result_.key != wish_.known_key || (entry_.checks_picture && !is_there(files_.actual))) return false;
        result_.outcome = Outcome::passed;
        result_.is_kept = true;
        return true;
    }

    /// Removes the files of an earlier run that this run might not overwrite.
    void forget_earlier_files() const {
        std::error_code none;
        for (const fs::path& file : {files_.actual, files_.expected, files_.difference, files_.script, files_.numbers})
            fs::remove(file, none);
    }

    static void write(const fs::path& file, std::span<const std::uint8_t> bytes) { or_broken(write_file(file, bytes)); }

    void check_problems(const std::vector<Problem>& told) {
        const auto tells = [&](const std::string& part) {
            return std::any_of(told.begin(), told.end(), [&](const Problem& problem) {
                return problem.id == part || say(problem.sentence).find(part) != std::string::npos;
            });
        };
        if (!told.empty()) {
            result_.details["problems"] = as_json(told);
            result_.details["problem_details"] = details_of(told);
        }
        for (const std::string& part : entry_.wanted_problems)
            if (!tells(part)) worsen(Outcome::different, "the problem \"" + one_line(part) + "\" is not reported");
        for (const std::string& part : entry_.unwanted_problems)
            if (tells(part)) worsen(Outcome::different, "the problem \"" + one_line(part) + "\" is reported");
        if (entry_.allows_no_problem && !told.empty())
            worsen(Outcome::different, "an unexpected problem is reported: " + say(told.front().sentence));
    }

    void check_picture(const SuiteSubject& subject) {
        const Image drawn = or_broken(draw_picture(renderer_, subject.state, subject.scene, subject.request));
        const std::string state = write_state(drawn_params(subject.state.params, subject.request));
        const std::vector<std::uint8_t> actual = encode_png(drawn, state);
        write(files_.actual, actual);
        or_broken(write_file(files_.state, state + "\n"));
        const fs::path reference = reference_picture(suite_, entry_);
        if (!is_there(reference)) {
            write(reference, actual);
            return worsen(Outcome::fresh, "there was no reference: this picture is now the reference");
        }
        const Image expected = or_broken(read_png(reference));
        tell_changed_state(reference, state);
        const Mask mask = or_broken(mask_of(entry_.mask, drawn.width, drawn.height));
        const CompareReport report = compare_images(drawn, expected, entry_.limits, mask);
        if (report.different > 0) result_.details["compare"] = Json::parse(viewing::as_json(report));
        if (report.equal) return;
        worsen(Outcome::different, "the picture is " + sentence(report));
        or_broken(copy_bytes(reference, files_.expected));
        const std::vector<std::uint8_t> difference = encode_png(diff_picture(drawn, expected, entry_.limits, mask));
        write(files_.difference, difference);
        or_broken(write_file(files_.script, picture_script(entry_.file_name, all_bytes(reference), as_text(actual),
                                                           as_text(difference))));
    }

    /// Reports how the state has changed since the reference was drawn; the reference contains the earlier state.
    void tell_changed_state(const fs::path& reference, const std::string& state) {
        const Result<std::string> note = read_png_note(reference);
        if (!note || note->empty()) return;
        const auto before = guarded([&] { return parse_document(*note, ""); });
        if (!before) return;
        Json changes = listed(numbers_apart(*before, parse_document(state, ""), 0.0));
        if (!changes.empty()) result_.details["state"] = std::move(changes);
    }

    static std::string_view as_text(const std::vector<std::uint8_t>& bytes) {
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }

    static Json listed(const std::vector<NumberChange>& changes) {
        Json list = Json::array();
        for (const NumberChange& change : changes)
            list.push_back({{"path", change.path}, {"expected", change.expected}, {"actual", change.actual}});
        return list;
    }

    void check_numbers(const SuiteSubject& subject, const std::vector<Problem>& problems) {
        const Json numbers = or_broken(numbers_of_entry(entry_, subject, problems, renderer_));
        if (numbers.is_null()) return;
        const std::string text = print_document(numbers) + "\n";
        or_broken(write_file(files_.numbers, text));
        const fs::path reference = reference_numbers(suite_, entry_);
        if (!is_there(reference)) {
            or_broken(write_file(reference, text));
            return worsen(Outcome::fresh, "there were no reference numbers: these are now the reference");
        }
        const Json expected = parse_document(or_broken(read_text_file(reference)), reference.string() + ": ");
        std::vector<NumberChange> changes;
        const auto compare = [&](const char* part, const std::string& of, double tolerance) {
            const auto at = [&](const Json& all) {
                const Json found = all.is_object() && all.contains(part) ? all[part] : Json();
                return of.empty() || !found.is_object() || !found.contains(of) ? (of.empty() ? found : Json())
                                                                               : found[of];
            };
            for (NumberChange& change : numbers_apart(at(expected), at(numbers), tolerance)) {
                change.path = (of.empty() ? "" : of + ": ") + change.path;
                changes.push_back(std::move(change));
            }
        };
        if (entry_.matrices_tolerance) compare("matrices", "", *entry_.matrices_tolerance);
        for (const SuiteMeasure& measure : entry_.measures) compare("measure", measure.what, measure.tolerance);
        if (changes.empty()) return;
        const std::size_t others = changes.size() - 1;
        const NumberChange& first = changes.front();
        worsen(Outcome::different, one_line(first.path) + " was " + one_line(first.expected.dump()) + ", is " +
                                       one_line(first.actual.dump()) +
                                       (others == 0 ? "" : ", and " + std::to_string(others) + " more differ"));
        result_.details["numbers"] = listed(changes);
    }

    const Suite& suite_;
    const SuiteEntry& entry_;
    const CheckWish& wish_;
    Renderer& renderer_;
    const EntryFiles files_;
    EntryResult result_;
};

}  // namespace

EntryResult check_entry(const Suite& suite, const SuiteEntry& entry, const CheckWish& wish, Renderer& renderer,
                        gl::DebugLog& log) {
    return Check(suite, entry, wish, renderer).run(log);
}

}  // namespace viewing
