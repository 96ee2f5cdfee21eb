#include <atomic>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "solver/domain/device_messages.hpp"
#include "solver/simulation/deal.hpp"
#include "solver/simulation/start.hpp"
#include "tests/solver/backend/device_scenes.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/thread_link.hpp"
#include "tests/solver/thread_ranks.hpp"

// Messages that stay in the devices' memory are used where they arrive, and change no bit of a result.
namespace thalweg::test {
namespace {

/// True if all ranks find that messages go between their devices; false if none does.
bool all_find_a_way(int ranks, const ThreadRanks::Copy& copy) {
  std::atomic<int> found = 0;
  ThreadRanks(ranks, copy).run([&](Ranks& mine) {
    Guarded on;
    found += messages_go_between_devices(on, mine) ? 1 : 0;
  });
  EXPECT_TRUE(found == 0 || found == ranks) << found << " of " << ranks << " ranks";
  return found == ranks;
}

TEST(GuardedMessages, GoBetweenDevicesThatTheRanksReach) {
  EXPECT_TRUE(all_find_a_way(2, GuardedRuntime::copy_on_device));
  EXPECT_TRUE(all_find_a_way(3, GuardedRuntime::copy_on_device));
  EXPECT_FALSE(all_find_a_way(1, GuardedRuntime::copy_on_device)) << "there is nobody to send to";
}

TEST(GuardedMessages, GoByWayOfTheHostWhereRanksDoNotReachDevices) { EXPECT_FALSE(all_find_a_way(3, {})); }

// An MPI that says yes and brings something else.
TEST(GuardedMessages, GoByWayOfTheHostWhereOthersArrive) {
  EXPECT_FALSE(all_find_a_way(3, [](void*, const void*, std::size_t) {}));
  EXPECT_FALSE(all_find_a_way(3, [](void* to, const void* from, std::size_t bytes) {
    GuardedRuntime::copy_on_device(to, from, bytes < 4096 ? bytes : bytes - 1);
  })) << "the last byte of a large message is missing";
}

// One rank alone loses a byte; the others go its way.
TEST(GuardedMessages, GoTheSameWayOnAllRanks) {
  EXPECT_FALSE(all_find_a_way(3, [](void* to, const void* from, std::size_t bytes) {
    thread_local const bool loses = [] {
      static std::atomic<int> threads = 0;
      return threads++ == 0;
    }();
    GuardedRuntime::copy_on_device(to, from, loses && bytes > 0 ? bytes - 1 : bytes);
  }));
}

/// Each of three ranks says why it cannot send; nothing where it can.
std::vector<std::string> refusals(const MessageWish& wish) {
  std::vector<std::string> said(3);
  ThreadRanks(3).run([&](Ranks& mine) {
    Guarded on;
    CopyMessages<Guarded> messages;
    try {
      messages.choose(on, mine, wish);
      EXPECT_TRUE(messages.lie_on_devices());
    } catch (const InputError& e) {
      said[static_cast<std::size_t>(mine.rank())] = e.what();
    }
  });
  return said;
}
std::vector<std::string> refusals(LinkMaker& links) { return refusals({MessageWay::nccl, &links}); }

std::vector<std::string> thrice(const std::string& text) { return {3, text}; }

TEST(GuardedLink, IsTakenWhereItBringsTheBytes) {
  ThreadLinks links;
  EXPECT_EQ(refusals(links), thrice(""));
}

// So a particle whose copy were read too early would show in the scenes below.
TEST(GuardedLink, BringsNothingBeforeItIsFinished) {
  ThreadLinks links;
  ThreadRanks(2).run([&](Ranks& mine) {
    Guarded on;
    const auto link = links.link({}, mine, on.queue());
    const Trial<Guarded> trial(on, mine, 1000);
    link->start(trial.to, trial.from);
    EXPECT_FALSE(trial.has_arrived());
    link->finish();
    EXPECT_TRUE(trial.has_arrived());
  });
}

constexpr const char* another_way = "; leave --device-messages away to send another way";

/// Copies what it should, or something else, on one rank.
class FaultyLinks final : public ThreadLinks {
 public:
  explicit FaultyLinks(DeviceCopy copy) : copy_(std::move(copy)) {}
  std::unique_ptr<DeviceLink> link(const LinkPart& first, Ranks& ranks, void* queue) override {
    if (ranks.rank() != 1) return ThreadLinks::link(first, ranks, queue);
    return std::make_unique<ThreadLink>(ranks, copy_);
  }

 private:
  DeviceCopy copy_;
};

TEST(GuardedLink, IsRefusedByAllWhereOneRankReceivesOthers) {
  FaultyLinks nothing_comes([](void*, const void*, std::size_t) {});
  EXPECT_EQ(refusals(nothing_comes),
            thrice("--device-messages nccl: rank 1: a message of 1000 bytes arrives with other bytes" +
                   std::string(another_way)));
  FaultyLinks last_byte_is_lost([](void* to, const void* from, std::size_t bytes) {
    GuardedRuntime::copy_on_device(to, from, bytes < 4096 ? bytes : bytes - 1);
  });
  EXPECT_EQ(refusals(last_byte_is_lost),
            thrice("--device-messages nccl: rank 1: a message of 1048576 bytes arrives with other bytes" +
                   std::string(another_way)));
}

/// A call fails on one rank. The others let go of messages that will not come.
class FailingLinks final : public ThreadLinks {
 public:
  explicit FailingLinks(std::string call) : call_(std::move(call)) {}

  LinkPart part(bool is_first) override {
    if (is_first && call_ == "part") throw RunError("part failed");
    return shares_ ? LinkPart() : ThreadLinks::part(is_first);
  }
  std::unique_ptr<DeviceLink> link(const LinkPart& first, Ranks& ranks, void* queue) override {
    if (ranks.rank() == 2 && call_ == "link") throw RunError("link failed");
    return std::make_unique<Link>(*this, ranks.rank(), ThreadLinks::link(first, ranks, queue));
  }
  std::atomic<int> given_up = 0;

 private:
  class Link final : public DeviceLink {
   public:
    Link(FailingLinks& all, int rank, std::unique_ptr<DeviceLink> inner)
        : all_(all), rank_(rank), inner_(std::move(inner)) {}
    void start(const std::vector<std::span<const std::byte>>& to,
               const std::vector<std::span<std::byte>>& from) override {
      if (rank_ == 1 && all_.call_ == "start") throw RunError("start failed");
      inner_->start(to, from);
    }
    void finish() override {
      inner_->finish();
      if (rank_ == 1 && all_.call_ == "finish") throw RunError("finish failed");
    }
    void give_up() noexcept override { ++all_.given_up; }

   private:
    FailingLinks& all_;
    int rank_;
    std::unique_ptr<DeviceLink> inner_;
  };
  std::string call_;
  bool shares_ = call_ == "none";
};

TEST(GuardedLink, IsRefusedByAllWhereACallFailsOnOneRank) {
  struct Failure {
    const char* call;
    int rank;
    int links;  // that are made before it
  };
  for (const Failure& failure :
       {Failure{"part", 0, 0}, Failure{"link", 2, 2}, Failure{"start", 1, 3}, Failure{"finish", 1, 3}}) {
    FailingLinks links(failure.call);
    EXPECT_EQ(refusals(links), thrice("--device-messages nccl: rank " + std::to_string(failure.rank) + ": " +
                                      failure.call + " failed" + another_way));
    EXPECT_EQ(links.given_up, failure.links) << failure.call;
  }
}

TEST(GuardedLink, NeedsADeviceForEachRank) {
  FailingLinks shared("none");
  EXPECT_EQ(
      refusals(shared),
      thrice("--device-messages nccl: ranks 0 and 1 share a GPU, and NCCL needs one for each; start no more ranks on a "
             "machine than it has GPUs, or leave --device-messages away"));
}

TEST(GuardedMessages, ByMpiAreRefusedWhereTheyDoNotGoBetweenDevices) {
  for (const std::string& said : refusals({MessageWay::mpi})) {
    EXPECT_EQ(said.rfind("--device-messages mpi: this MPI does not send from the memory of the GPUs; ", 0), 0U) << said;
  }
}

struct End {
  ParticleSet particles;
  std::string device;
};

/// Some steps of a scene on the stand-ins for GPUs of some ranks.
End run(const DeviceScene& s, int ranks, const ThreadRanks::Copy& copy, const MessageWish& wish = {}) {
  const auto& scene = std::get<Scene<2>>(s.scene);
  const Deal<2> deal(scene, s.particles, ranks);
  End end;
  ThreadRanks(ranks, copy).run([&](Ranks& mine) {
    const DealtShare dealt = deal.share(mine.rank());
    auto share = std::make_unique<SimulationOn<2, Guarded>>(Guarded(true), "guarded", scene, dealt.particles, false,
                                                            std::vector<WallMotion>{}, nullptr, nullptr, &mine,
                                                            dealt.first_block, wish);
    if (mine.rank() != 0) return follow(*share, mine);
    const auto leader = lead(std::move(share), mine);
    for (int n = 0; n < 6; ++n) leader->advance(1e-3);
    end.particles = leader->full_state();
    end.device = leader->facts().device;
  });
  return end;
}

TEST(GuardedMessages, ThatStayOnDevicesChangeNoBit) {
  int scenes = 0;
  for (const DeviceScene& s : device_scenes()) {
    const bool is_plain = s.motions.empty() && !s.has_openings && s.before_laying.size() == 0;
    if (!is_plain || !std::holds_alternative<Scene<2>>(s.scene) || ++scenes > 4) continue;
    SCOPED_TRACE(s.name);
    const End by_host = run(s, 3, GuardedRuntime::copy_on_device, {MessageWay::host});
    EXPECT_EQ(by_host.device, "3 ranks of guarded, messages by way of the host");
    EXPECT_NE(by_host.particles.position, s.particles.position) << "nothing has moved";
    const End by_default = run(s, 3, {});
    EXPECT_EQ(by_default.device, "3 ranks of guarded, messages by way of the host");
    const End direct = run(s, 3, GuardedRuntime::copy_on_device);
    EXPECT_EQ(direct.device, "3 ranks of guarded, messages from its memory");
    ThreadLinks links;
    const End linked = run(s, 3, {}, {MessageWay::nccl, &links});
    EXPECT_EQ(linked.device, "3 ranks of guarded, messages by NCCL");
    for (const End* other : {&by_default, &direct, &linked}) {
      EXPECT_EQ(other->particles.id, by_host.particles.id);
      EXPECT_EQ(other->particles.position, by_host.particles.position);
      EXPECT_EQ(other->particles.velocity, by_host.particles.velocity);
      EXPECT_EQ(other->particles.pressure, by_host.particles.pressure);
      EXPECT_EQ(other->particles.scalars, by_host.particles.scalars);
    }
  }
  EXPECT_GE(scenes, 4);
}

}  // namespace
}  // namespace thalweg::test
