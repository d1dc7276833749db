// What a device must get right before it is trusted with a picture, and what ranks it against others.

// Value of the volume at a position, trilinear between the eight neighbours; positions lie inside [0, dims - 1].
float sample_ramp(__global const float* restrict voxels, int4 dims, float4 at) {
    const int4 low = min(convert_int4_rtz(at), dims - 2);
    const float4 f = at - convert_float4(low);
    const int row = dims.x, slice = dims.x * dims.y;
    __global const float* v = voxels + (low.z * slice + low.y * row + low.x);
    const float4 lower = (float4)(v[0], v[row], v[slice], v[slice + row]);
    const float4 upper = (float4)(v[1], v[row + 1], v[slice + 1], v[slice + row + 1]);
    const float4 along_x = lower + (upper - lower) * f.x;
    const float2 along_y = along_x.xz + (along_x.yw - along_x.xz) * f.y;
    return along_y.x + (along_y.y - along_y.x) * f.z;
}

/// Samples a volume at given positions.
///   voxels     float[dims.x*dims.y*dims.z], x fastest; every dimension at least 2
///   positions  float4[count], voxel coordinates in x, y, z
///   values     float[count], written
__kernel void sample_positions(__global const float* restrict voxels, int4 dims,
                               __global const float4* restrict positions, __global float* restrict values,
                               int count) {
    const int i = get_global_id(0);
    if (i >= count) return;
    values[i] = sample_ramp(voxels, dims, positions[i]);
}

/// Sums each work-group's numbers through local memory and a barrier.
///   numbers  uint[count]     sums  uint[groups], written     scratch  uint[work-group size, a power of two]
__kernel void sum_groups(__global const uint* restrict numbers, __global uint* restrict sums,
                         __local uint* restrict scratch, int count) {
    const int i = get_global_id(0), lane = get_local_id(0);
    scratch[lane] = i < count ? numbers[i] : 0u;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int half_size = get_local_size(0) / 2; half_size > 0; half_size /= 2) {
        if (lane < half_size) scratch[lane] += scratch[lane + half_size];
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    if (lane == 0) sums[get_group_id(0)] = scratch[0];
}

/// The load that ranks devices: each work-item marches through the ramp volume as a ray would.
///   voxels  as above     out  float[count], written     steps  samples a work-item takes
__kernel void march_ramp(__global const float* restrict voxels, int4 dims, __global float* restrict out, int steps,
                         int count) {
    const int i = get_global_id(0);
    if (i >= count) return;
    const float4 last = convert_float4(dims - 1);
    const float4 from = (float4)((float)(i & 63) * (1.0f / 64.0f), (float)((i >> 6) & 63) * (1.0f / 64.0f), 0.0f, 0.0f);
    float sum = 0.0f;
    for (int k = 0; k < steps; ++k) {
        const float t = (float)k / (float)steps;
        sum += sample_ramp(voxels, dims, (float4)(from.x, from.y, t, 0.0f) * last);
    }
    out[i] = sum;
}
