#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "common/particles.hpp"
#include "solver/backend/buffer.hpp"
#include "solver/backend/device.hpp"
#include "solver/backend/ranks.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"

// Births and deaths. Neither wears the lists out: one that dies is parked, without volume, until the lists are made
// anew for another reason; one that is born waits for that moment. Where particles enter, the zone that holds them
// ready (Role::prescribed) has to be one list reach wide, the support with its skin: then nothing is missing in the
// support of an integrated particle while births wait.
//
// Excluded particles are another matter: they left the domain where nothing was meant to, which is an error that the
// run counts and limits (numerics.excluded_limit).
namespace thalweg {

/// A particle that is to be born.
struct Newborn {
  Position position{};
  float velocity[3] = {0, 0, 0};  // [m/s]
  float mass = 0;                 // [kg]
  float excess = 0;               // rho/rho0 - 1 [-]
  float viscosity = 0;            // [Pa s]
  double grains = 0;              // [m^dim] that water carries
  float kind = kind::water;
  std::uint8_t type = 2;  // ParticleType::water
  Role role = Role::integrated;
};

/// Who is born and who dies; ids and the mass ledger. Lives on the host.
class Population {
 public:
  /// next_id: the first id nobody has.
  Population() = default;
  Population(std::int64_t next_id, const MassLedger& ledger) : next_id_(next_id), ledger_(ledger) {}

  /// Goes on from a checkpoint, or starts with the ids of a filled scene.
  static Population of(const ParticleSet& from);
  /// Adds to a checkpoint what of() needs, in place of what it holds of that.
  void add_to(ParticleSet& out) const;

  [[nodiscard]] const MassLedger& ledger() const { return ledger_; }
  [[nodiscard]] std::int64_t next_id() const { return next_id_; }
  [[nodiscard]] const std::vector<Newborn>& waiting() const { return waiting_; }

  /// Queues a birth. Ids follow the order of the queue, so that equal runs give equal ids.
  void bear(const Newborn& newborn) { waiting_.push_back(newborn); }

  void count_lost(const std::vector<ExcludedParticle>& excluded) {
    for (const ExcludedParticle& particle : excluded) ledger_.lost += double(particle.mass);
  }

  /// Parks the fluid particles for which dies(i) is true.
  template <class Device, class Dies>
  void bury(Device& on, Particles<Device>& p, const Dies& dies);

  /// Gives every particle a role, if it has none yet.
  template <class Device>
  static void open(Device& on, Particles<Device>& p) {
    if (p.role.size() != p.count) on.fill(p.role, p.count, Role::integrated);
    p.has_roles = true;
  }

  /// Appends the particles that wait to all arrays; the lists have to be made anew next. On several ranks, all of which
  /// know who waits, the last one has them, so that they come after all others as they do on one.
  template <int Dim, class Device>
  void admit(Device& on, Particles<Device>& p, const Scene<Dim>& scene);

 private:
  std::int64_t next_id_ = 0;
  MassLedger ledger_;
  std::vector<Newborn> waiting_;
};

/// Names of a checkpoint's facts: next id and ledger; and those who wait to be born, thirteen numbers each.
namespace checkpoint_fact {
inline constexpr const char* population = "Population";
inline constexpr const char* waiting = "WaitingToBeBorn";
}  // namespace checkpoint_fact

inline Population Population::of(const ParticleSet& from) {
  Population made;
  const auto known = from.facts.find(checkpoint_fact::population);
  if (known == from.facts.end()) {
    for (const std::int64_t id : from.id) made.next_id_ = std::max(made.next_id_, id + 1);
    return made;
  }
  const std::vector<double>& numbers = known->second;
  if (numbers.size() != 4) {
    throw InputError("the checkpoint's field data Population has " + std::to_string(numbers.size()) +
                     " numbers and needs 4; start from a whole checkpoint");
  }
  made.next_id_ = static_cast<std::int64_t>(numbers[0]);
  made.ledger_ = {numbers[1], numbers[2], numbers[3]};
  const auto waiting = from.facts.find(checkpoint_fact::waiting);
  if (waiting == from.facts.end()) return made;
  constexpr std::size_t each = 13;
  for (std::size_t at = 0; at + each <= waiting->second.size(); at += each) {
    const double* n = waiting->second.data() + at;
    Newborn b;
    for (int c = 0; c < 3; ++c) b.position.x[c] = n[c], b.velocity[c] = static_cast<float>(n[3 + c]);
    b.mass = static_cast<float>(n[6]);
    b.excess = static_cast<float>(n[7]);
    b.viscosity = static_cast<float>(n[8]);
    b.kind = static_cast<float>(n[9]);
    b.type = static_cast<std::uint8_t>(n[10]);
    b.role = static_cast<Role>(static_cast<std::uint8_t>(n[11]));
    b.grains = n[12];
    made.waiting_.push_back(b);
  }
  return made;
}

inline void Population::add_to(ParticleSet& out) const {
  out.facts[checkpoint_fact::population] = {static_cast<double>(next_id_), ledger_.in, ledger_.out, ledger_.lost};
  out.facts.erase(checkpoint_fact::waiting);
  if (waiting_.empty()) return;
  std::vector<double>& numbers = out.facts[checkpoint_fact::waiting];
  for (const Newborn& b : waiting_) {
    numbers.insert(numbers.end(), b.position.x, b.position.x + 3);
    numbers.insert(numbers.end(), b.velocity, b.velocity + 3);
    numbers.insert(numbers.end(), {double(b.mass), double(b.excess), double(b.viscosity), double(b.kind),
                                   double(b.type), double(static_cast<std::uint8_t>(b.role)), b.grains});
  }
}

/// Parks a particle and returns its mass [kg].
template <class Dies>
struct Burial {
  using reads = typename Dies::reads::template With<field::mass, field::role>;
  using writes = Writes<field::place, field::flow, field::rates, field::role>;

  Record* records;
  Rates* rates;
  Role* roles;
  const float* mass;
  Dies dies;

  HOST_DEVICE double operator()(Index i) const {
    if (roles[i] == Role::dormant || records[i].volume == 0 || !dies(i)) return 0;
    Record& r = records[i];
    r.volume = 0;
    r.pressure = 0;
    for (float& u : r.velocity) u = 0;
    rates[i] = {};
    roles[i] = Role::dormant;
    return mass[i];
  }
};

template <class Device, class Dies>
void Population::bury(Device& on, Particles<Device>& p, const Dies& dies) {
  open(on, p);
  ledger_.out +=
      on.reduce(p.fluid(), 0.0, Burial<Dies>{p.record.data(), p.rates.data(), p.role.data(), p.mass.data(), dies},
                [] HOST_DEVICE(double a, double b) { return a + b; });
}

/// Makes room for more particles in every array and fills it with newborn values.
template <class Device, class Buffer, class T>
void append(Device& on, Buffer& buffer, std::size_t from, std::size_t more, const T& value) {
  buffer.resize(from + more);
  T* at = buffer.data() + from;
  on.for_each(static_cast<Index>(more), declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index i) { at[i] = value; }));
}

/// Copies numbers from the host to the end of an array.
template <class Device, class T>
void write_behind(Device& on, typename Device::template Buffer<T>& buffer, std::size_t from, HostBuffer<T> numbers) {
  typename Device::template Buffer<T> uploaded;
  const auto more = static_cast<Index>(numbers.size());
  on.upload(std::move(numbers), uploaded);
  buffer.resize(from + more);
  T* to = buffer.data() + from;
  const T* source = uploaded.data();
  on.for_each(more, declare<Reads<>, Writes<>>([=] HOST_DEVICE(Index i) { to[i] = source[i]; }));
}

template <int Dim, class Device>
void Population::admit(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  if (waiting_.empty()) return;
  open(on, p);
  const std::size_t more = waiting_.size();
  const Index before = p.count;
  HostBuffer<Record> records(more + 1, Record{});
  HostBuffer<Position> positions(more);
  HostBuffer<float> masses(more);
  HostBuffer<std::int64_t> ids(more);
  HostBuffer<std::uint8_t> types(more);
  HostBuffer<Role> roles(more);
  HostBuffer<double> grains(more);
  for (std::size_t n = 0; n < more; ++n) {
    const Newborn& b = waiting_[n];
    Record& r = records[n];
    for (int k = 0; k < Dim; ++k) r.place[axis<Dim>(k)] = scene.lattice.place(k, b.position.x[axis<Dim>(k)]);
    for (int c = 0; c < 3; ++c) r.velocity[c] = b.velocity[c];
    r.kind = b.kind;
    r.excess = b.excess;
    r.viscosity = b.viscosity;
    r.volume = b.mass / (scene.density_at_rest(b.kind) * (1 + b.excess));  // as the equation of state does
    r.pressure = tait_pressure(b.excess, scene.stiffness(b.kind));
    positions[n] = b.position;
    masses[n] = b.mass;
    ids[n] = next_id_++;
    types[n] = b.type;
    roles[n] = b.role;
    grains[n] = b.grains;
    ledger_.in += double(b.mass);
  }
  EachArray grow(sorted,
                 [&](const Field&, auto& buffer, const auto& newborn) { append(on, buffer, before, more, newborn); });
  waiting_.clear();
  if (on.shared != nullptr && on.shared->ranks.rank() + 1 != on.shared->ranks.size()) return;
  p.describe(scene, grow);
  write_behind(on, p.record, before, std::move(records));
  write_behind(on, p.position, before, std::move(positions));
  write_behind(on, p.mass, before, std::move(masses));
  write_behind(on, p.id, before, std::move(ids));
  write_behind(on, p.type, before, std::move(types));
  write_behind(on, p.role, before, std::move(roles));
  if (scene.water_has_grains) write_behind(on, p.grains, before, std::move(grains));
  p.count += static_cast<Index>(more);
}

}  // namespace thalweg
