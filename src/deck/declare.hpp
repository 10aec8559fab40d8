#pragma once
/// The declarations of the deck's keys, as data. Each part of the deck has one function; Schema puts them together.
#include "perinox/deck/key_forms.hpp"

namespace perinox::deck {

/// Declares the whole deck. The models' names become the words of `materials.<name>.model`.
Key declare_deck(const std::vector<ModelDeclaration>& models, const std::vector<FieldDeclaration>& fields);

/// Declares the output fields of every scene, then those that the models add, each once.
std::vector<FieldDeclaration> declare_fields(const std::vector<ModelDeclaration>& models);

/// Declares the definition `shape`, which contains itself.
Key declare_shape();
Key declare_body();
Key declare_cracks();
Key declare_sets();
Key declare_boundary();
Key declare_solver();
Key declare_damage();  ///< of a material
Key declare_fracture();
Key declare_dynamics();
Key declare_explicit();
Key declare_initial_velocity();
Key declare_fallback();
Key declare_hand_over();
Key declare_arc_length();

}  // namespace perinox::deck
