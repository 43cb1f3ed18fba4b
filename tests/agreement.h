// Tests that a JSON Schema and the program's reader accept the same documents. Both get each document unchanged, then
// with one random change at a time. An independent validator, Debian's package python3-jsonschema, applies the schema.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "platform/file.h"
#include "platform/sanitized.h"
#include "state/file/document.h"
#include "state/scene.h"
#include "trials.h"

namespace viewing {

inline constexpr const char* no_validator = "no validator: Debian's package python3-jsonschema has it";

inline bool has_validator() {
    return std::system("/usr/bin/python3 -c 'from jsonschema import Draft202012Validator' 2>/dev/null") == 0;
}

/// Returns the documents of a folder of the assets.
inline std::vector<Json> files_of(const char* folder) {
    std::vector<Json> documents;
    for (const std::filesystem::path& file : files_in(assets_directory() / folder, ".json"))
        documents.push_back(parse_document(*read_text_file(file), ""));
    return documents;
}

/// Returns for each document, which is one line of JSON, whether it is valid.
inline std::vector<bool> judged(const std::string& schema, const std::vector<std::string>& documents) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("agreement-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "schema.json") << schema;
    std::ofstream list(folder / "documents");
    for (const std::string& document : documents) list << document << '\n';
    list.close();
    std::ofstream(folder / "judge.py") << R"(
import json, jsonschema
schema = json.load(open("schema.json"))
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
for line in open("documents"): print("yes" if validator.is_valid(json.loads(line)) else "no")
)";
    const std::string command = "cd '" + folder.string() + "' && /usr/bin/python3 judge.py > judged";
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::ifstream answers(folder / "judged");
    std::vector<bool> verdicts;
    for (std::string verdict; answers >> verdict;) verdicts.push_back(verdict == "yes");
    std::filesystem::remove_all(folder);
    EXPECT_EQ(verdicts.size(), documents.size());
    verdicts.resize(documents.size());
    return verdicts;
}

/// Changes one value in a document: removes or replaces it, sets a member of it, or makes it a list of equal items.
class OneChange {
public:
    explicit OneChange(unsigned seed) : random_(seed) {}

    Json changed(const Json& document) {
        Json result = document;
        std::vector<Json::json_pointer> places;
        collect(document, Json::json_pointer(), places);
        const Json::json_pointer place = places[random_() % places.size()];
        Json& value = result[place];
        const auto kind = random_() % 10;
        if (kind < 2 && !place.empty())
            remove(result, place);
        else if (kind == 2 && value.is_object())
            value["unknown"] = other();
        else if (kind == 3 && value.is_array())
            repeat(value);
        else if (kind == 4 && value.is_object())
            value[seen_[random_() % seen_.size()]] = other();
        else
            value = other();
        return result;
    }

private:
    void collect(const Json& value, const Json::json_pointer& at, std::vector<Json::json_pointer>& places) {
        places.push_back(at);
        if (value.is_array())
            for (std::size_t i = 0; i < value.size(); ++i) collect(value[i], at / i, places);
        if (value.is_object())
            for (const auto& [key, member] : value.items()) {
                seen_.push_back(key);
                collect(member, at / key, places);
            }
    }

    static void remove(Json& document, const Json::json_pointer& place) {
        Json& parent = document[place.parent_pointer()];
        if (parent.is_array())
            parent.erase(std::stoul(place.back()));
        else
            parent.erase(place.back());
    }

    void repeat(Json& list) {
        const std::size_t counts[] = {0, 1, 2, 3, 4, 10, 13, 65, 101, 201};
        const std::size_t count = counts[random_() % std::size(counts)];
        const Json item = list.empty() ? other() : list[random_() % list.size()];
        list = Json::array();
        for (std::size_t i = 0; i < count; ++i) list.push_back(item);
    }

    Json other() {
        static const std::vector<Json> values{nullptr,
                                              true,
                                              false,
                                              0,
                                              1,
                                              2,
                                              -1,
                                              0.5,
                                              1.5,
                                              4,
                                              16,
                                              17,
                                              99,
                                              100,
                                              256,
                                              600,
                                              601,
                                              1001,
                                              1e9,
                                              1e13,
                                              "",
                                              "x",
                                              "state",
                                              "a\u0001b",
                                              Json::array(),
                                              Json::object(),
                                              Json::array({1}),
                                              Json::array({"x"}),
                                              Json::array({Json::array()}),
                                              Json{{"en", "x"}},
                                              Json{{"ko", "x"}},
                                              Json{{"en", ""}, {"ko", "x"}},
                                              std::string(5000, 'x')};
        return values[random_() % values.size()];
    }

    std::mt19937 random_;
    std::vector<std::string> seen_;
};

/// Checks trials(`count`) versions of each document, of which the first is unchanged; a tenth as many under sanitizers.
/// `complaint` returns the reader's error message, or "". `only_reader`: parts of messages about rules that a schema
/// cannot express, so that only the reader refuses such a document.
inline void expect_agreement(const std::string& schema, const std::vector<Json>& documents, int count, unsigned seed,
                             const std::function<std::string(const std::string& text)>& complaint,
                             const std::vector<std::string>& only_reader) {
    std::cout << "seed " << seed << '\n';
    count = std::max(testing::trials(count) / (is_sanitized ? 10 : 1), 2);
    OneChange change(seed);
    std::vector<std::string> texts, complaints;
    for (const Json& document : documents)
        for (int i = 0; i < count; ++i) {
            texts.push_back((i == 0 ? document : change.changed(document)).dump());
            complaints.push_back(complaint(texts.back()));
        }
    const std::vector<bool> verdicts = judged(schema, texts);
    std::size_t accepted = 0, excepted = 0;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const bool is_unchanged = i % static_cast<std::size_t>(count) == 0;
        EXPECT_TRUE(!is_unchanged || (verdicts[i] && complaints[i].empty())) << complaints[i];
        accepted += verdicts[i] && complaints[i].empty() ? 1 : 0;
        if (verdicts[i] == complaints[i].empty()) continue;
        const bool is_excepted =
            verdicts[i] && std::any_of(only_reader.begin(), only_reader.end(), [&](const std::string& part) {
                return complaints[i].find(part) != std::string::npos;
            });
        excepted += is_excepted ? 1 : 0;
        EXPECT_TRUE(is_excepted) << "the schema " << (verdicts[i] ? "accepts" : "refuses")
                                 << " it, the reader says: " << complaints[i] << '\n'
                                 << texts[i].substr(0, 2000);
    }
    std::cout << texts.size() << " documents: " << accepted << " accepted, " << excepted
              << " refused only by the reader\n";
    if (is_sanitized) return;  // too few documents to check what share is accepted
    EXPECT_GT(accepted, texts.size() / 20);
    EXPECT_LT(accepted + excepted, texts.size() * 19 / 20);
}

}  // namespace viewing
