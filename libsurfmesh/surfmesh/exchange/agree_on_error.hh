// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/exchange/exchange.hh"

namespace surfmesh {

/// What went wrong on a rank.
struct RankError {
  std::int64_t index = 0;  ///< of the patch or tile: that of the least one counts
  ErrorCode code = ErrorCode::InvalidInput;
  std::string text;
};

/// The error that all ranks throw together: none of them still waits for another one.
class AgreedError : public Error {
 public:
  using Error::Error;
};

/// Tell all ranks what went wrong on this one, if anything did. Called by all of them, and between
/// any work that may fail and the next exchange; else ranks wait for one that has given up.
///
/// Throws   AgreedError on all ranks if there is an error on any: that of the least index, among
///          equal ones that of the least rank
void agree_on_error(Exchange& exchange, const std::optional<RankError>& mine);

/// The same for what `body` throws: an Error, or that there is no memory left. It must not exchange
/// anything itself, but by calls of this function.
template <class Body>
void agree_on_errors_of(Exchange& exchange, Body body, std::int64_t index = 0) {
  std::optional<RankError> mine;
  try {
    body();
  } catch (const AgreedError&) {
    throw;
  } catch (const Error& error) {
    mine = {index, error.code(), error.what()};
  } catch (const std::bad_alloc&) {
    mine = {index, ErrorCode::Limit, "out of memory"};
  }
  agree_on_error(exchange, mine);
}

}  // namespace surfmesh
