#version 460
#extension GL_GOOGLE_include_directive : require
#include "binning.glsl"

// Last pass: one invocation per bucket and group lists the group's runs that have draws, in scene order, and counts them.
layout(local_size_x = 64) in;

void main() {
    uint bucket = gl_GlobalInvocationID.x / view.groups;
    uint group = gl_GlobalInvocationID.x % view.groups;
    if (bucket >= bucketCount()) {
        return;
    }
    uint bucketEnd = blockDraws[(bucket + 1u) * view.blocks];
    uint listed = 0u;
    for (uint run = groups[group].begin; run < groups[group].end; ++run) {
        // Records that had no room are not drawn; the CPU sees that some are missing and draws the frame again.
        uint begin = min(runFirsts[bucket * view.runs + run], view.recordCapacity);
        uint end = run + 1u < view.runs ? runFirsts[bucket * view.runs + run + 1u] : bucketEnd;
        end = min(end, view.recordCapacity);
        if (end > begin) {
            commands[bucket * view.runs + groups[group].begin + listed] = IndirectCommand(
                runs[run].indexCount, end - begin, runs[run].firstIndex, runs[run].vertexOffset, begin);
            ++listed;
        }
    }
    commandCounts[bucket * view.groups + group] = listed;
}
