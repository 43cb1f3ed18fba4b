#include "suite/report.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <system_error>

#include "embedded/pages.h"
#include "image/png.h"
#include "platform/file.h"
#include "text/html.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

Status make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return Error{folder.string() + ": cannot be created: " + error.message()};
    return std::monostate{};
}

std::string json_text(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// The subfolders of a report.
constexpr std::array inner_folders{"pictures", "states", "numbers"};

/// Checks that the folder may hold a report: it must be new, be empty, or contain a report. A report has a report.json
/// or, if its first run was killed before that file was written, all of the subfolders and nothing else.
Status check_report_folder(const fs::path& folder) {
    std::error_code error;
    if (!is_there(folder) || fs::is_empty(folder, error)) return std::monostate{};
    if (is_there(folder / "report.json")) {
        if (const Result<RunResult> earlier = read_run(folder); !earlier)
            return Error{earlier.error() + ": the folder does not hold a valid report; name another with \"report\""};
        return std::monostate{};
    }
    bool has_all = true;
    for (const char* const inner : inner_folders) has_all = has_all && fs::is_directory(folder / inner, error);
    std::string stranger;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        const bool is_own =
            has_all && std::find(inner_folders.begin(), inner_folders.end(), name) != inner_folders.end();
        if (!is_own && (stranger.empty() || name < stranger)) stranger = name;
    }
    if (stranger.empty() && !error) return std::monostate{};
    return Error{folder.string() + ": cannot hold a report: " +
                 (error ? error.message() : "it contains " + one_line(stranger) + " and no report.json") +
                 "; name another folder with \"report\""};
}

/// Escapes a text for XML, which cannot represent most control characters, invalid UTF-8, or noncharacters.
std::string xml_text(const std::string& text) {
    std::string clean;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        clean += (begin > 0 ? "\n" : "") + printable(std::string_view(text).substr(begin, end - begin));
        begin = end + 1;
    }
    return escaped(clean);
}

/// Replaces a placeholder everywhere in the page's template.
void fill(std::string& page, const std::string& place, std::string_view with) {
    const std::string mark = "{{" + place + "}}";
    for (std::size_t at = page.find(mark); at != std::string::npos; at = page.find(mark, at + with.size()))
        page.replace(at, mark.size(), with);
}

}  // namespace

Status prepare_report(const Suite& suite) {
    if (const Status is_ours = check_report_folder(suite.report); !is_ours) return is_ours;
    for (const fs::path& folder : {suite.references, suite.report})
        if (const Status made = make_folder(folder); !made) return made;
    for (const char* const inner : inner_folders)
        if (const Status made = make_folder(suite.report / inner); !made) return made;
    return std::monostate{};
}

std::string junit_of(const RunResult& run) {
    const std::string counts = " tests=\"" + std::to_string(run.entries.size()) + "\" failures=\"" +
                               std::to_string(run.count(Outcome::different) + run.count(Outcome::fresh)) +
                               "\" errors=\"" + std::to_string(run.count(Outcome::failed)) + "\" time=\"" +
                               std::to_string(run.seconds) + "\"";
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts + ">\n<testsuite name=\"" +
                       xml_text(run.suite) + "\"" + counts + ">\n";
    for (const EntryResult& entry : run.entries) {
        text += "<testcase classname=\"" + xml_text(run.suite) + "\" name=\"" + xml_text(entry.name) + "\" time=\"" +
                std::to_string(entry.seconds) + "\">";
        if (entry.outcome == Outcome::not_drawn) {
            text += "\n<skipped message=\"" + xml_text(reasons_in_lines(entry)) + "\"/>\n";
        } else if (entry.outcome != Outcome::passed) {
            const char* const kind = entry.outcome == Outcome::failed ? "error" : "failure";
            text += std::string("\n<") + kind + " type=\"" + name_of(entry.outcome) + "\" message=\"" +
                    xml_text(entry.reasons.empty() ? "" : entry.reasons.front()) + "\">" +
                    xml_text(reasons_in_lines(entry)) + "</" + kind + ">\n";
        }
        if (!entry.output.empty()) text += "<system-err>" + xml_text(entry.output) + "</system-err>\n";
        text += "</testcase>\n";
    }
    return text + "</testsuite>\n</testsuites>\n";
}

std::string report_page(const RunResult& run) {
    std::string page(embedded_page("report.html"));
    std::string data = json_text(as_json(run), -1);
    // Escape "<", so that a text from a state cannot end the script around it.
    for (std::size_t at = data.find('<'); at != std::string::npos; at = data.find('<', at))
        data.replace(at, 1, "\\u003c");
    fill(page, "title", escaped(run.suite));
    fill(page, "style", embedded_page("report.css"));
    fill(page, "script", embedded_page("report.js"));
    fill(page, "data", data);
    return page;
}

Status write_report(const fs::path& folder, const RunResult& run) {
    const auto bytes = [](const std::string& text) {
        return std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    };
    const std::string json = json_text(as_json(run), 1) + "\n", junit = junit_of(run), page = report_page(run);
    const FileBytes files[] = {{folder / "report.json", bytes(json)},
                               {folder / "junit.xml", bytes(junit)},
                               {folder / "index.html", bytes(page)}};
    return write_files(files);
}

std::vector<std::string> stray_references(const Suite& suite) {
    std::set<std::string> known{suite.argument.filename().string()};
    for (const SuiteEntry& entry : suite.entries) {
        known.insert(entry.file_name + ".png");
        known.insert(entry.file_name + ".json");
    }
    std::vector<std::string> strays;
    for (const char* const ending : {".png", ".json"})
        for (const fs::path& file : files_in(suite.references, ending))
            if (!known.contains(file.filename().string())) strays.push_back(file.filename().string());
    return strays;
}

Result<RunResult> merge_reports(const Suite& suite, const std::vector<fs::path>& folders) {
    std::map<std::string, EntryResult> found;
    std::map<std::string, fs::path> from;
    RunResult whole{suite.name, suite.argument.string(), "", "", 1, 1, 0.0, {}};
    int of = 0;
    for (const fs::path& folder : folders) {
        Result<RunResult> shard = read_run(folder);
        if (!shard) return Error{shard.error()};
        if (of != 0 && shard->of != of)
            return Error{folder.string() + " is a shard of " + std::to_string(shard->of) +
                         ", but the others are shards of " + std::to_string(of)};
        of = shard->of;
        whole.version = shard->version;
        whole.renderer = shard->renderer;
        whole.seconds += shard->seconds;
        for (EntryResult& entry : shard->entries) {
            const auto [earlier, is_new] = from.emplace(entry.name, folder);
            if (!is_new)
                return Error{folder.string() + ": " + one_line(entry.name) + " is already in " +
                             earlier->second.string()};
            found.emplace(entry.name, std::move(entry));
        }
    }
    if (const Status made = prepare_report(suite); !made) return Error{made.error()};
    for (const SuiteEntry& entry : suite.entries) {
        const auto result = found.find(entry.name);
        if (result == found.end()) {
            EntryResult missing = result_for(entry);
            missing.outcome = Outcome::not_drawn;
            missing.reasons = {"no shard contains it"};
            whole.entries.push_back(std::move(missing));
            continue;
        }
        const EntryFiles theirs = files_of(from.at(entry.name), entry.file_name);
        const EntryFiles ours = files_of(suite.report, entry.file_name);
        const std::pair<fs::path, fs::path> pairs[] = {
            {theirs.actual, ours.actual}, {theirs.expected, ours.expected}, {theirs.difference, ours.difference},
            {theirs.script, ours.script}, {theirs.state, ours.state},       {theirs.numbers, ours.numbers}};
        for (const auto& [source, target] : pairs)
            if (is_there(source) && source != target)
                if (const Status done = copy_bytes(source, target); !done) return Error{done.error()};
        whole.entries.push_back(std::move(result->second));
        found.erase(result);
    }
    if (!found.empty())
        return Error{from.at(found.begin()->first).string() + ": the suite has no entry " +
                     one_line(found.begin()->first)};
    return whole;
}

Result<RunResult> last_run(const Suite& suite) {
    Result<RunResult> run = read_run(suite.report);
    if (run && run->suite != suite.name)
        return Error{suite.report.string() + " has the report of another suite, " + one_line(run->suite) + ": run " +
                     one_line(suite.name) + " again, or give each suite a \"report\" folder of its own"};
    return run;
}

RunResult with_earlier_results(RunResult run, const Suite& suite) {
    Result<RunResult> earlier = last_run(suite);
    if (!earlier) return run;
    std::map<std::string, EntryResult> latest;
    for (RunResult* const one : {&*earlier, &run})
        for (EntryResult& entry : one->entries) latest.insert_or_assign(entry.name, std::move(entry));
    run.entries.clear();
    for (const SuiteEntry& entry : suite.entries)
        if (const auto found = latest.find(entry.name); found != latest.end())
            run.entries.push_back(std::move(found->second));
    return run;
}

Result<std::size_t> accept_results(const Suite& suite, const std::vector<std::string>& names) {
    Result<RunResult> run = last_run(suite);
    if (!run) return Error{run.error()};
    std::vector<std::string> known;
    for (const EntryResult& entry : run->entries) known.push_back(entry.name);
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            return Error{one_line(name) + ": the last run has no such entry" + suggestion(name, known)};
    std::size_t count = 0;
    for (EntryResult& result : run->entries) {
        const bool is_named = std::find(names.begin(), names.end(), result.name) != names.end();
        if (names.empty() ? result.outcome != Outcome::different : !is_named) continue;
        const EntryFiles files = files_of(suite.report, result.file_name);
        if (result.outcome == Outcome::failed || result.outcome == Outcome::not_drawn ||
            (!is_there(files.actual) && !is_there(files.numbers)))
            return Error{one_line(result.name) + ": the last run drew nothing to accept"};
        const fs::path reference = suite.references / result.file_name;
        const std::pair<fs::path, fs::path> pairs[] = {{files.actual, reference.string() + ".png"},
                                                       {files.numbers, reference.string() + ".json"}};
        const bool is_new = std::any_of(std::begin(pairs), std::end(pairs), [](const auto& pair) {
            return is_there(pair.first) && (!is_there(pair.second) || all_bytes(pair.first) != all_bytes(pair.second));
        });
        if (!is_new && (result.outcome == Outcome::passed || names.empty())) continue;
        if (!is_new)
            return Error{one_line(result.name) + ": nothing to accept, the result equals its reference; the entry " +
                         "itself requires something else: " + one_line(joined(result.reasons))};
        for (const auto& [source, target] : pairs)
            if (is_there(source))
                if (const Status done = copy_bytes(source, target); !done) return Error{done.error()};
        result.outcome = Outcome::passed;
        result.reasons = {"accepted"};
        result.key.clear();
        ++count;
    }
    if (const Status written = write_report(suite.report, *run); !written) return Error{written.error()};
    return count;
}

}  // namespace viewing
