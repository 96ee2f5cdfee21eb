#pragma once

#include <concepts>
#include <span>
#include <utility>

#include "solver/state/cluster_list.hpp"
#include "solver/state/pair_geometry.hpp"

// The contracts between passes and backends. A device offers verbs (backend/openmp.hpp says what each does); a body is
// what a verb runs for every particle or pair, and declares the fields it touches.
namespace thalweg {

/// The fields that a body touches: of other particles, of its own particle, and those it writes.
struct Access {
  std::span<const Field* const> neighbours = {};
  std::span<const Field* const> reads = {};
  std::span<const Field* const> writes = {};
};

/// Told of every body before and after a device runs it. A domain of several machines exchanges here the neighbours'
/// fields that have become stale; a test checks the declarations. None on one machine: nullptr.
class AccessListener {
 public:
  virtual ~AccessListener() = default;
  /// `flag`: a number on the device; if it is 0 the body is skipped. nullptr: it runs.
  virtual void before(const Access& access, const int* flag) = 0;
  virtual void after(const Access& access, const int* flag) = 0;
  /// In place of before() where a body can run in two parts. True: neighbours' fields are on their way, and arrive() is called
  /// before clusters with copies in their lists are visited.
  virtual bool begin(const Access& access, const int* flag) {
    before(access, flag);
    return false;
  }
  virtual void arrive() {}
  /// Lets what is on its way go on, in the thread that has called begin().
  virtual void progress() {}
};

/// Every body: `using reads = Fields<…>` of its own particle, `using writes = Fields<…>`.
template <class Body>
concept DeclaresFields = requires {
  typename Body::reads;
  typename Body::writes;
};

/// A body that looks at other particles says at which of their fields: `using neighbours = Fields<…>`.
template <class Body>
concept DeclaresNeighbours = DeclaresFields<Body> && requires {
  typename Body::neighbours;
};

/// A pair sweep's body: which parts of the kernel it needs, a sum of lanes, pair() and end().
template <class Body, int Dim>
concept SweepBody = DeclaresNeighbours<Body> &&
    requires(const Body& body, const Lane<Dim, float, std::int32_t>& lane, const PairGeometry<Dim, float>& geometry,
             std::size_t entry, typename Body::template Sum<float>& sum, Index i) {
  { Body::kernel } -> std::convertible_to<unsigned>;
  body.pair(lane, lane, geometry, entry, sum);
  body.end(i, sum);
};

/// The verbs that every backend offers. Those that take bodies are checked where they are called.
template <class D>
concept Device = requires(D on, typename D::template Buffer<float>& numbers,
                          typename D::template Buffer<Index>& indices, typename D::template Buffer<std::uint64_t>& keys,
                          const int* flag, std::int64_t* counter) {
  typename D::PairCoefficient;
  { D::is_host } -> std::convertible_to<bool>;
  { on.stores_coefficients() } -> std::convertible_to<bool>;
  D::atomic_add(counter, std::int64_t{1});
  on.fill(numbers, std::size_t{1}, 0.0F);
  on.download(numbers);
  on.write(0.0F, numbers.data());
  { on.read(numbers.data()) } -> std::same_as<float>;
  { on.skip_unless(flag) } -> std::same_as<const int*>;
  { on.exclusive_scan(indices, indices) } -> std::same_as<Index>;
  on.sort_by_key(keys, indices);
  on.reorder(numbers, indices, numbers);
  on.async_download();
  on.finish();
};

/// The fields that a body declares. A body without declarations has none, and the checks below refuse it.
template <class Body>
consteval Access declared_access() {
  Access access;
  if constexpr (DeclaresNeighbours<Body>) access.neighbours = Body::neighbours::list;
  if constexpr (DeclaresFields<Body>) {
    access.reads = Body::reads::list;
    access.writes = Body::writes::list;
  }
  return access;
}
template <class Body>
inline constexpr Access access_of = declared_access<Body>();

/// Compile-time checks with one message each; every verb makes one of them.
template <class Body>
constexpr void require_particle_body() {
  static_assert(DeclaresFields<Body>,
                "a body declares its fields: `using reads = Fields<...>; using writes = Fields<...>;` (a lambda: "
                "declare<Reads<...>, Writes<...>>(lambda), backend/device.hpp)");
}
template <class Body, int Dim>
constexpr void require_sweep_body() {
  static_assert(DeclaresFields<Body>,
                "a sweep's body declares its fields: `using reads = Fields<...>; using writes = Fields<...>;`");
  static_assert(!DeclaresFields<Body> || DeclaresNeighbours<Body>,
                "a sweep's body declares what it reads of both particles of a pair: `using neighbours = Fields<...>;`");
  static_assert(!DeclaresNeighbours<Body> || SweepBody<Body, Dim>,
                "a sweep's body has `static constexpr unsigned kernel`, `template <class L> struct Sum`, "
                "pair(a, b, geometry, entry, sum) and end(i, sum) (backend/openmp.hpp, sweep)");
}

template <const Field&... fields>
using Reads = Fields<fields...>;
template <const Field&... fields>
using Writes = Fields<fields...>;
template <const Field&... fields>
using Neighbours = Fields<fields...>;

/// A lambda with the fields it touches.
template <class ReadFields, class WrittenFields, class Lambda>
struct Declared {
  using reads = ReadFields;
  using writes = WrittenFields;
  Lambda lambda;
  template <class... Arguments>
  HOST_DEVICE auto operator()(const Arguments&... arguments) const {
    return lambda(arguments...);
  }
};
/// The same of a lambda that looks at other particles.
template <class NeighbourFields, class ReadFields, class WrittenFields, class Lambda>
struct DeclaredWithNeighbours : Declared<ReadFields, WrittenFields, Lambda> {
  using neighbours = NeighbourFields;
};

template <class ReadFields, class WrittenFields, class Lambda>
auto declare(Lambda lambda) {
  return Declared<ReadFields, WrittenFields, Lambda>{std::move(lambda)};
}
template <class NeighbourFields, class ReadFields, class WrittenFields, class Lambda>
auto declare(Lambda lambda) {
  return DeclaredWithNeighbours<NeighbourFields, ReadFields, WrittenFields, Lambda>{{std::move(lambda)}};
}

/// Tells a listener, if there is one, what runs while this lives.
class Announcement {
 public:
  Announcement(AccessListener* listener, const Access& access, const int* flag)
      : listener_(listener), access_(access), flag_(flag) {
    if (listener_ != nullptr) listener_->before(access_, flag_);
  }
  /// Of a sweep over these lists, which visits its clusters in_parts().
  Announcement(AccessListener* listener, const Access& access, const int* flag, const ClusterList& list)
      : listener_(listener), access_(access), flag_(flag), marks_(list.marks) {
    if (listener_ == nullptr) return;
    if (marks_ == nullptr) {
      listener_->before(access_, flag_);
    } else {
      is_awaited_ = listener_->begin(access_, flag_);
    }
  }
  ~Announcement() {
    arrive();
    if (listener_ != nullptr) listener_->after(access_, flag_);
  }
  Announcement(const Announcement&) = delete;
  Announcement& operator=(const Announcement&) = delete;

  /// visit(part) for a whole range of clusters; while copies of other ranks' particles are on their way, for those that need
  /// none, and for the others when they are there.
  template <class Visit>
  void in_parts(const Visit& visit) {
    if (!is_awaited_) return visit(ClusterPart{});
    visit(ClusterPart{marks_, false});
    arrive();
    visit(ClusterPart{marks_, true});
  }
  /// For a sweep to call now and then, in the thread that it began in.
  void progress() const {
    if (is_awaited_) listener_->progress();
  }

 private:
  void arrive() {
    if (std::exchange(is_awaited_, false)) listener_->arrive();
  }

  AccessListener* listener_;
  const Access& access_;
  const int* flag_;
  const std::uint8_t* marks_ = nullptr;
  bool is_awaited_ = false;
};

}  // namespace thalweg
