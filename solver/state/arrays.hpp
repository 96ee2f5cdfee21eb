#pragma once

#include "solver/state/field.hpp"

// One declaration per particle array. Whoever brings arrays (ParticleCore, a model) lists each once in describe():
//
//   template <class Visitor>
//   void describe(Visitor& v) {
//     v.array(field::age, age, sorted | checkpointed | halo, 0.0F);              // newborn particles have 0
//     v.shown("Age", age);                                                       // an array of floats, in snapshots
//     v.shown("StrainRate", sediment, &Sediment::strain_rate);                   // one number of a struct
//     v.shown_kind("Resting", [](float kind) { … });                             // a number that the kind decides
//   }
//
// Visitors derive the rest: sorting and truncating (lists/sort.hpp), loading and checkpoints (simulation/checkpoint.hpp),
// snapshots (simulation/snapshot.hpp), bytes (simulation/memory.hpp), halos and newborn values (domain/).
namespace thalweg {

/// The treatment of an array. `sorted`: follows its particles when they are sorted, and dies with them; without it the
/// array is scratch that a pass fills anew. `checkpointed`: a restart needs it. `halo`: a sweep may read it of
/// particles that another machine owns.
enum ArrayTraits : unsigned { scratch = 0, sorted = 1, checkpointed = 2, halo = 4 };

constexpr ArrayTraits operator|(ArrayTraits a, ArrayTraits b) {
  return static_cast<ArrayTraits>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}

/// The form in which snapshots show a number of an array.
struct ShownAs {
  float unit = 1;           // what the number is divided by
  bool fluid_only = false;  // the array says nothing of walls
  float otherwise = 0;      // shown of walls then, and of all particles before the array is first filled
};

/// A visitor for which the snapshot's numbers mean nothing.
struct ArraysOnly {
  template <class Buffer>
  void shown(const char*, const Buffer&) {}
  template <class Buffer, class Member>
  void shown(const char*, const Buffer&, Member, const ShownAs& = {}) {}
  void shown_kind(const char*, float (*)(float)) {}
};

/// Calls visit(array, newborn value) for every array with one of the traits; a visitor for code that treats all alike.
template <class Visit>
struct EachArray : ArraysOnly {
  ArrayTraits wanted;
  Visit visit;
  EachArray(ArrayTraits traits, Visit call) : wanted(traits), visit(call) {}

  template <class Buffer, class T>
  void array(const Field& name, Buffer& buffer, ArrayTraits traits, const T& newborn) {
    if (wanted == scratch || (traits & wanted) != 0) visit(name, buffer, newborn);
  }
};

}  // namespace thalweg
