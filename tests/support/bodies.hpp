#pragma once
/// Decks made in C++ for tests of the rooms body and bonds, files for them, and the sentence of a refusal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "perinox/body/body.hpp"
#include "perinox/bonds/bonds.hpp"
#include "perinox/core/error.hpp"

namespace perinox::body::fixture {

inline deck::Shape shape_of(decltype(deck::Shape::form) form) {
  deck::Shape shape;
  shape.location = {"deck.yaml", 5, 12};
  shape.form = std::move(form);
  return shape;
}

inline void add_body(deck::Deck& deck, const std::string& name, decltype(deck::Shape::form) form, double spacing = 1) {
  deck.body.push_back({{"deck.yaml", 4, 5}, name, shape_of(std::move(form)), spacing, "rubber"});
}

/// A deck without bodies. The horizon is 3.015 times the spacing.
inline deck::Deck empty_deck(deck::Dimension dimension = deck::Dimension::three) {
  deck::Deck deck;
  deck.file = "deck.yaml";
  deck.dimension = dimension;
  deck.horizon.ratio = 3.015;
  deck.materials.push_back({{}, "rubber", "elastic", {}});
  return deck;
}

/// A deck with one body of a shape, at spacing 1 unless another is given.
inline deck::Deck deck_of(decltype(deck::Shape::form) form, deck::Dimension dimension = deck::Dimension::three,
                          double spacing = 1) {
  deck::Deck deck = empty_deck(dimension);
  add_body(deck, "block", std::move(form), spacing);
  return deck;
}

inline deck::Deck cube(double edge, double spacing = 1) {
  return deck_of(deck::Box{{0, 0, 0}, {edge, edge, edge}}, deck::Dimension::three, spacing);
}
inline deck::Deck square(double edge, double spacing = 1) {
  return deck_of(deck::Box{{0, 0, 0}, {edge, edge, 0}}, deck::Dimension::plane_strain, spacing);
}

inline void add_set(deck::Deck& deck, const std::string& name, decltype(deck::Set::form) form) {
  deck.sets.push_back({{"deck.yaml", 20, 3}, name, std::move(form)});
}
inline void add_crack(deck::Deck& deck, decltype(deck::Crack::form) form) {
  deck.cracks.push_back({{"deck.yaml", 30, 5}, std::move(form)});
}

/// The body with the reach that its bonds need.
inline Body build_body(const deck::Deck& deck, const Communicator& communicator = Communicator(),
                       PartitionReport* report = nullptr) {
  const double horizon = horizon_length(deck, communicator);
  return build(deck, communicator, bonds::reach(deck, horizon, largest_spacing(deck, communicator)), report);
}

struct Bonded {
  Body body;
  bonds::Bonds bonds;
};
inline Bonded build_bonds(const deck::Deck& deck, const Communicator& communicator = Communicator()) {
  Bonded both{build_body(deck, communicator), {}};
  both.bonds = bonds::build(deck, both.body, horizon_length(deck, communicator));
  return both;
}

/// The sentence of the InputError that `work` must throw; "nothing was refused" if it does not.
template <class Work>
std::string refusal(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

/// A file that the root of the world writes. It has the same name on every rank and is removed at the end.
class TextFile {
 public:
  TextFile(const std::string& name, const std::string& text) {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    long long process = ::getpid();
    MPI_Bcast(&process, 1, MPI_LONG_LONG, 0, MPI_COMM_WORLD);
    path_ = (std::filesystem::temp_directory_path() / ("perinox_" + std::to_string(process) + "_" + name)).string();
    owner_ = rank == 0;
    if (owner_) std::ofstream(path_, std::ios::binary) << text;
    MPI_Barrier(MPI_COMM_WORLD);
  }
  ~TextFile() {
    MPI_Barrier(MPI_COMM_WORLD);
    std::error_code ignored;
    if (owner_) std::filesystem::remove(path_, ignored);
  }
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  bool owner_ = false;
};

}  // namespace perinox::body::fixture
