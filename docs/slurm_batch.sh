#!/bin/bash
# Inspects a series of parts as a Slurm job array, one shard a task, and merges the shards when all are done.
#
#   export PARTS=/data/parts CRITERIA=/data/limits.json REPORT=/data/series   # seen by every node, absolute
#   array=$(sbatch --parsable --array=1-8 docs/slurm_batch.sh)
#   sbatch --dependency=afterany:$array docs/slurm_batch.sh merge
#
# A task that was killed (time limit, node lost) is run again with the same line: what is done is kept, and the series
# ends with the same summary. Exit status 3 says that a part did not pass; that is no fault of the job.
#SBATCH --job-name=lacuna
#SBATCH --cpus-per-task=1
#SBATCH --mem=2G
#SBATCH --time=04:00:00
#SBATCH --requeue
set -u
lacuna=${LACUNA:-lacuna}
if [ "${1:-}" = merge ]; then
    "$lacuna" batch --merge "$REPORT" --quiet
else
    export LACUNA_THREADS=${SLURM_CPUS_PER_TASK:-1}
    "$lacuna" batch "$PARTS" --criteria "$CRITERIA" --report "$REPORT" --quiet --resume \
        --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --memory-limit "${SLURM_MEM_PER_NODE:-2048}"
fi
status=$?
[ $status -eq 3 ] && exit 0
exit $status
