/// @file
/// The shared library exports what the headers of this folder declare, and nothing else.
#pragma once

/// Stands behind the name of a namespace of which the shared library exports all.
#if defined(__GNUC__)
#define PUPFLOW_PUBLIC __attribute__((visibility("default")))
#else
#define PUPFLOW_PUBLIC
#endif
