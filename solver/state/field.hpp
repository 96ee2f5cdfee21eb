#pragma once

#include <array>
#include <cstddef>

namespace thalweg {

/// Four numbers of a record that are loaded together (state/record.hpp).
enum Quads : unsigned { quad_place = 1, quad_flow = 2, quad_matter = 4, quad_work = 8 };

/// A part of what is known of a particle: a quad of its record, one meaning of the record's work quad, or an array of
/// its own. Bodies name the fields they read and write; checkpoints and tests use the same names.
struct Field {
  const char* name;
  unsigned quad = 0;  // Quads; 0 for an array
};

/// A list of fields, known at compile time: `using reads = Fields<field::place, field::flow>;`
template <const Field&... fields>
struct Fields {
  static constexpr unsigned quads = (0U | ... | fields.quad);
  static constexpr std::size_t size = sizeof...(fields);
  static constexpr std::array<const Field*, size> list{&fields...};

  template <const Field&... more>
  using With = Fields<fields..., more...>;
};

namespace field {

// Of the record.
inline constexpr Field place{"place", quad_place};     // place, volume
inline constexpr Field flow{"flow", quad_flow};        // velocity, pressure
inline constexpr Field matter{"matter", quad_matter};  // density excess, viscosity, kind, dissipation

// Arrays that every scene has. A model declares its own fields beside its arrays.
inline constexpr Field position{"Position"};
inline constexpr Field mass{"Mass"};
inline constexpr Field loaded_mass{"LoadedMass"};
inline constexpr Field id{"Id"};
inline constexpr Field type{"Type"};
inline constexpr Field rates{"Rates"};
inline constexpr Field dissipation{"Dissipation"};
inline constexpr Field role{"Role"};
inline constexpr Field listed_at{"ListedAt"};

/// Any array: of code that copies whatever is described to it.
inline constexpr Field any{"*"};

}  // namespace field

}  // namespace thalweg
