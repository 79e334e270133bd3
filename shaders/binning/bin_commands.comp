#version 460
#extension GL_GOOGLE_include_directive : require
#include "binning/binning.glsl"

// Last pass: one invocation per bucket and group lists the group's runs that have draws, in scene order, and counts them.
layout(local_size_x = kCommandsBlock) in;

// The level of detail a run's one instance is drawn at in a cascade, as visibility::chooseLevels() has it.
uint levelOf(KindRun run, uint cascade) {
    if (run.levels == 0u) {
        return 0u;
    }
    InstanceSphere sphere = spheres[run.instance];
    double radius = double(sphere.radius);
    precise double nearest = max(viewDistance(sphere) - radius, view.nearView);
    double distanceView = view.detailMode == kDetailPerCascade ? view.nearViews[cascade] : nearest;
    precise double limit = view.levelSlope * distanceView * double(run.boundingRadius);
    for (uint level = run.levels; level > 0u; --level) {
        precise double error = double(levels[run.firstLevel + level - 1u].error) * radius;
        if (error <= limit) {
            return level;
        }
    }
    return 0u;
}

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
            uint firstIndex = runs[run].firstIndex;
            uint indexCount = runs[run].indexCount;
            uint level = levelOf(runs[run], bucket / 2u);
            if (level > 0u) {
                firstIndex = levels[runs[run].firstLevel + level - 1u].firstIndex;
                indexCount = levels[runs[run].firstLevel + level - 1u].indexCount;
            }
            commands[bucket * view.runs + groups[group].begin + listed] =
                IndirectCommand(indexCount, end - begin, firstIndex, runs[run].vertexOffset, begin);
            ++listed;
        }
    }
    commandCounts[bucket * view.groups + group] = listed;
}
