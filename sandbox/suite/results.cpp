#include "suite/results.h"

#include <algorithm>
#include <array>

#include "state/file/reader.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

constexpr std::array outcome_names{"passed", "different", "new", "failed", "not drawn"};

std::string text_at(const Json& object, const char* key, const Where& where) {
    if (!object.contains(key) || !object[key].is_string()) where.key(key).refuse("must be a string");
    return object[key].get<std::string>();
}

double seconds_at(const Json& object, const Where& where) {
    return object.contains("seconds") ? read_number(object["seconds"], where.key("seconds"), {0.0, 1e9}) : 0.0;
}

}  // namespace

const char* name_of(Outcome outcome) {
    return outcome_names[static_cast<std::size_t>(outcome)];
}

EntryResult result_for(const SuiteEntry& entry) {
    EntryResult result;
    result.name = entry.name;
    result.file_name = entry.file_name;
    result.about = entry.about;
    return result;
}

std::size_t RunResult::count(Outcome outcome) const {
    return static_cast<std::size_t>(std::count_if(entries.begin(), entries.end(),
                                                  [&](const EntryResult& entry) { return entry.outcome == outcome; }));
}

bool RunResult::is_good(bool accepts_new) const {
    return count(Outcome::passed) + (accepts_new ? count(Outcome::fresh) : 0) == entries.size();
}

std::string reasons_in_lines(const EntryResult& entry) {
    std::string text;
    for (const std::string& reason : entry.reasons) text += (text.empty() ? "" : "\n") + reason;
    return text;
}

Json as_json(const EntryResult& entry) {
    return {{"name", entry.name},       {"file", entry.file_name},
            {"about", entry.about},     {"outcome", name_of(entry.outcome)},
            {"kept", entry.is_kept},    {"reasons", entry.reasons},
            {"seconds", entry.seconds}, {"key", entry.key},
            {"output", entry.output},   {"details", entry.details}};
}

Json as_json(const RunResult& run) {
    Json counts = Json::object();
    for (int i = 0; i < outcome_count; ++i) counts[outcome_names[i]] = run.count(static_cast<Outcome>(i));
    Json json{{"report", 1},
              {"suite", run.suite},
              {"argument", run.argument},
              {"version", run.version},
              {"renderer", run.renderer},
              {"shard", {run.shard, run.of}},
              {"seconds", run.seconds},
              {"counts", std::move(counts)},
              {"entries", Json::array()}};
    for (const EntryResult& entry : run.entries) json["entries"].push_back(as_json(entry));
    return json;
}

EntryResult read_entry_result(const Json& value, const Where& where) {
    require_object(value, where, "an entry's result");
    EntryResult entry;
    entry.name = text_at(value, "name", where);
    entry.file_name = text_at(value, "file", where);
    if (entry.file_name != safe_file_name(entry.name)) where.key("file").refuse("does not match the name");
    if (value.contains("about")) entry.about = text_at(value, "about", where);
    if (!value.contains("outcome")) where.key("outcome").refuse("is missing");
    entry.outcome = static_cast<Outcome>(read_choice(value["outcome"], where.key("outcome"), outcome_names));
    entry.is_kept = value.contains("kept") && read_bool(value["kept"], where.key("kept"));
    if (value.contains("reasons")) {
        require_array(value["reasons"], where.key("reasons"), 1000, "a list of sentences");
        for (const Json& reason : value["reasons"])
            if (reason.is_string()) entry.reasons.push_back(reason.get<std::string>());
    }
    entry.seconds = seconds_at(value, where);
    entry.key = text_at(value, "key", where);
    entry.output = text_at(value, "output", where);
    if (value.contains("details")) entry.details = value["details"];
    return entry;
}

Result<RunResult> read_run(const fs::path& folder) {
    const fs::path file = folder / "report.json";
    constexpr DocumentLimits of_a_report{.bytes = 256U << 20U, .values = 10'000'000};  // for 100,000 entries
    const Result<std::string> text = read_text_file(file, of_a_report.bytes);
    if (!text) return Error{text.error()};
    return guarded([&] {
        const Where root{file.string() + ": ", ""};
        const Json document = parse_document(*text, root.prefix, of_a_report);
        require_object(document, root, "a report");
        if (!document.contains("report") || document["report"] != 1) root.key("report").refuse("must be 1");
        RunResult run;
        run.suite = text_at(document, "suite", root);
        run.argument = text_at(document, "argument", root);
        run.version = text_at(document, "version", root);
        run.renderer = text_at(document, "renderer", root);
        run.seconds = seconds_at(document, root);
        if (!document.contains("shard")) root.key("shard").refuse("is missing");
        require_array(document["shard"], root.key("shard"), 2, "[I, N]");
        if (document["shard"].size() != 2) root.key("shard").refuse("must be [I, N]");
        run.shard = read_whole(document["shard"][0], root.key("shard").at(0), 1, 10'000);
        run.of = read_whole(document["shard"][1], root.key("shard").at(1), 1, 10'000);
        if (!document.contains("entries")) root.key("entries").refuse("is missing");
        require_array(document["entries"], root.key("entries"), 1'000'000, "a list of results");
        for (std::size_t i = 0; i < document["entries"].size(); ++i)
            run.entries.push_back(read_entry_result(document["entries"][i], root.key("entries").at(i)));
        return run;
    });
}

std::string summary_of(const RunResult& run) {
    std::string text = counted(std::ssize(run.entries), "entry:", "entries:");
    const char* separator = " ";
    for (int i = 0; i < outcome_count; ++i) {
        const std::size_t count = run.count(static_cast<Outcome>(i));
        if (count == 0) continue;
        text += separator + grouped_number(static_cast<std::int64_t>(count)) + " " + outcome_names[i];
        separator = ", ";
    }
    const auto kept =
        std::count_if(run.entries.begin(), run.entries.end(), [](const EntryResult& entry) { return entry.is_kept; });
    if (kept > 0) text += " (" + grouped_number(kept) + " unchanged, not drawn again)";
    return text + "; " + plain_decimals(run.seconds, 1) + " s";
}

EntryFiles files_of(const fs::path& report, const std::string& file_name) {
    const fs::path pictures = report / "pictures";
    return {pictures / (file_name + ".actual.png"),     pictures / (file_name + ".expected.png"),
            pictures / (file_name + ".difference.png"), pictures / (file_name + ".js"),
            report / "states" / (file_name + ".json"),  report / "numbers" / (file_name + ".json")};
}

fs::path reference_picture(const Suite& suite, const SuiteEntry& entry) {
    return suite.references / (entry.file_name + ".png");
}

fs::path reference_numbers(const Suite& suite, const SuiteEntry& entry) {
    return suite.references / (entry.file_name + ".json");
}

}  // namespace viewing
