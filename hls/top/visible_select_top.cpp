// SPDX-License-Identifier: Apache-2.0
#include "hls/ztest/visible_select.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void visible_select_top(Port<Attributes>& attributes, Port<Visible>& tested, Port<Visible>& visible,
                                   Port<Attributes>& passed) {
  HS_STREAM_PORT(attributes)
  HS_STREAM_PORT(tested)
  HS_STREAM_PORT(visible)
  HS_STREAM_PORT(passed)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kDeferred, "visible_select is of deferred shading");
  View<Attributes> attributes_words(attributes);
  View<Visible> tested_words(tested);
  View<Visible> visible_words(visible);
  View<Attributes> passed_words(passed);
Words:
  while (!visible_select(attributes_words, tested_words, visible_words, passed_words)) {
    HS_PIPELINE(1)
  }
}
