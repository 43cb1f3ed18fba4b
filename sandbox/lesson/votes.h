// An audience's votes on one question with choices: a first vote and a second one after the discussion. The lecturer
// types the counts ("A 80 B 60") or counts raised hands.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "text/per_enum.h"
#include "text/result.h"

namespace viewing {

/// The number of votes for each choice; −1: not among the typed counts.
using VoteCounts = std::vector<int>;

enum class VoteRound { before_discussion, after_discussion };

/// Reads typed counts, in either order: "A 80", "80 a", "a80 b60 c40". The error says in one sentence which part of
/// the text is wrong. `choices`: the number of choices.
Result<VoteCounts> typed_votes(std::string_view text, std::size_t choices);

int total_votes(const VoteCounts& votes);
/// Returns each choice's share in whole percent. The shares add up to 100, unless nobody has voted.
std::vector<int> vote_shares(const VoteCounts& votes);

class Ballot {
public:
    explicit Ballot(std::size_t choices = 0);

    std::size_t choices() const { return votes_.front().size(); }
    /// The vote that is being counted.
    VoteRound round() const { return round_; }
    void begin(VoteRound round) { round_ = round; }
    const VoteCounts& votes(VoteRound round) const { return votes_[round]; }
    const VoteCounts& votes() const { return votes(round_); }
    bool has_votes(VoteRound round) const { return total_votes(votes(round)) > 0; }

    /// Adds `change` to the votes for a choice, never below 0. Does nothing if there is no such choice.
    void count(int choice, int change);
    /// Takes typed counts; the other choices keep theirs.
    void take(const VoteCounts& typed);
    /// Returns the votes as take() would leave them.
    VoteCounts with(const VoteCounts& typed) const;
    /// Undoes the latest count() or take(). Returns false if there is none.
    bool undo();

private:
    struct Past {
        VoteRound round;
        VoteCounts votes;
    };
    void change_to(VoteCounts votes);

    VoteRound round_ = VoteRound::before_discussion;
    PerEnum<VoteRound, VoteCounts, 2> votes_;
    std::vector<Past> past_;
};

}  // namespace viewing
