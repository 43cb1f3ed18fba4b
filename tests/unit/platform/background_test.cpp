// Work beside the caller: results, progress, cancelling, and what a task throws.
#include "platform/background.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <thread>

namespace viewing {
namespace {

/// Goes on until it is cancelled, then gives 7.
int until_cancelled(WorkProgress& progress) {
    report(&progress, 0.25);
    while (!is_cancelled(&progress)) std::this_thread::yield();
    return 7;
}

TEST(Background, GivesItsResultOnce) {
    BackgroundTask<std::string> task;
    EXPECT_FALSE(task.is_running());
    EXPECT_FALSE(task.take());
    task.wait(-1.0);
    task.start([](WorkProgress&) { return std::string("made"); });
    EXPECT_TRUE(task.is_running());
    task.wait(-1.0);
    EXPECT_TRUE(task.is_done());
    EXPECT_TRUE(task.is_running()) << "until its result is taken";
    EXPECT_EQ(**task.take(), "made");
    EXPECT_FALSE(task.is_running());
    EXPECT_FALSE(task.take());
}

TEST(Background, WorksBesideItsCaller) {
    BackgroundTask<std::thread::id> task;
    task.start([](WorkProgress&) { return std::this_thread::get_id(); });
    task.wait(-1.0);
    EXPECT_NE(**task.take(), std::this_thread::get_id());
}

TEST(Background, IsWatchedAndCancelled) {
    BackgroundTask<int> task;
    task.start(until_cancelled);
    while (task.fraction() == 0.0F) std::this_thread::yield();
    EXPECT_EQ(task.fraction(), 0.25F);
    task.wait(0.001);
    EXPECT_FALSE(task.is_done());
    EXPECT_FALSE(task.take());
    task.cancel();
    task.wait(-1.0);
    EXPECT_EQ(**task.take(), 7) << "what it had";
}

TEST(Background, AnotherStartReplacesWhatRuns) {
    BackgroundTask<int> task;
    task.start(until_cancelled);
    task.start([](WorkProgress& progress) { return progress.cancelled ? -1 : 8; });
    task.wait(-1.0);
    EXPECT_EQ(**task.take(), 8);
}

TEST(Background, WhatIsDroppedHoldsUpNobody) {
    std::atomic<bool> may_end{false}, has_ended{false};
    {
        BackgroundTask<int> task;
        task.start([&](WorkProgress&) {  // hears of no cancelling
            while (!may_end) std::this_thread::yield();
            has_ended = true;
            return 1;
        });
        task.start([](WorkProgress&) { return 2; });
        task.wait(-1.0);
        EXPECT_EQ(**task.take(), 2);
        EXPECT_FALSE(has_ended);
        task.drop();
        EXPECT_FALSE(task.is_running());
        may_end = true;
    }
    EXPECT_TRUE(has_ended) << "the end of all waits for it";
}

TEST(Background, IsCancelledAndWaitedForAtItsEnd) {
    bool ended = false;
    {
        BackgroundTask<int> task;
        task.start([&ended](WorkProgress& progress) {
            const int result = until_cancelled(progress);
            ended = true;
            return result;
        });
    }
    EXPECT_TRUE(ended);
}

TEST(Background, WhatWasThrownIsASentence) {
    BackgroundTask<int> task;
    const auto sentence_of = [&task](const std::function<int()>& work) {
        task.start([work](WorkProgress&) { return work(); });
        task.wait(-1.0);
        const std::optional<Result<int>> result = task.take();
        EXPECT_FALSE(task.is_running());
        return result && !*result ? result->error() : "no error";
    };
    EXPECT_EQ(sentence_of([]() -> int { throw std::runtime_error("out of paper"); }),
              "this work is given up: out of paper");
    EXPECT_EQ(sentence_of([]() -> int { throw std::bad_alloc(); }),
              "the memory does not suffice for this work: it is given up");
    EXPECT_EQ(sentence_of([]() -> int { throw 7; }), "this work is given up, nobody knows why");
    task.start([](WorkProgress&) -> Result<int> { return Error{"an error stays as it is"}; });
    task.wait(-1.0);
    EXPECT_EQ(task.take()->error(), "an error stays as it is");
    task.start([](WorkProgress&) { return 1; });
    task.wait(-1.0);
    EXPECT_EQ(**task.take(), 1);
}

BackgroundTask<int>* watched = nullptr;
std::atomic<int> wakes_after_the_end{0};

TEST(Background, ItsEndWakesWhoeverSleeps) {
    BackgroundTask<int> task;
    watched = &task;
    wake_when_work_ends([] { wakes_after_the_end += watched->is_done() ? 1 : 100; });
    std::atomic<bool> may_begin{false};
    task.start([&may_begin](WorkProgress&) {
        while (!may_begin) std::this_thread::yield();
        return 1;
    });
    may_begin = true;
    while (wakes_after_the_end == 0) std::this_thread::yield();
    wake_when_work_ends(nullptr);
    EXPECT_EQ(wakes_after_the_end, 1) << "whoever is waked finds the result";
    task.start([](WorkProgress&) -> int { throw std::bad_alloc(); });
    task.wait(-1.0);
    task = {};
    EXPECT_EQ(wakes_after_the_end, 1) << "nobody is waked any more";
}

TEST(Background, ALogKeepsTheOrderOfItsEntries) {
    const auto log = std::make_shared<BackgroundLog<int>>();
    BackgroundTask<int> task;
    task.start([log](WorkProgress&) {
        for (int i = 0; i < 1000; ++i) log->add(i);
        return 0;
    });
    while (!task.is_done()) {
        const std::vector<int> entries = log->entries();
        for (std::size_t i = 0; i < entries.size(); ++i) ASSERT_EQ(entries[i], static_cast<int>(i));
    }
    EXPECT_EQ(log->entries().size(), 1000U);
}

TEST(Progress, OfNothingIsNeverCancelled) {
    report(nullptr, 0.5);
    EXPECT_FALSE(is_cancelled(nullptr));
}

TEST(Progress, APartFillsItsShareOfTheWhole) {
    WorkProgress whole;
    WorkProgress part{.whole = &whole, .begin = 0.5, .end = 0.75};
    report(&part, 0.5);
    EXPECT_EQ(part.fraction, 0.5F);
    EXPECT_EQ(whole.fraction, 0.625F);
    report(&part, 0.25);
    EXPECT_EQ(part.fraction, 0.25F) << "done once more";
    EXPECT_EQ(whole.fraction, 0.625F) << "never falls back";
    report(&part, 1.0);
    EXPECT_EQ(whole.fraction, 0.75F);
}

TEST(Progress, APartIsCancelledWithTheWholeAndNotTheOtherWayRound) {
    WorkProgress whole;
    WorkProgress part{.whole = &whole};
    part.cancelled = true;
    EXPECT_TRUE(is_cancelled(&part));
    EXPECT_FALSE(is_cancelled(&whole));
    part.cancelled = false;
    EXPECT_FALSE(is_cancelled(&part));
    whole.cancelled = true;
    EXPECT_TRUE(is_cancelled(&part));
}

TEST(Progress, ADeadlineCancels) {
    using namespace std::chrono_literals;
    const auto now = WorkProgress::Clock::now();
    const WorkProgress late{.deadline = now - 1s}, early{.deadline = now + 1h};
    EXPECT_TRUE(is_late(late));
    EXPECT_TRUE(is_cancelled(&late));
    EXPECT_FALSE(is_late(early));
    EXPECT_FALSE(is_cancelled(&early));
}

}  // namespace
}  // namespace viewing
