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

struct End {
  ParticleSet particles;
  std::string device;
};

/// Some steps of a scene on the stand-ins for GPUs of some ranks.
End run(const DeviceScene& s, int ranks, const ThreadRanks::Copy& copy) {
  const auto& scene = std::get<Scene<2>>(s.scene);
  const Deal<2> deal(scene, s.particles, ranks);
  End end;
  ThreadRanks(ranks, copy).run([&](Ranks& mine) {
    const DealtShare dealt = deal.share(mine.rank());
    auto share = std::make_unique<SimulationOn<2, Guarded>>(Guarded(true), "guarded", scene, dealt.particles, false,
                                                            std::vector<WallMotion>{}, nullptr, nullptr, &mine,
                                                            dealt.first_block);
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
    const End by_host = run(s, 3, {});
    const End direct = run(s, 3, GuardedRuntime::copy_on_device);
    EXPECT_EQ(by_host.device, "3 ranks of guarded, messages by way of the host");
    EXPECT_EQ(direct.device, "3 ranks of guarded, messages from its memory");
    EXPECT_EQ(direct.particles.id, by_host.particles.id);
    EXPECT_EQ(direct.particles.position, by_host.particles.position);
    EXPECT_EQ(direct.particles.velocity, by_host.particles.velocity);
    EXPECT_EQ(direct.particles.pressure, by_host.particles.pressure);
    EXPECT_EQ(direct.particles.scalars, by_host.particles.scalars);
    EXPECT_NE(direct.particles.position, s.particles.position) << "nothing has moved";
  }
  EXPECT_GE(scenes, 4);
}

}  // namespace
}  // namespace thalweg::test
