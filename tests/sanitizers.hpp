#pragma once

/// Whether the tests run with AddressSanitizer, which keeps freed memory and takes several times as long.
#if defined(__SANITIZE_ADDRESS__)
#define MDM_IS_SANITIZED 1
#elif defined(__has_feature)
#define MDM_IS_SANITIZED __has_feature(address_sanitizer)
#else
#define MDM_IS_SANITIZED 0
#endif
