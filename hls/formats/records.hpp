// SPDX-License-Identifier: Apache-2.0
// The records that travel between the units; hls/formats/streams.hpp says which stream has which.
//
// visit() names the fields once, in the order of a SystemVerilog packed struct: the first is the most significant.
// Packing, manifests, the RTL package and the reports of mismatches all read the layout from there. Fields that
// come once a lane stand last in the word, lane 0 in the least significant place, and first in memory, where a
// processor's vectors find them aligned. A field that a configuration has no use for is not visited, so that no word
// has it: depths without F::kHasDepth, depths of the Z-buffer without F::kStoresDepth, colours of the other vertices
// and colour planes without F::kGouraud. With F::kHasLighting a triangle comes without colours, and its normals once it
// is visible; with F::kPhong its planes are of normals. With F::kHasTexture it has planes of texture coordinates
// besides. With F::kHasObjects it knows its object.
#ifndef HALFSPACE_HLS_FORMATS_RECORDS_HPP_
#define HALFSPACE_HLS_FORMATS_RECORDS_HPP_

#include "hls/formats/records/frame.hpp"
#include "hls/formats/records/motion.hpp"
#include "hls/formats/records/raster.hpp"
#include "hls/formats/records/setup.hpp"
#include "hls/formats/records/shade.hpp"
#include "hls/formats/records/texture.hpp"

#endif  // HALFSPACE_HLS_FORMATS_RECORDS_HPP_
