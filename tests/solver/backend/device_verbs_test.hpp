#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "solver/backend/device.hpp"
#include "solver/lists/selection.hpp"

// The verbs that every backend has to offer, for a Device named where this is instantiated. Bodies of kernels are
// structs here, because a test's function is private to its class.
namespace thalweg::test {

template <class T, class Device>
typename Device::template Buffer<T> buffer_of(Device& on, std::vector<T> numbers) {
  typename Device::template Buffer<T> buffer;
  on.upload(HostBuffer<T>(numbers.begin(), numbers.end()), buffer);
  return buffer;
}
template <class T, class Device>
std::vector<T> numbers_in(Device& on, const typename Device::template Buffer<T>& buffer) {
  const auto numbers = on.download(buffer);
  return {numbers.begin(), numbers.end()};
}

/// Bodies that touch no particle's fields.
struct NoFields {
  using reads = Reads<>;
  using writes = Writes<>;
};
struct Square : NoFields {
  std::int64_t* to;
  HOST_DEVICE void operator()(Index i) const { to[i] = std::int64_t{i} * i; }
};
struct Entry : NoFields {
  const std::int64_t* from;
  HOST_DEVICE std::int64_t operator()(Index i) const { return from[i]; }
};
struct Plus {
  HOST_DEVICE std::int64_t operator()(std::int64_t a, std::int64_t b) const { return a + b; }
};
struct Store {
  std::int64_t* to;
  HOST_DEVICE void operator()(std::int64_t result) const { *to = result; }
};
struct AddTo : NoFields {
  std::int64_t* to;
  std::int64_t amount;
  HOST_DEVICE void operator()(Index) const { *to += amount; }
};
struct TwiceMore {
  Index than;
  HOST_DEVICE Index operator()(Index i) const { return than + 2 * i; }
};
struct Multiple : NoFields {
  Index of;
  HOST_DEVICE bool operator()(Index i) const { return i % of == 0; }
};
template <class Device>
struct CountRemainder : NoFields {
  std::int64_t* counts;
  Index modulus;
  HOST_DEVICE void operator()(Index i) const { Device::atomic_add(counts + i % modulus, 1); }
};

template <class Device>
class OnDevice : public testing::Test {};
TYPED_TEST_SUITE_P(OnDevice);

TYPED_TEST_P(OnDevice, RunsABodyForEveryIndex) {
  TypeParam on;
  typename TypeParam::template Buffer<std::int64_t> squares;
  squares.resize(1000);
  on.for_each(1000, Square{{}, squares.data()});
  const auto numbers = numbers_in<std::int64_t>(on, squares);
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], std::int64_t(i * i));
  EXPECT_EQ(on.reduce(1000, std::int64_t{0}, Entry{{}, squares.data()}, Plus{}), 332833500);
  EXPECT_EQ(on.reduce(0, std::int64_t{0}, Entry{{}, squares.data()}, Plus{}), 0);
}

TYPED_TEST_P(OnDevice, KeepsWhatABufferHoldsWhenItGrows) {
  TypeParam on;
  auto buffer = buffer_of<std::int64_t>(on, {1, 2, 3});
  buffer.resize(1000);
  EXPECT_EQ(on.download(buffer, 1, 3)[1], 3);
  buffer.resize(2);
  EXPECT_EQ(numbers_in<std::int64_t>(on, buffer), (std::vector<std::int64_t>{1, 2}));
  on.fill(buffer, 5, std::int64_t{9});
  EXPECT_EQ(numbers_in<std::int64_t>(on, buffer), std::vector<std::int64_t>(5, 9));
}

TYPED_TEST_P(OnDevice, ScansAndSelects) {
  TypeParam on;
  std::vector<Index> counts(777);
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = static_cast<Index>(i % 5);
  typename TypeParam::template Buffer<Index> offsets;
  const auto on_device = buffer_of<Index>(on, counts);
  const Index total = on.exclusive_scan(on_device, offsets);
  std::vector<Index> expected(counts.size() + 1, 0);
  std::partial_sum(counts.begin(), counts.end(), expected.begin() + 1);
  EXPECT_EQ(total, expected.back());
  EXPECT_EQ(numbers_in<Index>(on, offsets), expected);

  typename TypeParam::template Buffer<Index> sevens;
  typename TypeParam::template Buffer<Index> none;
  typename TypeParam::template Buffer<Index> many;
  Selection<TypeParam> selection(on);
  selection.choose({nullptr, 20}, Multiple{{}, 7}, sevens);
  selection.choose({nullptr, 0}, Multiple{{}, 7}, none);
  selection.choose(50000, TwiceMore{10}, Multiple{{}, 3}, many);
  selection.finish();
  EXPECT_EQ(numbers_in<Index>(on, sevens), (std::vector<Index>{0, 7, 14}));
  EXPECT_TRUE(none.empty());
  std::vector<Index> all;
  for (Index i = 0; i < 50000; ++i) {
    if ((10 + 2 * i) % 3 == 0) all.push_back(10 + 2 * i);
  }
  EXPECT_EQ(numbers_in<Index>(on, many), all);
}

TYPED_TEST_P(OnDevice, AddsUpAndGoesOnWithoutTheHost) {
  TypeParam on;
  typename TypeParam::template Buffer<std::int64_t> numbers;
  typename TypeParam::template Buffer<std::int64_t> sum;
  numbers.resize(100000);
  sum.resize(1);
  on.for_each(100000, Square{{}, numbers.data()});
  on.reduce_then(100000, std::int64_t{0}, Entry{{}, numbers.data()}, Plus{}, Store{sum.data()});
  EXPECT_EQ(on.read(sum.data()), std::int64_t{333328333350000});
  on.reduce_then(0, std::int64_t{7}, Entry{{}, numbers.data()}, Plus{}, Store{sum.data()});
  EXPECT_EQ(on.read(sum.data()), 7);
}

TYPED_TEST_P(OnDevice, DoesNothingWhileAFlagIsDown) {
  TypeParam on;
  auto flag = buffer_of<int>(on, {0});
  auto numbers = buffer_of<std::int64_t>(on, {1, 1, 1});
  on.skip_unless(flag.data());
  on.for_each(3, Square{{}, numbers.data()});
  on.reduce_then(3, std::int64_t{0}, Entry{{}, numbers.data()}, Plus{}, Store{numbers.data()});
  EXPECT_EQ(numbers_in<std::int64_t>(on, numbers), (std::vector<std::int64_t>{1, 1, 1}));
  on.write(1, flag.data());
  on.for_each(3, Square{{}, numbers.data()});
  EXPECT_EQ(on.skip_unless(nullptr), flag.data());
  EXPECT_EQ(numbers_in<std::int64_t>(on, numbers), (std::vector<std::int64_t>{0, 1, 4}));
}

TYPED_TEST_P(OnDevice, RepeatsWhatItWasAskedForBefore) {
  TypeParam on;
  auto numbers = buffer_of<std::int64_t>(on, {0});
  auto flag = buffer_of<int>(on, {1});
  const auto add = [&] {
    on.skip_unless(flag.data());
    on.for_each(1, AddTo{{}, numbers.data(), 3});
    on.skip_unless(nullptr);
  };
  for (const std::uint64_t key : {0, 1, 1, 1, 2, 2, 0, 1}) on.repeat(key, add);
  EXPECT_EQ(on.read(numbers.data()), 24);
  on.write(0, flag.data());  // what the launches read is read when they are made
  on.repeat(1, add);
  EXPECT_EQ(on.read(numbers.data()), 24);
}

TYPED_TEST_P(OnDevice, SortsStablyAndReorders) {
  TypeParam on;
  const Index n = 5000;
  std::vector<std::uint64_t> keys(n);
  std::vector<Index> order(n);
  for (Index i = 0; i < n; ++i) keys[i] = (std::uint64_t{i} * 2654435761U % 97) << 40, order[i] = i;
  auto key = buffer_of<std::uint64_t>(on, keys);
  auto sorted = buffer_of<Index>(on, order);
  on.sort_by_key(key, sorted);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return keys[a] < keys[b]; });
  EXPECT_EQ(numbers_in<Index>(on, sorted), order);

  std::vector<std::int64_t> numbers(n + 1);  // one more than is sorted: it stays where it is
  std::iota(numbers.begin(), numbers.end(), 0);
  auto values = buffer_of<std::int64_t>(on, numbers);
  typename TypeParam::template Buffer<std::int64_t> scratch;
  on.reorder(values, sorted, scratch);
  const auto moved = numbers_in<std::int64_t>(on, values);
  for (Index i = 0; i < n; ++i) ASSERT_EQ(moved[i], order[i]);
  EXPECT_EQ(moved[n], n);
}

TYPED_TEST_P(OnDevice, AddsWithoutLosingAny) {
  TypeParam on;
  typename TypeParam::template Buffer<std::int64_t> counts;
  on.fill(counts, 3, std::int64_t{0});
  on.for_each(30000, CountRemainder<TypeParam>{{}, counts.data(), 3});
  EXPECT_EQ(numbers_in<std::int64_t>(on, counts), std::vector<std::int64_t>(3, 10000));
}

REGISTER_TYPED_TEST_SUITE_P(OnDevice, RunsABodyForEveryIndex, KeepsWhatABufferHoldsWhenItGrows, ScansAndSelects,
                            AddsUpAndGoesOnWithoutTheHost, DoesNothingWhileAFlagIsDown, RepeatsWhatItWasAskedForBefore,
                            SortsStablyAndReorders, AddsWithoutLosingAny);

}  // namespace thalweg::test
