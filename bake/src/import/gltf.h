// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// tinygltf as the import uses it: the structure of a glTF document, without images, files and writing.
#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
// Some builds of libdraco export a tinygltf of their own with another layout; a namespace of ours keeps them apart.
#define tinygltf lithe_tinygltf
#include <tiny_gltf.h>
