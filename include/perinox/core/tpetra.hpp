#pragma once
/// The Tpetra types in the one instantiation that perinox uses, declared but not defined, so that they are cheap to
/// include. A translation unit that calls their members includes the Tpetra headers itself.
#include <Teuchos_RCP.hpp>
#include <Tpetra_CrsGraph_fwd.hpp>
#include <Tpetra_CrsMatrix_fwd.hpp>
#include <Tpetra_Export_fwd.hpp>
#include <Tpetra_Map_fwd.hpp>
#include <Tpetra_MultiVector_fwd.hpp>
#include <Tpetra_Operator_fwd.hpp>
#include <Tpetra_Vector_fwd.hpp>

#include "perinox/core/types.hpp"

namespace perinox::tpetra {

using Map = Tpetra::Map<LocalIndex, GlobalId>;
using Vector = Tpetra::Vector<double, LocalIndex, GlobalId>;
using MultiVector = Tpetra::MultiVector<double, LocalIndex, GlobalId>;
using Operator = Tpetra::Operator<double, LocalIndex, GlobalId>;
using Graph = Tpetra::CrsGraph<LocalIndex, GlobalId>;
using Matrix = Tpetra::CrsMatrix<double, LocalIndex, GlobalId>;
using Export = Tpetra::Export<LocalIndex, GlobalId>;

}  // namespace perinox::tpetra
