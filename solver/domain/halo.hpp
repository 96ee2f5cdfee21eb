#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/backend/device.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"

// Packing of fields, for copies of particles on another machine. The parts of a message follow from the declared arrays
// (`halo`) and from the quads of the record. A message lies where the device and the ranks both reach it (Device::Message).
namespace thalweg {

/// Particle pass: gathers entries, or quads of records.
template <class T>
struct PackPass {
  using reads = Reads<field::any>;
  using writes = Writes<>;
  const T* from;
  std::size_t stride;  // entries of T from one particle to the next
  const Index* of;
  T* to;
  HOST_DEVICE void operator()(Index n) const { to[n] = from[of[n] * stride]; }
};

/// Particle pass: the way back.
template <class T>
struct UnpackPass {
  using reads = Reads<>;
  using writes = Writes<field::any>;
  const T* from;
  const Index* of;
  std::size_t stride;
  T* to;
  HOST_DEVICE void operator()(Index n) const { to[of[n] * stride] = from[n]; }
};

/// A quad of a record as it travels.
struct alignas(16) PackedQuad {
  float v[4];
};

/// Fields that lie beside the particles' arrays, a quad each: where their quads are, or nullptr.
using FieldsBeside = std::function<PackedQuad*(const Field&)>;

/// Calls part(entries, stride) for every part of a message with these fields: quads of the record in the order of their
/// bits, then the arrays in the order of their declaration, then the fields beside them. Throws std::logic_error for a field
/// of which there are no copies.
template <int Dim, class Device, class Part>
void for_each_halo_part(Particles<Device>& p, const Scene<Dim>& scene, const std::vector<const Field*>& fields,
                        const FieldsBeside& beside, const Part& part) {
  unsigned quads = 0;
  for (const Field* field : fields) quads |= field->quad;
  auto* records = reinterpret_cast<PackedQuad*>(p.record.data());
  constexpr std::size_t in_record = sizeof(Record) / sizeof(PackedQuad);
  for (std::size_t q = 0; q < in_record; ++q) {
    if ((quads & (1U << q)) != 0) part(records + q, in_record);
  }
  std::vector<const Field*> found;
  EachArray arrays(halo, [&](const Field& field, auto& buffer, const auto&) {
    if (std::find(fields.begin(), fields.end(), &field) == fields.end()) return;
    part(buffer.data(), std::size_t{1});
    found.push_back(&field);
  });
  p.describe(scene, arrays);
  for (const Field* field : fields) {
    if (field->quad != 0 || std::find(found.begin(), found.end(), field) != found.end()) continue;
    PackedQuad* const quads_beside = beside ? beside(*field) : nullptr;
    if (quads_beside == nullptr) {
      throw std::logic_error(std::string("a body reads the field ") + field->name +
                             " of neighbours, of which other ranks' particles have no copy: declare its array as halo");
    }
    part(quads_beside, std::size_t{1});
  }
}

/// Bytes of a part of a message. Parts begin at multiples of a quad, so that a device can load their numbers.
template <class T>
std::size_t part_bytes(std::size_t n) {
  constexpr std::size_t unit = sizeof(PackedQuad);
  return (n * sizeof(T) + unit - 1) / unit * unit;
}

/// Bytes of a message with these fields of n particles.
template <int Dim, class Device>
std::size_t halo_bytes(Particles<Device>& p, const Scene<Dim>& scene, const std::vector<const Field*>& fields,
                       const FieldsBeside& beside, std::size_t n) {
  std::size_t bytes = 0;
  for_each_halo_part(p, scene, fields, beside, [&](auto* entries, std::size_t) {
    bytes += part_bytes<std::remove_cvref_t<decltype(*entries)>>(n);
  });
  return bytes;
}

/// Packs these fields of the particles `of` into a message of halo_bytes(). The device need not be done with it.
template <int Dim, class Device>
void pack(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const std::vector<const Field*>& fields,
          const typename Device::template Buffer<Index>& of, const FieldsBeside& beside, std::byte* message) {
  const auto n = static_cast<Index>(of.size());
  for_each_halo_part(p, scene, fields, beside, [&](auto* entries, std::size_t stride) {
    using T = std::remove_cvref_t<decltype(*entries)>;
    on.for_each(n, PackPass<T>{entries, stride, of.data(), reinterpret_cast<T*>(message)});
    message += part_bytes<T>(n);
  });
}

/// Unpacks a message of the same fields into the particles `of`.
template <int Dim, class Device>
void unpack(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const std::vector<const Field*>& fields,
            const std::byte* message, const typename Device::template Buffer<Index>& of, const FieldsBeside& beside) {
  const auto n = static_cast<Index>(of.size());
  for_each_halo_part(p, scene, fields, beside, [&](auto* entries, std::size_t stride) {
    using T = std::remove_cvref_t<decltype(*entries)>;
    on.for_each(n, UnpackPass<T>{reinterpret_cast<const T*>(message), of.data(), stride, entries});
    message += part_bytes<T>(n);
  });
}

}  // namespace thalweg
