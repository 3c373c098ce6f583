// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_GLTF_NODES_HPP_
#define HALFSPACE_REF_SCENE_GLTF_NODES_HPP_

#include <vector>

#include "ref/scene/gltf/file/file.hpp"

namespace halfspace::ref::gltf {

// Nodes of the file in the order of the document: depth first from the roots of its scene, parents first; and then
// those that move joints and are in no scene, of which nothing is drawn.
struct NodeOrder {
  struct Place {
    int node;    // of the file
    int parent;  // of the document, or −1
  };
  std::vector<Place> places;
  std::vector<int> numbers;  // in the document, of the nodes of the file; −1: not there
  std::size_t drawn = 0;     // places that are in the scene
};

// Error on circles, on a node of two parents, and on more nodes or deeper ones than scenes have.
NodeOrder order_of(File* file);

// How a node stands to its parent.
Node node_of(const File&, int node);

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_NODES_HPP_
