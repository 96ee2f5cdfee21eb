#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "solver/simulation/load.hpp"
#include "solver/step.hpp"
#include "tests/solver/backend/device_scenes.hpp"
#include "tests/solver/guarded_runtime.hpp"

// Bodies touch the fields that they declare and no others. While a body runs, arrays that it does not declare are closed, and arrays that it only reads cannot be written; a body that touches them ends the test with a signal. The
// quads of the record are compared before and after.
namespace thalweg::test {
namespace {

using OnDevice = Gpu<GuardedRuntime>;

bool contains(std::span<const Field* const> fields, const Field* field) {
  return std::find(fields.begin(), fields.end(), field) != fields.end();
}

unsigned quads_of(std::span<const Field* const> fields) {
  unsigned quads = 0;
  for (const Field* field : fields) quads |= field->quad;
  return quads;
}

class DeclaredFields : public AccessListener {
 public:
  DeclaredFields(OnDevice& on, Particles<OnDevice>& p, const Scene<2>& scene) : on_(on), p_(p), scene_(scene) {}

  int bodies = 0;
  int closed = 0;  // arrays, summed over bodies

  void before(const Access& access, const int* flag) override {
    if (is_skipped(flag)) return;
    ++bodies;
    runs_ = true;
    check_work(access);
    records_before_ = records();
    if (contains(access.reads, &field::any) || contains(access.writes, &field::any)) return;
    auto& limits = GuardedRuntime::limits();
    const auto limit = [&](const void* memory, bool reads, bool writes) {
      if (memory == nullptr) return;
      limits[memory] = writes ? PROT_READ | PROT_WRITE : reads ? PROT_READ : PROT_NONE;
      closed += reads || writes ? 0 : 1;
    };
    const unsigned written = quads_of(access.writes);
    limit(p_.record.data(), (quads_of(access.reads) | quads_of(access.neighbours)) != 0, written != 0);
    const auto array = [&](const Field& field, const void* memory) {
      limit(memory, contains(access.reads, &field) || contains(access.neighbours, &field),
            contains(access.writes, &field));
    };
    array(field::listed_at, p_.listed_at.data());
    EachArray each(scratch, [&](const Field& field, auto& buffer, const auto&) { array(field, buffer.data()); });
    p_.describe(scene_, each);
  }

  void after(const Access& access, const int*) override {
    GuardedRuntime::limits().clear();
    if (!std::exchange(runs_, false)) return;
    const unsigned written = quads_of(access.writes);
    const std::vector<Record> now = records();
    if (now.size() != records_before_.size() || contains(access.writes, &field::any)) return;
    for (std::size_t i = 0; i < now.size(); ++i) {
      for (unsigned q = 0; q < 4; ++q) {
        if ((written & (1U << q)) != 0) continue;
        const auto quad = [q](const Record& r) { return reinterpret_cast<const char*>(&r) + 16 * q; };
        ASSERT_EQ(std::memcmp(quad(now[i]), quad(records_before_[i]), 16), 0)
            << "particle " << i << ": quad " << q << " was written by a body that writes " << names(access.writes);
      }
    }
    for (const Field* field : access.writes) {
      if (field->quad == quad_work) in_work_ = field;
    }
  }

 private:
  [[nodiscard]] bool is_skipped(const int* flag) const { return flag != nullptr && on_.read(flag) == 0; }

  /// The work quad has one meaning at a time: what is read there was written last.
  void check_work(const Access& access) {
    for (const auto fields : {access.neighbours, access.reads}) {
      for (const Field* field : fields) {
        if (field->quad != quad_work) continue;
        ASSERT_EQ(in_work_, field) << field->name << " is read where "
                                   << (in_work_ == nullptr ? "nothing" : in_work_->name) << " was written last";
      }
    }
  }

  static std::string names(std::span<const Field* const> fields) {
    std::string all;
    for (const Field* field : fields) all += std::string(all.empty() ? "" : ", ") + field->name;
    return all.empty() ? "nothing" : all;
  }

  [[nodiscard]] std::vector<Record> records() {
    const auto found = on_.download(p_.record);
    return {found.begin(), found.end()};
  }

  OnDevice& on_;
  Particles<OnDevice>& p_;
  const Scene<2>& scene_;
  std::vector<Record> records_before_;
  const Field* in_work_ = nullptr;
  bool runs_ = false;  // the body announced last
};

TEST(DeclaredFieldsTest, EveryBodyOfAStepTouchesWhatItDeclares) {
  for (const DeviceScene& s : device_scenes()) {
    if (!std::holds_alternative<Scene<2>>(s.scene)) continue;
    SCOPED_TRACE(s.name);
    const auto& scene = std::get<Scene<2>>(s.scene);
    OnDevice on;
    Particles<OnDevice> p;
    Workspace<OnDevice> work;
    Timing timing;
    timing.wait_with([] {});  // steps are not recorded: every body runs where it is announced
    load_particles(on, p, scene, s.particles);
    work.motions = s.motions;
    if (scene.has_moving_walls) load_motions(on, p, s.motions, s.particles);
    if (scene.wall_stress.on) load_wall_elements(on, p, scene, s.particles);
    if (scene.surface_bed.on) load_surface_bed(on, p, scene, work, s.surface_bed(s.particles), s.particles);
    if (scene.has_openings) load_openings(on, p, scene, work, s.openings(), s.particles);
    if (scene.current.on) load_control(on, work, scene, s.particles);
    DeclaredFields check(on, p, scene);
    on.listener = &check;
    for (int n = 0; n < 3; ++n) {
      const StepResult result = advance(on, p, scene, work, 1e-4, timing);
      EXPECT_FALSE(has_diverged(result));
      if (n == 1) work.squared_drift = INFINITY;  // the lists are made anew once more
    }
    EXPECT_GT(check.bodies, 20);
    EXPECT_GT(check.closed, check.bodies);
  }
}

/// Writes a field that it does not declare.
struct Liar {
  using reads = Reads<field::flow>;
  using writes = Writes<field::flow>;
  Record* records;
  HOST_DEVICE void operator()(Index i) const { records[i].excess += 1; }
};

/// Reads an array that it does not declare.
struct Peeper {
  using reads = Reads<field::place>;
  using writes = Writes<field::flow>;
  Record* records;
  const float* mass;
  HOST_DEVICE void operator()(Index i) const { records[i].pressure = mass[i]; }
};

TEST(DeclaredFieldsTest, ABodyThatTouchesMoreIsFound) {
  const DeviceScene s = device_scenes().front();
  const auto& scene = std::get<Scene<2>>(s.scene);
  OnDevice on;
  Particles<OnDevice> p;
  load_particles(on, p, scene, s.particles);
  DeclaredFields check(on, p, scene);
  on.listener = &check;
  EXPECT_DEATH(on.for_each(p.fluid_count, Peeper{p.record.data(), p.mass.data()}), "");
  struct Lie {
    static void tell(OnDevice& device, Particles<OnDevice>& particles) {
      device.for_each(particles.fluid_count, Liar{particles.record.data()});
    }
  };
  testing::TestPartResultArray found;
  {
    testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &found);
    Lie::tell(on, p);
  }
  ASSERT_GE(found.size(), 1);
  EXPECT_NE(std::string(found.GetTestPartResult(0).message()).find("quad 2 was written"), std::string::npos);
}

}  // namespace
}  // namespace thalweg::test
