#pragma once

/// CDR_EXPORT marks what the shared libraries of cdr export; all else is hidden. On Windows their users need CDR_SHARED, which
/// the package's targets define. It has no effect elsewhere.
#if !defined(_WIN32)
#define CDR_EXPORT __attribute__((visibility("default")))
#elif defined(CDR_BUILDS_SHARED)
#define CDR_EXPORT __declspec(dllexport)
#elif defined(CDR_SHARED)
#define CDR_EXPORT __declspec(dllimport)
#else
#define CDR_EXPORT
#endif
