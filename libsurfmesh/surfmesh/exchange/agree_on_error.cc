// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/exchange/agree_on_error.hh"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace surfmesh {
namespace {

/// What is sent in front of the text.
struct Head {
  std::int64_t index;
  ErrorCode code;
};

std::vector<std::byte> to_bytes(const RankError& error) {
  const Head head{error.index, error.code};
  const auto of_head = std::as_bytes(std::span(&head, 1));
  const auto of_text = std::as_bytes(std::span(error.text));
  std::vector<std::byte> bytes(of_head.begin(), of_head.end());
  bytes.insert(bytes.end(), of_text.begin(), of_text.end());
  return bytes;
}

RankError from_bytes(const std::vector<std::byte>& bytes) {
  Head head;
  std::memcpy(&head, bytes.data(), sizeof head);
  return {head.index, head.code,
          std::string(reinterpret_cast<const char*>(bytes.data()) + sizeof head,
                      bytes.size() - sizeof head)};
}

/// True if of two errors the first one counts.
bool comes_before(const RankError& a, const RankError& b) {
  const bool is_cancelled = a.code == ErrorCode::Cancelled;
  if (is_cancelled != (b.code == ErrorCode::Cancelled)) return is_cancelled;
  return a.index < b.index;
}

}  // namespace

void agree_on_error(Exchange& exchange, const std::optional<RankError>& mine) {
  std::optional<RankError> first;
  for (const auto& bytes : exchange.all_gather(mine ? to_bytes(*mine) : std::vector<std::byte>())) {
    if (bytes.empty()) continue;
    RankError error = from_bytes(bytes);
    if (!first || comes_before(error, *first)) first = std::move(error);
  }
  if (first) throw AgreedError(first->code, first->text);
}

}  // namespace surfmesh
