// Background work: results, progress, cancellation, and exceptions that a task throws.
#include "platform/background.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <thread>

namespace viewing {
namespace {

/// Runs until it is canceled, then returns 7.
int until_canceled(WorkProgress& progress) {
    report(&progress, 0.25);
    while (!is_canceled(&progress)) std::this_thread::yield();
    return 7;
}

TEST(Background, ReturnsItsResultOnce) {
    BackgroundTask<std::string> task;
    EXPECT_FALSE(task.is_running());
    EXPECT_FALSE(task.take());
    task.wait(-1.0);
    task.start([](WorkProgress&) { return std::string("made"); });
    EXPECT_TRUE(task.is_running());
    task.wait(-1.0);
    EXPECT_TRUE(task.is_done());
    EXPECT_TRUE(task.is_running()) << "until the result is taken";
    EXPECT_EQ(**task.take(), "made");
    EXPECT_FALSE(task.is_running());
    EXPECT_FALSE(task.take());
}

TEST(Background, RunsBesideItsCaller) {
    BackgroundTask<std::thread::id> task;
    task.start([](WorkProgress&) { return std::this_thread::get_id(); });
    task.wait(-1.0);
    EXPECT_NE(**task.take(), std::this_thread::get_id());
}

TEST(Background, ReportsProgressAndCanBeCanceled) {
    BackgroundTask<int> task;
    task.start(until_canceled);
    while (task.fraction() == 0.0F) std::this_thread::yield();
    EXPECT_EQ(task.fraction(), 0.25F);
    task.wait(0.001);
    EXPECT_FALSE(task.is_done());
    EXPECT_FALSE(task.take());
    task.cancel();
    task.wait(-1.0);
    EXPECT_EQ(**task.take(), 7) << "the partial result";
}

TEST(Background, StartReplacesTheRunningTask) {
    BackgroundTask<int> task;
    task.start(until_canceled);
    task.start([](WorkProgress& progress) { return progress.canceled ? -1 : 8; });
    task.wait(-1.0);
    EXPECT_EQ(**task.take(), 8);
}

TEST(Background, DroppedTaskBlocksNobody) {
    std::atomic<bool> may_end{false}, has_ended{false};
    {
        BackgroundTask<int> task;
        task.start([&](WorkProgress&) {  // ignores cancellation
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
    EXPECT_TRUE(has_ended) << "shutdown waits for it";
}

TEST(Background, DestructorCancelsAndWaits) {
    bool ended = false;
    {
        BackgroundTask<int> task;
        task.start([&ended](WorkProgress& progress) {
            const int result = until_canceled(progress);
            ended = true;
            return result;
        });
    }
    EXPECT_TRUE(ended);
}

TEST(Background, ExceptionBecomesASentence) {
    BackgroundTask<int> task;
    const auto sentence_of = [&task](const std::function<int()>& work) {
        task.start([work](WorkProgress&) { return work(); });
        task.wait(-1.0);
        const std::optional<Result<int>> result = task.take();
        EXPECT_FALSE(task.is_running());
        return result && !*result ? result->error() : "no error";
    };
    EXPECT_EQ(sentence_of([]() -> int { throw std::runtime_error("out of paper"); }),
              "the computation stopped: out of paper");
    EXPECT_EQ(sentence_of([]() -> int { throw std::bad_alloc(); }), "the computation stopped: not enough memory");
    EXPECT_EQ(sentence_of([]() -> int { throw 7; }), "the computation stopped for an unknown reason");
    task.start([](WorkProgress&) -> Result<int> { return Error{"an error stays as it is"}; });
    task.wait(-1.0);
    EXPECT_EQ(task.take()->error(), "an error stays as it is");
    task.start([](WorkProgress&) { return 1; });
    task.wait(-1.0);
    EXPECT_EQ(**task.take(), 1);
}

BackgroundTask<int>* watched = nullptr;
std::atomic<int> wakes_after_the_end{0};

TEST(Background, WakesASleepingCallerAtTheEnd) {
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
    EXPECT_EQ(wakes_after_the_end, 1) << "the woken caller finds the result";
    task.start([](WorkProgress&) -> int { throw std::bad_alloc(); });
    task.wait(-1.0);
    task = {};
    EXPECT_EQ(wakes_after_the_end, 1) << "no more wake-ups";
}

TEST(Background, LogKeepsTheOrderOfItsEntries) {
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

TEST(Progress, IsNeverCanceledWithoutWork) {
    report(nullptr, 0.5);
    EXPECT_FALSE(is_canceled(nullptr));
}

TEST(Progress, PartFillsItsShareOfTheWhole) {
    WorkProgress whole;
    WorkProgress part{.whole = &whole, .begin = 0.5, .end = 0.75};
    report(&part, 0.5);
    EXPECT_EQ(part.fraction, 0.5F);
    EXPECT_EQ(whole.fraction, 0.625F);
    report(&part, 0.25);
    EXPECT_EQ(part.fraction, 0.25F) << "the part starts again";
    EXPECT_EQ(whole.fraction, 0.625F) << "never decreases";
    report(&part, 1.0);
    EXPECT_EQ(whole.fraction, 0.75F);
}

TEST(Progress, CancelingTheWholeCancelsThePartButNotViceVersa) {
    WorkProgress whole;
    WorkProgress part{.whole = &whole};
    part.canceled = true;
    EXPECT_TRUE(is_canceled(&part));
    EXPECT_FALSE(is_canceled(&whole));
    part.canceled = false;
    EXPECT_FALSE(is_canceled(&part));
    whole.canceled = true;
    EXPECT_TRUE(is_canceled(&part));
}

TEST(Progress, DeadlineCancels) {
    using namespace std::chrono_literals;
    const auto now = WorkProgress::Clock::now();
    const WorkProgress late{.deadline = now - 1s}, early{.deadline = now + 1h};
    EXPECT_TRUE(is_late(late));
    EXPECT_TRUE(is_canceled(&late));
    EXPECT_FALSE(is_late(early));
    EXPECT_FALSE(is_canceled(&early));
}

}  // namespace
}  // namespace viewing
