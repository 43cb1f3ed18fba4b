// Typed votes: what is understood, what is refused, and shares in percent.
#include <gtest/gtest.h>

#include <random>

#include "lesson/votes.h"

namespace viewing::test {
namespace {

VoteCounts read(std::string_view text) {
    const Result<VoteCounts> votes = typed_votes(text, 4);
    EXPECT_TRUE(votes) << text;
    return votes ? *votes : VoteCounts{};
}

std::string refusal(std::string_view text) {
    const Result<VoteCounts> votes = typed_votes(text, 4);
    return votes ? "" : votes.error();
}

TEST(TypedVotes, AreReadInEitherOrder) {
    for (const char* text : {"A 80", "a 80", "80 a", "80a", "  a80 "})
        EXPECT_EQ(read(text), (VoteCounts{80, -1, -1, -1}));
    EXPECT_EQ(read("a 80 b 60 c 40"), (VoteCounts{80, 60, 40, -1}));
    EXPECT_EQ(read("80 a d 0 60b"), (VoteCounts{80, 60, -1, 0}));
    EXPECT_EQ(read(""), (VoteCounts{-1, -1, -1, -1}));
}

TEST(TypedVotes, SayWhatDoesNotFit) {
    EXPECT_EQ(refusal("e 5"), "E: the choices are A to D.");
    EXPECT_EQ(refusal("a 5 b"), "B: how many votes?");
    EXPECT_EQ(refusal("a b 5"), "A: how many votes?");
    EXPECT_EQ(refusal("a 5 7"), "7: which choice is it for?");
    EXPECT_EQ(refusal("5 7 a"), "5: which choice is it for?");
    EXPECT_EQ(refusal("a 5 a 6"), "A appears twice.");
    EXPECT_EQ(refusal("a 99999999999999999999"), "At most 9999 votes.");
}

TEST(VoteShares, AddUpToAHundredAndAreWithinOnePercent) {
    std::mt19937 random(7);
    for (int i = 0; i < 500; ++i) {
        VoteCounts votes(2 + random() % 8);
        for (int& one : votes) one = static_cast<int>(random() % 90);
        const double total = total_votes(votes);
        if (total == 0.0) continue;
        int sum = 0;
        const std::vector<int> shares = vote_shares(votes);
        for (std::size_t c = 0; c < votes.size(); ++c) {
            EXPECT_LT(std::abs(shares[c] - 100.0 * votes[c] / total), 1.0);
            sum += shares[c];
        }
        EXPECT_EQ(sum, 100);
    }
    EXPECT_EQ(vote_shares({80, 60, 0, 45}), (std::vector{43, 33, 0, 24}));  // 43.24, 32.43 and 24.32 %
    EXPECT_EQ(vote_shares({0, 0}), (std::vector{0, 0}));
}

TEST(Ballot, KeepsBothVotesAndTakesBackEachChange) {
    Ballot ballot(3);
    ballot.take({80, 60, -1});
    ballot.begin(VoteRound::after_discussion);
    ballot.take({10, -1, 90});
    ballot.count(2, 1);
    EXPECT_EQ(ballot.votes(VoteRound::before_discussion), (VoteCounts{80, 60, 0}));
    EXPECT_EQ(ballot.votes(VoteRound::after_discussion), (VoteCounts{10, 0, 91}));
    ballot.count(1, -1);  // there is no vote to take back
    ballot.count(7, 1);   // no such choice
    EXPECT_TRUE(ballot.undo());
    EXPECT_EQ(ballot.votes(), (VoteCounts{10, 0, 90}));
    EXPECT_TRUE(ballot.undo());
    EXPECT_TRUE(ballot.undo());
    EXPECT_EQ(ballot.round(), VoteRound::before_discussion);
    EXPECT_EQ(ballot.votes(), (VoteCounts{0, 0, 0}));
    EXPECT_FALSE(ballot.undo());
}

}  // namespace
}  // namespace viewing::test
