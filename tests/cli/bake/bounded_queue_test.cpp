#include "host/cli/ocean/bounded_queue.h"

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace offing::cli {
namespace {

// Fails if an item is lost or handed out twice between several producers and consumers.
TEST(BoundedQueue, HandsEveryItemOverOnce) {
  constexpr int producers = 3;
  constexpr int each = 2000;
  BoundedQueue<int> queue(2);
  std::atomic<long long> sum{0};
  std::atomic<int> count{0};
  {
    std::vector<std::jthread> consumers;
    for (int i = 0; i < 2; ++i) {
      consumers.emplace_back([&] {
        while (const auto item = queue.pop()) {
          sum += *item;
          ++count;
        }
      });
    }
    {
      std::vector<std::jthread> threads;
      for (int i = 0; i < producers; ++i) {
        threads.emplace_back([&queue] {
          for (int item = 1; item <= each; ++item) {
            queue.push(item);
          }
        });
      }
    }
    queue.close();
  }
  EXPECT_EQ(count, producers * each);
  EXPECT_EQ(sum, 3LL * each * (each + 1) / 2);
}

// Fails if closing leaves a producer waiting for room for ever, or takes its item all the same.
TEST(BoundedQueue, ClosingWakesWaitingProducers) {
  BoundedQueue<int> queue(1);
  ASSERT_TRUE(queue.push(1));
  std::atomic<bool> taken{true};
  std::jthread producer([&] { taken = queue.push(2); });
  queue.close();
  producer.join();
  EXPECT_FALSE(taken);
  EXPECT_EQ(queue.pop(), 1);
  EXPECT_EQ(queue.pop(), std::nullopt);
}

// Fails if the queue copies its items: frames are hundreds of megabytes.
TEST(BoundedQueue, MovesItems) {
  BoundedQueue<std::unique_ptr<int>> queue(1);
  queue.push(std::make_unique<int>(7));
  EXPECT_EQ(**queue.pop(), 7);
}

}  // namespace
}  // namespace offing::cli
