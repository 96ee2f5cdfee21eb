#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "solver/backend/ranks.hpp"
#include "tests/solver/thread_ranks.hpp"

namespace thalweg::test {
namespace {

struct Plus {
  double operator()(double a, double b) const { return a + b; }
};
constexpr Plus plus;
using Tree = BlockTree<double, Plus>;

std::vector<double> uneven_numbers(std::size_t n) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> exponent(-12, 12);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < n; ++i) numbers.push_back((i % 2 == 0 ? 1 : -1) * std::pow(10.0, exponent(random)));
  return numbers;
}

double sum_on(int ranks, const std::vector<double>& numbers, const std::vector<std::size_t>& cuts) {
  std::vector<double> sums(static_cast<std::size_t>(ranks));
  ThreadRanks(ranks).run([&](Ranks& mine) {
    Tree tree(plus);
    const auto r = static_cast<std::size_t>(mine.rank());
    for (std::size_t b = cuts[r]; b < cuts[r + 1]; ++b) tree.add(static_cast<std::int64_t>(b), numbers[b]);
    sums[r] = total_of(mine, tree, 0.0, plus);
  });
  for (const double sum : sums) EXPECT_EQ(sum, sums.front());
  return sums.front();
}

TEST(BlockTree, GivesTheSameBitsWhereverTheBlocksLie) {
  std::mt19937 random(5);
  for (const std::size_t n : {0, 1, 2, 3, 7, 64, 100, 1023, 4097}) {
    const auto numbers = uneven_numbers(n);
    Tree alone(plus);
    for (std::size_t b = 0; b < n; ++b) alone.add(static_cast<std::int64_t>(b), numbers[b]);
    const double expected = alone.total(0.0);
    double plain = 0;
    for (const double number : numbers) plain += number;
    if (n > 1000) {
      EXPECT_NE(plain, expected) << "numbers whose sum does not depend on the order prove nothing";
    }
    for (const int ranks : {1, 2, 3, 5}) {
      std::vector<std::size_t> cuts{0};
      for (int r = 1; r < ranks; ++r) cuts.push_back(random() % (n + 1));  // some ranks have none
      std::sort(cuts.begin(), cuts.end());
      cuts.push_back(n);
      EXPECT_EQ(sum_on(ranks, numbers, cuts), expected) << n << " blocks, " << ranks << " ranks";
    }
  }
}

TEST(BlockTree, RefusesAGap) {
  Tree tree(plus);
  tree.add(0, 1.0);
  tree.add(2, 1.0);
  EXPECT_THROW(tree.total(0.0), std::logic_error);
}

TEST(Ranks, MessagesArriveWhereTheyAreSent) {
  ThreadRanks(4).run([](Ranks& mine) {
    std::vector<Bytes> to(4);
    for (int r = 0; r < 4; ++r) to[static_cast<std::size_t>(r)] = Bytes(static_cast<std::size_t>(10 * mine.rank() + r));
    const auto from = exchange_any(mine, to);
    for (int r = 0; r < 4; ++r) {
      EXPECT_EQ(from[static_cast<std::size_t>(r)].size(), static_cast<std::size_t>(10 * r + mine.rank()));
    }
    Bytes said;
    const int word = 42;
    if (mine.rank() == 0) append_to(said, &word, 1);
    const Bytes heard = broadcast(mine, said);
    EXPECT_EQ(MessageReader(heard).number<int>(), 42);
    std::int64_t numbers[] = {mine.rank(), 1};
    mine.sum(numbers, 2);
    EXPECT_EQ(numbers[0], 6);
    EXPECT_EQ(numbers[1], 4);
  });
}

}  // namespace
}  // namespace thalweg::test
