// SPDX-License-Identifier: Apache-2.0
// Nothing: the targets of this file have the precompiled headers of the benches.
