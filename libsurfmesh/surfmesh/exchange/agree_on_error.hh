// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <exception>
#include <new>
#include <optional>
#include <string>

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

/// An error with the index of its patch or tile.
class ErrorAt : public Error {
 public:
  explicit ErrorAt(const RankError& error) : Error(error.code, error.text), index_(error.index) {}

  std::int64_t index() const { return index_; }

 private:
  std::int64_t index_;
};

/// Tell all ranks what went wrong on this one, if anything did. Called by all of them, and between
/// any work that may fail and the next exchange; else ranks wait for one that has given up.
///
/// Throws   AgreedError on all ranks if there is an error on any: Cancelled before all others, for
///          which of these a cancelled run meets is a matter of chance; then that of the least
///          index, among equal ones that of the least rank
void agree_on_error(Exchange& exchange, const std::optional<RankError>& mine);

/// Run `body`.
///
/// Returns  what went wrong in it, if anything did, at an index unless it is an ErrorAt: an Error,
///          that there is no memory left, or any other exception, as InvalidInput, for surfaces,
///          curves and sinks may be those of a caller
/// Throws   AgreedError, which all ranks know already
template <class Body>
std::optional<RankError> rank_error_of(Body body, std::int64_t index = 0) {
  try {
    body();
    return {};
  } catch (const AgreedError&) {
    throw;
  } catch (const ErrorAt& error) {
    return RankError{error.index(), error.code(), error.what()};
  } catch (const Error& error) {
    return RankError{index, error.code(), error.what()};
  } catch (const std::bad_alloc&) {
    return RankError{index, ErrorCode::Limit, "out of memory"};
  } catch (const std::exception& error) {
    return RankError{index, ErrorCode::InvalidInput, error.what()};
  }
}

/// Tell all ranks what `body` throws, see error_of. It must not exchange anything itself, but by
/// calls of this function.
template <class Body>
void agree_on_errors_of(Exchange& exchange, Body body) {
  agree_on_error(exchange, rank_error_of(body));
}

}  // namespace surfmesh
