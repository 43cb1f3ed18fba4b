// Reports the curves in words and as a table. See growth.h for the contents of a row.
#include <algorithm>
#include <cmath>
#include <utility>

#include "text/catalogue.h"
#include "text/numbers.h"
#include "text/per_enum.h"
#include "topics/hidden/methods/growth.h"

namespace viewing {
namespace {

std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

/// What the methods differ in.
struct GrowthEntry {
    std::string_view name, operation;
    bool is_always_right;  ///< its picture, for any scene
};
constexpr PerEnum<GrowthMethod, GrowthEntry, growth_method_count> entries{
    GrowthEntry{marked("the painter's algorithm"), marked("comparisons"), false},
    GrowthEntry{marked("Newell's sort"), marked("pair tests"), true},
    GrowthEntry{marked("building the BSP tree"), marked("plane tests"), false},
    GrowthEntry{marked("walking the BSP tree"), marked("nodes visited"), true},
    GrowthEntry{marked("the software z-buffer"), marked("pixels tested"), true},
    GrowthEntry{marked("ray casting"), marked("box and triangle tests"), true}};

const GrowthRow* sound_row(std::span<const GrowthRow> rows, GrowthMethod method, int polygons) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const GrowthRow& candidate) {
        return candidate.method == method && candidate.polygons == polygons && candidate.problem.empty();
    });
    return row != rows.end() ? &*row : nullptr;
}

/// A range of neighboring counts with the same winner.
struct Reign {
    GrowthMethod method;
    int first, last;  ///< polygons
};

std::vector<Reign> reigns_of(std::span<const GrowthRow> rows) {
    std::vector<int> counts;
    for (const GrowthRow& row : rows) counts.push_back(row.polygons);
    std::sort(counts.begin(), counts.end());
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    std::vector<Reign> reigns;
    for (const int count : counts) {
        const auto winner = growth_winner(rows, count);
        if (!winner) continue;
        if (!reigns.empty() && reigns.back().method == *winner) {
            reigns.back().last = count;
        } else {
            reigns.push_back({*winner, count, count});
        }
    }
    return reigns;
}

/// Returns one entry in the list of all winners: "ray casting up to 30 polygons".
Message reign_text(const Reign& reign, std::span<const Reign> all) {
    const Message name(growth_method_name(reign.method), {});
    const std::string first = grouped_number(reign.first);
    if (all.size() > 1 && &reign == &all.front())
        return message_count(reign.last, "{method} up to {count} polygon", "{method} up to {count} polygons",
                             "method"_a = name);
    if (all.size() > 1 && &reign == &all.back())
        return message("{method} for {first} or more", "method"_a = name, "first"_a = first);
    if (reign.first == reign.last)
        return message_count(reign.last, "{method} with {count} polygon", "{method} with {count} polygons",
                             "method"_a = name);
    return message("{method} from {first} to {last} polygons", "method"_a = name, "first"_a = first,
                   "last"_a = grouped_number(reign.last));
}

/// Returns the factor by which the work grows if there are ten times as many polygons. Uses the method's last row
/// without a problem and the last one before it with at most half as many polygons.
std::optional<double> tenfold_factor(std::span<const GrowthRow> rows, GrowthMethod method) {
    const GrowthRow *last = nullptr, *before = nullptr;
    for (const GrowthRow& row : rows) {
        if (row.method != method || !row.problem.empty()) continue;
        last = &row;
    }
    for (const GrowthRow& row : rows)
        if (last && row.method == method && row.problem.empty() && 2 * row.polygons <= last->polygons) before = &row;
    if (before == nullptr || before->work() == 0 || last->work() == 0) return std::nullopt;
    const double decades = std::log10(static_cast<double>(last->polygons) / before->polygons);
    return std::pow(static_cast<double>(last->work()) / static_cast<double>(before->work()), 1.0 / decades);
}

Message growth_of_work(std::span<const GrowthRow> rows) {
    std::vector<Message> list;
    for (std::size_t i = 0; i < growth_method_count; ++i) {
        const auto method = static_cast<GrowthMethod>(i);
        const auto factor = tenfold_factor(rows, method);
        if (!factor) continue;
        const std::string times = grouped_number(std::llround(*factor));
        const Message name(growth_method_name(method), {});
        list.push_back(list.empty()
                           ? message("by a factor of {times} for {method}", "times"_a = times, "method"_a = name)
                           : message("by {times} for {method}", "times"_a = times, "method"_a = name));
    }
    if (list.empty()) return {};
    return message("At the end of the curves, ten times as many polygons multiply the number of operations {list}.",
                   "list"_a = listed(list));
}

}  // namespace

std::string_view growth_method_name(GrowthMethod method) {
    return entries[method].name;
}

std::string_view growth_operation_name(GrowthMethod method) {
    return entries[method].operation;
}

std::string growth_csv(std::span<const GrowthRow> rows, bool with_times) {
    std::string text = "method,polygons,operation,operations,pixels_painted,problem";
    if (with_times) text += ",time_ms,time_least_ms,time_most_ms,runs,painting_ms,build_ms";
    text += "\r\n";
    for (const GrowthRow& row : rows) {
        text += csv_field(growth_method_name(row.method)) + ',' + std::to_string(row.polygons) + ',' +
                csv_field(row.operation_name) + ',' + std::to_string(row.operations) + ',' +
                std::to_string(row.pixels_painted) + ',' + csv_field(say(row.problem));
        if (with_times)
            text += ',' + shortest_number(row.time_ms) + ',' + shortest_number(row.time_least_ms) + ',' +
                    shortest_number(row.time_most_ms) + ',' + std::to_string(row.runs) + ',' +
                    shortest_number(row.painting_ms) + ',' + shortest_number(row.build_ms);
        text += "\r\n";
    }
    return text;
}

std::optional<GrowthMethod> growth_winner(std::span<const GrowthRow> rows, int polygons) {
    const GrowthRow* least = nullptr;
    for (const GrowthRow& row : rows) {
        if (row.polygons != polygons || !row.problem.empty() || !entries[row.method].is_always_right) continue;
        if (least == nullptr || row.work() < least->work()) least = &row;
    }
    return least != nullptr ? std::optional(least->method) : std::nullopt;
}

Message growth_summary(std::span<const GrowthRow> rows) {
    const std::vector<Reign> reigns = reigns_of(rows);
    if (reigns.empty()) return {};
    std::vector<Message> list;
    for (const Reign& reign : reigns) list.push_back(reign_text(reign, reigns));
    std::vector<Message> sentences{
        message("Methods with the fewest operations, painting included, among those that are always correct: {list}.",
                "list"_a = listed(list))};
    const bool walk_wins = std::any_of(reigns.begin(), reigns.end(),
                                       [](const Reign& reign) { return reign.method == GrowthMethod::bsp_walk; });
    if (walk_wins) sentences.push_back(message("One tree, built in advance, serves every eye position."));
    if (Message growth = growth_of_work(rows); !growth.empty()) sentences.push_back(std::move(growth));
    return listed(sentences, " ");
}

Message growth_times(std::span<const GrowthRow> rows) {
    int count = 0;
    for (const GrowthRow& row : rows) {
        const auto has_row = [&](GrowthMethod method) {
            return !entries[method].is_always_right || sound_row(rows, method, row.polygons) != nullptr;
        };
        if (has_row(GrowthMethod::newell) && has_row(GrowthMethod::bsp_walk) && has_row(GrowthMethod::z_buffer) &&
            has_row(GrowthMethod::ray_casting))
            count = std::max(count, row.polygons);
    }
    if (count == 0) return {};
    std::vector<Message> list;
    for (std::size_t i = 0; i < growth_method_count; ++i) {
        const auto method = static_cast<GrowthMethod>(i);
        const GrowthRow* row = entries[method].is_always_right ? sound_row(rows, method, count) : nullptr;
        if (row == nullptr) continue;
        list.push_back(message("{method} {time} ms ({least} to {most})",
                               "method"_a = Message(growth_method_name(method), {}),
                               "time"_a = figures(row->time_ms, 2), "least"_a = figures(row->time_least_ms, 2),
                               "most"_a = figures(row->time_most_ms, 2)));
    }
    return message_count(count, "Median times of several runs with {count} polygon: {list}.",
                         "Median times of several runs with {count} polygons: {list}.", "list"_a = listed(list));
}

}  // namespace viewing
