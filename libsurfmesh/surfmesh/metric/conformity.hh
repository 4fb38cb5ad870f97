// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Compare two size tensors entry by entry: max over i,j of |D_ij − δ_ij|, D = H_o H_t⁻¹.
///
/// 0 for equal tensors. Depends on the frame and on the order of the arguments.
///
/// Pre      both positive definite
/// Source   paper, eq. (6)
/// Differs: the identity is subtracted, so that 0 and not 1 means equal
double entry_conformity(const SizeTensor& h_o, const SizeTensor& h_t);

/// Compare two size tensors by the logarithms of their ratios: max |ln λ| over the eigenvalues λ of
/// H_o H_t⁻¹.
///
/// 0 for equal tensors, symmetric, independent of the frame; ln 2 where one asks for twice the
/// length of the other.
///
/// Error    1e-14 × aspect, also for nearly equal tensors (test LogConformity.*)
/// Pre      both positive definite
double log_conformity(const SizeTensor& h_o, const SizeTensor& h_t);

/// The same for two metrics at near points, where the parameterisation may differ, too: the
/// greatest logarithm of the ratio of two lengths of one step. No dimension; 0 for equal metrics.
///
/// Pre      both positive definite
double metric_conformity(const Metric& a, const Metric& b);

/// How much longer one size tensor asks for than another, in the direction where that is most: the
/// greatest eigenvalue of A B⁻¹ − 1, at least 0.
///
/// Error    1e-14 × aspect, also for nearly equal tensors
/// Pre      both positive definite
double greatest_growth(const SizeTensor& a, const SizeTensor& b);

}  // namespace surfmesh
