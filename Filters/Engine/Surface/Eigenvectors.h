// SPDX-License-Identifier: BSD-3-Clause
#ifndef ahd_Eigenvectors_h
#define ahd_Eigenvectors_h

#include "Vectors.h"

namespace ahd
{

/// The eigenvectors, as columns, of a symmetric matrix with no negative eigenvalue; its diagonal
/// becomes the eigenvalues. Small eigenvalues are as exact as large ones where the elements allow
/// it, as an element counts as zero only in comparison with its own two diagonal elements.
Matrix3 findEigenvectors(Matrix3& a);

} // namespace ahd

#endif
