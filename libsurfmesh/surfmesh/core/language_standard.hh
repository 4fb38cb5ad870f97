// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Every public header includes this one, at least through others: compiled for an older language,
/// any of them says what is wrong before the compiler stumbles over what it does not know.
///
/// Drafts of C++20 pass, for compilers give them numbers of their own (-std=c++2a of GCC 10).
#if defined(_MSVC_LANG)
#define SURFMESH_LANGUAGE _MSVC_LANG  // __cplusplus of Visual C++ stays at C++98
#else
#define SURFMESH_LANGUAGE __cplusplus
#endif
#if SURFMESH_LANGUAGE <= 201703L
#error "surfmesh needs C++20: compile with -std=c++20 (Visual C++: /std:c++20) or newer"
#endif
#undef SURFMESH_LANGUAGE
