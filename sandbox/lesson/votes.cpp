#include "lesson/votes.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "text/catalogue.h"

namespace viewing {
namespace {

constexpr int most_votes = 9999;  ///< more than any lecture hall holds

bool types_number(char sign) {
    return sign >= '0' && sign <= '9';
}

}  // namespace

Result<VoteCounts> typed_votes(std::string_view text, std::size_t choices) {
    VoteCounts votes(choices, -1);
    std::optional<std::size_t> choice;
    std::optional<int> number;
    const auto letter = [](std::size_t place) { return std::string(1, static_cast<char>('A' + place)); };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char sign = text[i];
        if (sign == ' ') continue;
        if (types_number(sign)) {
            if (number) return Error{say("{number}: which choice is it for?", "number"_a = *number)};
            number = 0;
            for (; i < text.size() && types_number(text[i]); ++i) {
                number = *number * 10 + (text[i] - '0');
                if (*number > most_votes) return Error{say("At most {most} votes.", "most"_a = most_votes)};
            }
            --i;
        } else {
            const char upper = sign >= 'a' && sign <= 'z' ? static_cast<char>(sign - 'a' + 'A') : sign;
            if (upper < 'A' || upper >= static_cast<char>('A' + choices))
                return Error{say("{sign}: the choices are A to {last}.", "sign"_a = std::string(1, upper),
                                 "last"_a = letter(choices - 1))};
            if (choice) return Error{say("{choice}: how many votes?", "choice"_a = letter(*choice))};
            choice = static_cast<std::size_t>(upper - 'A');
        }
        if (!choice || !number) continue;
        if (votes[*choice] >= 0) return Error{say("{choice} appears twice.", "choice"_a = letter(*choice))};
        votes[*choice] = *number;
        choice.reset();
        number.reset();
    }
    if (choice) return Error{say("{choice}: how many votes?", "choice"_a = letter(*choice))};
    if (number) return Error{say("{number}: which choice is it for?", "number"_a = *number)};
    return votes;
}

int total_votes(const VoteCounts& votes) {
    return std::accumulate(votes.begin(), votes.end(), 0);
}

std::vector<int> vote_shares(const VoteCounts& votes) {
    const int total = total_votes(votes);
    std::vector<int> shares(votes.size(), 0);
    if (total == 0) return shares;
    for (std::size_t i = 0; i < votes.size(); ++i) shares[i] = votes[i] * 100 / total;
    // Percentage points lost by rounding down go to the shares with the largest remainders.
    std::vector<std::size_t> order(votes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return votes[a] * 100 % total > votes[b] * 100 % total; });
    const auto missing = static_cast<std::size_t>(100 - total_votes(shares));
    for (std::size_t i = 0; i < missing; ++i) ++shares[order[i]];
    return shares;
}

Ballot::Ballot(std::size_t choices) : votes_{VoteCounts(choices, 0), VoteCounts(choices, 0)} {}

void Ballot::change_to(VoteCounts votes) {
    VoteCounts& now = votes_[round_];
    if (votes == now) return;
    past_.push_back({round_, std::move(now)});
    now = std::move(votes);
}

void Ballot::count(int choice, int change) {
    if (choice < 0 || choice >= static_cast<int>(choices())) return;
    VoteCounts counted = votes();
    int& hands = counted[choice];
    hands = std::clamp(hands + change, 0, most_votes);
    change_to(std::move(counted));
}

VoteCounts Ballot::with(const VoteCounts& typed) const {
    VoteCounts counted = votes();
    for (std::size_t i = 0; i < std::min(counted.size(), typed.size()); ++i)
        if (typed[i] >= 0) counted[i] = typed[i];
    return counted;
}

void Ballot::take(const VoteCounts& typed) {
    change_to(with(typed));
}

bool Ballot::undo() {
    if (past_.empty()) return false;
    round_ = past_.back().round;
    votes_[round_] = std::move(past_.back().votes);
    past_.pop_back();
    return true;
}

}  // namespace viewing
