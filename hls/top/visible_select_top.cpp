// SPDX-License-Identifier: Apache-2.0
// Of a configuration with lighting or texture: HALFSPACE_TOP_CONFIG names it.
#include "hls/top/fields.hpp"
#include "hls/ztest/visible_select.hpp"

using namespace halfspace;

// One triangle. Returns whether `passed` was sent.
extern "C" int visible_select_top(const std::int64_t attributes[kAttributesFields],
                                  const std::int64_t tested[kVisibleFields], std::int64_t visible[kVisibleFields],
                                  std::int64_t passed[kAttributesFields]) {
  using F = TopFormats;
  static_assert(F::kDeferred, "visible_select is of configurations with lighting or texture");
  Stream<Attributes<F>> in, out;
  Stream<Visible<F>> result, told;
  in.write(read_fields<Attributes<F>>(attributes));
  result.write(read_fields<Visible<F>>(tested));
  visible_select(in, result, told, out);
  write_fields(told.read(), visible);
  const bool sent = !out.empty();
  if (sent) write_fields(out.read(), passed);
  return sent;
}
