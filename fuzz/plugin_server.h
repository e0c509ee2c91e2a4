// SPDX-License-Identifier: GPL-3.0-or-later
// What runs in the processes of a plug-in: nothing of it runs in gnomon's own.
#pragma once

#include <string>

#include "fuzz/file_descriptor.h"
#include "fuzz/plugin_memory.h"

namespace gnomon::fuzz::plugin {

/// Bytes on the channel between gnomon and a plug-in's process.
inline constexpr char kRun = 'r', kReady = 'k';

/// Loads the plug-in and answers requests until the channel closes. Call it in a fresh process with one
/// thread.
[[noreturn]] void serve(const std::string& library, const Region& region, const FileDescriptor& channel);

}  // namespace gnomon::fuzz::plugin
