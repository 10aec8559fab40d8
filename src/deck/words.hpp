#pragma once
/// The deck's words for the values of each enumeration, in the enumeration's order.
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"

namespace perinox::deck::words {

inline const std::vector<std::string> dimension{"3", "plane-strain", "plane-stress"};
inline const std::vector<std::string> influence{"constant", "inverse", "polynomial"};
inline const std::vector<std::string> boundary_cells{"auto", "cut", "whole"};
inline const std::vector<std::string> deformation{"finite", "small"};
inline const std::vector<std::string> quadrature{"whole", "partial-volume", "taper-inside", "position-aware",
                                                 "surface-energy"};
inline const std::vector<std::string> across_gaps{"cut", "keep"};
inline const std::vector<std::string> overlap{"refuse", "later-wins"};
inline const std::vector<std::string> tangent_kind{"auto", "matrix-free", "assembled"};
inline const std::vector<std::string> tangent_form{"consistent", "printed"};
inline const std::vector<std::string> line_search{"backtrack", "full-step"};
inline const std::vector<std::string> forcing{"eisenstat-walker", "constant"};
inline const std::vector<std::string> linear_method{"automatic", "cg", "gmres", "direct"};
inline const std::vector<std::string> preconditioner{
    "automatic", "none", "two-level", "block-jacobi", "jacobi", "symmetric-gauss-seidel", "chebyshev", "ilu"};
/// The number of steps is two times the word's place less one; 0 stands for automatic.
inline const std::vector<std::string> chebyshev_steps{"automatic", "1", "3", "5"};
inline const std::vector<std::string> component{"x", "y", "z"};
inline const std::vector<std::string> load_kind{"displacement", "force",    "body_force",
                                                "traction",     "pressure", "velocity"};
inline const std::vector<std::string> break_criterion{"automatic", "bond-energy", "stretch"};
inline const std::vector<std::string> dynamics{"quasi-static", "explicit"};
inline const std::vector<std::string> fallback{"automatic", "explicit", "none"};
inline const std::vector<std::string> control{"load", "arc-length"};
inline const std::vector<std::string> history_kind{"reaction", "displacement", "yielded"};
/// The enumeration's value for a word that the schema has already accepted.
template <class Enumeration>
Enumeration value_of(const std::vector<std::string>& words, const std::string& word) {
  int index = 0;
  for (const std::string& candidate : words) {
    if (candidate == word) break;
    ++index;
  }
  return static_cast<Enumeration>(index);
}

}  // namespace perinox::deck::words
