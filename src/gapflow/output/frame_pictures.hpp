// Pictures of a run's key frames, drawn without a browser.
#pragma once

#include "gapflow/output/progress.hpp"
#include "gapflow/output/stored_run.hpp"

#include <filesystem>
#include <vector>

namespace gapflow {

/// Key frames of a run, at most `most`: the first and the last, those of the thinnest and the widest gap, others
/// evenly spread in between. Indices into run.frames, increasing.
std::vector<std::size_t> key_frames(const StoredRun& run, std::size_t most = 6);

/// Writes frame_NNNNN.png of every key frame (NNNNN: the frame's number) into the folder, which it creates. 2D: pressure and
/// speed with bodies and films; 3D: bodies, films and a slice in perspective, and the slice from the front. Colours mean the
/// same in all. Throws InputError if the run has no frames or files of it are damaged, ComputationError if it cannot write.
/// `watch` is called for every output time that is read and for every picture.
std::vector<std::filesystem::path> write_frame_pictures(const StoredRun& run, const std::filesystem::path& folder,
                                                        const CountWatcher& watch = {});

} // namespace gapflow
