#include <array>

#include "core/accuracy/limit_conditions.h"
#include "core/accuracy/limits.h"

// Where methods fail, as values. Named as Qt's marker, so that its tools find the texts to translate; no Qt is used.
#define QT_TRANSLATE_NOOP(context, text) text

namespace lacuna {

namespace {

bool has_effect(const Scene& scene, EffectKind kind) {
    for (const Effect& effect : scene.effects)
        if (effect.kind == kind) return true;
    return false;
}

// Whom an entry concerns.
bool samples_surfaces(const Scene& s, const Plan& p) {
    return s.mode == ViewMode::iso && p.refine != Refinement::cubic;
}
bool is_iso(const Scene& s, const Plan&) { return s.mode == ViewMode::iso; }
bool is_unrefined(const Scene& s, const Plan& p) { return s.mode == ViewMode::iso && p.refine == Refinement::none; }
bool by_plain_regula_falsi(const Scene& s, const Plan& p) {
    return s.mode == ViewMode::iso && p.refine == Refinement::regula_falsi_plain;
}
bool by_newton(const Scene& s, const Plan& p) { return s.mode == ViewMode::iso && p.refine == Refinement::newton; }
bool integrates_points(const Scene& s, const Plan& p) {
    return s.mode == ViewMode::ea && p.integration == Integration::riemann;
}
bool integrates_segments(const Scene& s, const Plan& p) {
    return s.mode == ViewMode::ea && p.integration == Integration::preintegrated;
}
bool is_ea(const Scene& s, const Plan&) { return s.mode == ViewMode::ea; }
bool terminates_early(const Scene& s, const Plan& p) { return s.mode == ViewMode::ea && p.ert > 0; }
bool projects_linearly(const Scene& s, const Plan& p) {
    return (s.mode == ViewMode::mip || s.mode == ViewMode::lmip || s.mode == ViewMode::minip) &&
           p.sampler != Sampler::nearest;
}
bool projects_extremes(const Scene& s, const Plan&) {
    return (s.mode == ViewMode::mip || s.mode == ViewMode::lmip || s.mode == ViewMode::minip);
}
bool projects_local_maxima(const Scene& s, const Plan& p) {
    return s.mode == ViewMode::lmip && p.sampler != Sampler::nearest;
}
bool is_shear_warp(const Scene& s, const Plan&) { return s.mode == ViewMode::shear_warp; }
bool is_rough_shear_warp(const Scene& s, const Plan& p) {
    return s.mode == ViewMode::shear_warp && p.sampler == Sampler::nearest;
}
bool averages_nodes(const Scene& s, const Plan& p) {
    return s.mode == ViewMode::ea && p.structure == Structure::octree && p.homogeneity > 0;
}
bool runs_by_opacity(const Scene& s, const Plan& p) {
    return s.mode == ViewMode::ea &&
           (p.structure == Structure::pc || p.structure == Structure::acd || p.structure == Structure::eacd) &&
           p.homogeneity > 0;
}
bool boxes_a_voxel(const Scene&, const Plan& p) { return p.structure == Structure::eacd && p.cells == 1; }
bool distances_a_voxel(const Scene&, const Plan& p) {
    return (p.structure == Structure::pc || p.structure == Structure::acd || p.structure == Structure::eacd) &&
           p.cells == 1;
}
bool skips_in_ea(const Scene& s, const Plan& p) { return s.mode == ViewMode::ea && p.structure != Structure::none; }
bool skips(const Scene&, const Plan& p) { return p.structure != Structure::none && p.structure != Structure::visible; }
bool turns_normals(const Scene& s, const Plan& p) {
    return s.mode == ViewMode::ea && distances_a_voxel(s, p) && p.homogeneity_angle_deg > 0;
}
bool walks_a_tree(const Scene&, const Plan& p) {
    return p.structure == Structure::octree || p.structure == Structure::pyramid;
}
bool leaps_as_published(const Scene&, const Plan& p) {
    return p.structure == Structure::leap && p.leap.kernel == Leaping::published;
}
bool leaps(const Scene&, const Plan& p) { return p.structure == Structure::leap; }
bool is_sparse(const Scene&, const Plan& p) { return p.sparse >= 2; }
bool has_ssao(const Scene& s, const Plan&) { return has_effect(s, EffectKind::ssao); }
bool has_depth_of_field(const Scene& s, const Plan&) { return has_effect(s, EffectKind::dof); }
bool always(const Scene&, const Plan&) { return true; }
bool stores_gradients(const Scene& s, const Plan& p) {
    return p.gradient_store == GradientStore::stored && (s.mode == ViewMode::iso || s.mode == ViewMode::ea);
}
bool samples_nearest(const Scene& s, const Plan& p) {
    return p.sampler == Sampler::nearest && !(s.mode == ViewMode::shear_warp) &&
           !(s.mode == ViewMode::mip || s.mode == ViewMode::lmip || s.mode == ViewMode::minip);
}

// clang-format off: a table of texts
constexpr auto k_limits = std::to_array<Limit>({
    {QT_TRANSLATE_NOOP("Limits", "Walls between two samples"), LimitTopic::surfaces,
     QT_TRANSLATE_NOOP("Limits",
                       "A wall thinner than the step can lie between two samples that are both outside: the ray "
                       "goes through it."),
     Guard::corrected,
     QT_TRANSLATE_NOOP("Limits",
                       "the refinement `cubic` solves every cell the ray crosses; `--step` below the wall's "
                       "thickness does as well."),
     QT_TRANSLATE_NOOP("Limits",
                       "samples miss a wall of thickness w, crossed at an angle a to its normal, with probability "
                       "1 - w/(s cos a) at step s, for 0.1 to 1 voxel and up to 85 degrees; solved cells miss "
                       "none, by any structure, and are off by under 0.002 voxels."),
     "ThinWalls.SolvedCellsMissNoneByAnyStructure", samples_surfaces, limit::thin_walls},
    {QT_TRANSLATE_NOOP("Limits", "No structure or refinement adds to it"), LimitTopic::surfaces,
     QT_TRANSLATE_NOOP("Limits", "A skipped cell or a bad bracket could lose a wall that the samples do find."),
     Guard::corrected,
     QT_TRANSLATE_NOOP("Limits",
                       "structures skip only cells whose smallest and largest values lie on one side; refinements "
                       "keep their bracket."),
     QT_TRANSLATE_NOOP("Limits",
                       "the same pixels are hit by every structure with every refinement; the depth is within a "
                       "step unrefined, within step/2^(n+1) bisected."),
     "ThinWalls.NoStructureAddsToWhatSamplesMissByAnyRefinement", is_iso},
    {QT_TRANSLATE_NOOP("Limits", "No refinement"), LimitTopic::surfaces,
     QT_TRANSLATE_NOOP("Limits",
                       "Without refinement the surface is drawn at the first sample behind it: it recedes, and "
                       "shows rings."),
     Guard::bounded, QT_TRANSLATE_NOOP("Limits", "`--refine` other than `none`."),
     QT_TRANSLATE_NOOP("Limits", "off by up to a step, half a step on average: first order in the step."),
     "Slopes.ASurfacesDepthIsOfSecondOrderInTheGridAndFirstInTheStepUnrefined", is_unrefined},
    {QT_TRANSLATE_NOOP("Limits", "Regula falsi stalls"), LimitTopic::surfaces,
     QT_TRANSLATE_NOOP("Limits",
                       "As published, one end of the bracket stays where the signal is convex along the ray, and "
                       "more steps change nothing."),
     Guard::corrected,
     QT_TRANSLATE_NOOP("Limits",
                       "`regula-falsi` halves the kept end's weight (Illinois); `regula-falsi-plain` is the "
                       "method as published."),
     QT_TRANSLATE_NOOP("Limits",
                       "plain: off by over a fifth of a millimetre at a step of 8 after 64 steps; guarded: within "
                       "0.001 mm after 16."),
     "Refinement.PlainRegulaFalsiStallsTheGuardedOneDoesNot", by_plain_regula_falsi},
    {QT_TRANSLATE_NOOP("Limits", "Newton at tangent rays"), LimitTopic::surfaces,
     QT_TRANSLATE_NOOP("Limits",
                       "Where a ray all but touches the surface the slope along it all but vanishes, and textbook "
                       "Newton runs off."),
     Guard::corrected,
     QT_TRANSLATE_NOOP("Limits",
                       "the first estimate is the secant's, from which concave signals are met from the inside."),
     QT_TRANSLATE_NOOP("Limits",
                       "textbook Newton fails on most such rays; started at the secant none leaves its bracket, "
                       "and depths are within 0.001 voxels."),
     "Refinement.NewtonRunsOffAtTangentRaysUnlessItStartsAtTheSecant", by_newton},
    {QT_TRANSLATE_NOOP("Limits", "Newton beside flat signals"), LimitTopic::surfaces,
     QT_TRANSLATE_NOOP("Limits", "Beside an edge narrower than a step the signal is flat: there is no slope to go by."),
     Guard::bounded,
     QT_TRANSLATE_NOOP("Limits", "an estimate that leaves the bracket is replaced by its middle and counted."),
     QT_TRANSLATE_NOOP("Limits", "off by half a step at most."),
     "Refinement.NewtonLeavesItsBracketWhereTheSignalIsFlatAndIsCaught", by_newton},
    {QT_TRANSLATE_NOOP("Limits", "The grid's own error"), LimitTopic::surfaces,
     QT_TRANSLATE_NOOP("Limits", "Between voxels the signal is trilinear, a curved surface is not."), Guard::bounded,
     QT_TRANSLATE_NOOP("Limits", "finer voxels only."),
     QT_TRANSLATE_NOOP("Limits",
                       "second order in the voxel size (slope within 0.15 of 2), on the device and in the "
                       "reference."),
     "Slopes.ASurfacesDepthIsOfSecondOrderInTheGridAndFirstInTheStepUnrefined", is_iso},
    {QT_TRANSLATE_NOOP("Limits", "Peaks between two samples"), LimitTopic::emission_absorption,
     QT_TRANSLATE_NOOP("Limits",
                       "A peak of the transfer function narrower than the values' change over a step falls "
                       "between two samples: its shell has holes or vanishes."),
     Guard::corrected,
     QT_TRANSLATE_NOOP("Limits", "`--integration preintegrated` draws every value between two samples."),
     QT_TRANSLATE_NOOP("Limits",
                       "points are off by over 20 of 255 levels for a peak a tenth of a step wide, segments by "
                       "less than 3."),
     "Peaks.FallBetweenSamplesOfPointsNotOfSegments", integrates_points, limit::narrow_peaks},
    {QT_TRANSLATE_NOOP("Limits", "Peaks narrower than a table's entry"), LimitTopic::emission_absorption,
     QT_TRANSLATE_NOOP("Limits",
                       "The table of pre-integrated segments has 512 x 512 entries over the span between the "
                       "function's outermost points: narrower peaks are smeared."),
     Guard::bounded,
     QT_TRANSLATE_NOOP("Limits",
                       "the extinction of every entry is integrated exactly, so that opacity survives the smear."),
     QT_TRANSLATE_NOOP("Limits", "opacity within a fifth for a peak a twentieth of an entry wide."),
     "Peaks.SegmentTablesSmearWhatIsNarrowerThanTheirEntriesButKeepItsOpacity", integrates_segments,
     limit::smeared_peaks},
    {QT_TRANSLATE_NOOP("Limits", "Layers between two samples of like value"), LimitTopic::emission_absorption,
     QT_TRANSLATE_NOOP("Limits",
                       "Both forms of integration know nothing of a layer of voxels between two samples: its "
                       "values are neither of theirs."),
     Guard::bounded, QT_TRANSLATE_NOOP("Limits", "a step below the layer's thickness meets it on every ray."),
     QT_TRANSLATE_NOOP("Limits",
                       "a layer one voxel thick is lost wholly on some rays at a step of two, on none at one "
                       "half; a share of 1 - w/s as for walls."),
     "Layers.AreLostBetweenSamplesByPointsAndBySegments", is_ea, limit::thin_layers},
    {QT_TRANSLATE_NOOP("Limits", "The step's own error"), LimitTopic::emission_absorption,
     QT_TRANSLATE_NOOP("Limits", "A sum over samples is not the integral."), Guard::bounded,
     QT_TRANSLATE_NOOP("Limits", "`--verify-against fine` measures it."),
     QT_TRANSLATE_NOOP("Limits", "second order in the step (slope within 0.15 of 2)."),
     "Slopes.EmissionAbsorptionIsOfSecondOrderInTheStep", integrates_points},
    {QT_TRANSLATE_NOOP("Limits", "Early termination before a bright core"), LimitTopic::emission_absorption,
     QT_TRANSLATE_NOOP("Limits", "A ray ends when opacity exceeds 1 - E; a bright core behind a dense veil is lost."),
     Guard::bounded, QT_TRANSLATE_NOOP("Limits", "`--ert` states E; the plan's `why` the levels."),
     QT_TRANSLATE_NOOP("Limits", "at most 255 E grey levels, 306 E under Phong shading: 0.6 at the default."),
     "Termination.HidesNoMoreThanItsBound", terminates_early, limit::hidden_light},
    {QT_TRANSLATE_NOOP("Limits", "Opacity of a step"), LimitTopic::emission_absorption,
     QT_TRANSLATE_NOOP("Limits", "Opacity taken a sample instead of a length doubles when the step is halved."),
     Guard::corrected, QT_TRANSLATE_NOOP("Limits", "a step of length d has 1-(1-a)^(d/unit), for voxels of any size."),
     QT_TRANSLATE_NOOP("Limits",
                       "within 0.0005 of the closed form at steps of 1/8 to 1 voxel, and for voxels of 1e-6 and "
                       "1e6 mm."),
     "OpacityOfAStep.IsThatOfItsLengthWhateverTheStep", is_ea},
    {QT_TRANSLATE_NOOP("Limits", "Opacity at extreme scales"), LimitTopic::emission_absorption,
     QT_TRANSLATE_NOOP("Limits",
                       "With voxels a millionth or a million times the unit distance the powers over- or "
                       "underflow."),
     Guard::corrected, QT_TRANSLATE_NOOP("Limits", "lengths enter as ratios."),
     QT_TRANSLATE_NOOP("Limits",
                       "the same picture within half a level by every structure; a film or a wall where the unit "
                       "stays, never NaN."),
     "OpacityOfAStep.HoldsForVoxelsScaledByAMillion", is_ea},
    {QT_TRANSLATE_NOOP("Limits", "One-voxel spots"), LimitTopic::projections,
     QT_TRANSLATE_NOOP("Limits",
                       "The brightest (darkest) value of a spot lies between two samples, and less of it is "
                       "shown."),
     Guard::bounded,
     QT_TRANSLATE_NOOP("Limits",
                       "`--sampler nearest` shows every spot a ray goes through whole, at a step of up to one "
                       "voxel."),
     QT_TRANSLATE_NOOP("Limits",
                       "a sample lies up to half a step off: 1 - prod(1 - s|d_i|/2) of the height along direction "
                       "d; 25 % along an axis at half a voxel, 37 % along the diagonal. Measured 10 % and more at "
                       "a quarter, 22 % at half, 35 % at one voxel, for spacing 1:1:1 and 1:1:5."),
     "Spots.SamplesLoseNoMoreThanTheBoundAndAlmostThatMuch", projects_linearly, limit::spots},
    {QT_TRANSLATE_NOOP("Limits", "No structure loses more of a spot"), LimitTopic::projections,
     QT_TRANSLATE_NOOP("Limits", "A cell taken for one without a winner hides the winner."), Guard::corrected,
     QT_TRANSLATE_NOOP("Limits", "cells carry the largest and smallest value of every voxel their samples can touch."),
     QT_TRANSLATE_NOOP("Limits", "the same picture within half a level by every structure."),
     "Spots.NoStructureLosesMore", projects_extremes},
    {QT_TRANSLATE_NOOP("Limits", "Local maxima just above the threshold"), LimitTopic::projections,
     QT_TRANSLATE_NOOP("Limits",
                       "LMIP passes over a local maximum that exceeds the threshold between two samples only."),
     Guard::bounded,
     QT_TRANSLATE_NOOP("Limits", "`--sampler nearest`, or a threshold lower by the share that spots lose."),
     QT_TRANSLATE_NOOP("Limits",
                       "a spot of 220 is passed over at threshold 200 and step one half; nearest samples stop at "
                       "it."),
     "Spots.LocalMaximaBelowTheThresholdAreLost", projects_local_maxima, limit::spots},
    {QT_TRANSLATE_NOOP("Limits", "Borders of the 24 regions"), LimitTopic::shear_warp,
     QT_TRANSLATE_NOOP("Limits",
                       "A direction with a component of exactly zero, or two of equal size, lies in two regions "
                       "of viewing directions; lists made for one may lack what the other sees."),
     Guard::corrected, QT_TRANSLATE_NOOP("Limits", "both regions' lists hold all that their common border sees."),
     QT_TRANSLATE_NOOP("Limits",
                       "all 26 axis and diagonal directions, and 1e-9 beside each: depth within 0.6 voxel "
                       "diagonals (linear) of rays."),
     "Octants.NothingIsLostOnTheBordersOfTheTwentyFourRegions", is_shear_warp},
    {QT_TRANSLATE_NOOP("Limits", "Slanted views by nearest voxels"), LimitTopic::shear_warp,
     QT_TRANSLATE_NOOP("Limits",
                       "One voxel paints one pixel of the sheared slice: at 45 degrees up to a third of the "
                       "resolution is lost, and depth is a staircase."),
     Guard::bounded, QT_TRANSLATE_NOOP("Limits", "`--sampler linear`, which the still picture takes."),
     QT_TRANSLATE_NOOP("Limits",
                       "nearest: within 1.6 voxel diagonals, 0.2 mm and more on average at 45 degrees; linear: "
                       "0.1 mm."),
     "Octants.NearestLosesDepthAtFortyFiveDegreesLinearDoesNot", is_rough_shear_warp, limit::slanted_nearest},
    {QT_TRANSLATE_NOOP("Limits", "Popping"), LimitTopic::shear_warp,
     QT_TRANSLATE_NOOP("Limits", "Where the principal axis switches, the slices do, and the picture jumps."),
     Guard::bounded, QT_TRANSLATE_NOOP("Limits", "none: it is the method's nature; ray casting has no such view."),
     QT_TRANSLATE_NOOP("Limits",
                       "a turn of 0.02 degrees over the switch changes the picture more than twice as much as one "
                       "beside it, by under 6 levels on average."),
     "Octants.ThePictureJumpsWhereThePrincipalAxisSwitches", is_shear_warp, limit::axis_switch},
    {QT_TRANSLATE_NOOP("Limits", "Perspective"), LimitTopic::shear_warp,
     QT_TRANSLATE_NOOP("Limits", "One shear serves parallel rays only."), Guard::refused,
     QT_TRANSLATE_NOOP("Limits", "the camera's field of view is refused in one sentence."),
     QT_TRANSLATE_NOOP("Limits", "none is drawn."), "ShearWarp.PerspectiveAndStopsAreErrors", is_shear_warp},
    {QT_TRANSLATE_NOOP("Limits", "Voxels that are no cubes"), LimitTopic::shear_warp,
     QT_TRANSLATE_NOOP("Limits",
                       "A shear in voxels a slice puts surfaces elsewhere where voxels are flat or the grid is turned."),
     Guard::corrected, QT_TRANSLATE_NOOP("Limits", "spacing and direction enter the shear and the warp."),
     QT_TRANSLATE_NOOP("Limits",
                       "spacings of 1:1:2, 0.8:1:1.5 and 1:1:5: depth within 1.6 voxel diagonals of rays (nearest), "
                       "0.6 (linear)."),
     "ShearWarp.AgreesWithRaysFromAllSixSidesAndBetween", is_shear_warp},
    {QT_TRANSLATE_NOOP("Limits", "A new isovalue or cut"), LimitTopic::shear_warp,
     QT_TRANSLATE_NOOP("Limits",
                       "A list of visible voxels holds for one isovalue and one set of cuts: every change is a new "
                       "extraction."),
     Guard::bounded,
     QT_TRANSLATE_NOOP("Limits",
                       "the one region of 24 that is looked from is extracted, others when the view turns there."),
     QT_TRANSLATE_NOOP("Limits", "a list is made once a region and sampling, and kept."),
     "ShearWarp.ListsAreBuiltOnceADirection", is_shear_warp},
    {QT_TRANSLATE_NOOP("Limits", "A peak inside a homogeneous node"), LimitTopic::structures,
     QT_TRANSLATE_NOOP("Limits",
                       "The octree takes a node whose values differ by less than the threshold as its average; a "
                       "narrow peak of the transfer function inside that range vanishes."),
     Guard::detected,
     QT_TRANSLATE_NOOP("Limits",
                       "threshold 0 is lossless; pc, acd and eacd compare opacities and colours instead; the "
                       "plan's `why` says when a peak is narrower than the threshold, and the planner takes no "
                       "thresholds."),
     QT_TRANSLATE_NOOP("Limits",
                       "over 60 of 255 levels lost by values at a threshold of 15 voxels' change; at most 6 by "
                       "opacities at 0.02."),
     "HomogeneousNodes.HideAPeakOfTheTransferFunctionUnlessOpacitiesAreCompared", averages_nodes,
     limit::flattened_peak},
    {QT_TRANSLATE_NOOP("Limits", "Thresholds too wide"), LimitTopic::structures,
     QT_TRANSLATE_NOOP("Limits", "Regions whose opacities may differ by the threshold show as patches."),
     Guard::bounded, QT_TRANSLATE_NOOP("Limits", "0 is lossless."),
     QT_TRANSLATE_NOOP("Limits", "255 T levels a unit distance; the error grows with the threshold."),
     "HomogeneousNodes.TheErrorOfAnOpacityThresholdIsBoundedByIt", runs_by_opacity, limit::wide_threshold},
    {QT_TRANSLATE_NOOP("Limits", "Distances saturate at 31 voxels"), LimitTopic::structures,
     QT_TRANSLATE_NOOP("Limits", "EACD has five bits an axis: large empty space is crossed in jumps of 31 voxels."),
     Guard::bounded,
     QT_TRANSLATE_NOOP("Limits", "saturated, never wrapped; over macro-cells (the default) a jump is as many cells."),
     QT_TRANSLATE_NOOP("Limits",
                       "at least one look-up in 31 voxels a ray, at most three times that; half as many over "
                       "cells of 8^3. The picture is the same."),
     "DistanceLimits.ThirtyOneVoxelsSaturateAndNeverWrap", boxes_a_voxel, limit::saturated_distances},
    {QT_TRANSLATE_NOOP("Limits", "Normals that turn within a region"), LimitTopic::structures,
     QT_TRANSLATE_NOOP("Limits",
                       "Gradients that differ by less than the angle count as equal: shading that turns within a run is "
                       "drawn alike."),
     Guard::bounded, QT_TRANSLATE_NOOP("Limits", "an angle of 0 tells all directions apart."),
     QT_TRANSLATE_NOOP("Limits",
                       "the error grows with the angle; on a shaded ball at threshold 0.02 under 4 of 255 levels on "
                       "average, whatever the angle."),
     "VoxelDistances.GradientsMayTurnByTheAngle", turns_normals},
    {QT_TRANSLATE_NOOP("Limits", "Rays along a surface"), LimitTopic::structures,
     QT_TRANSLATE_NOOP("Limits",
                       "A ray that grazes a surface goes through cells on both its sides: a tree is walked to its leaves "
                       "again and again, and nothing is skipped."),
     Guard::bounded, QT_TRANSLATE_NOOP("Limits", "16 rays ask once together, and a jump ends at the leaf's border."),
     QT_TRANSLATE_NOOP("Limits",
                       "two to three times the look-ups of a ray that meets the surface square on, at most one in four "
                       "voxels; the picture is the same."),
     "GrazingRays.LookUpMoreAndSkipNothing", walks_a_tree},
    {QT_TRANSLATE_NOOP("Limits", "A field a voxel for large volumes"), LimitTopic::structures,
     QT_TRANSLATE_NOOP("Limits", "Eight distances a voxel need eight to sixteen bytes a voxel."), Guard::refused,
     QT_TRANSLATE_NOOP("Limits", "before anything is allocated, naming the bytes and what fits."),
     QT_TRANSLATE_NOOP("Limits", "none is built."), "VoxelDistances.TooLargeIsRefusedInOneSentence", distances_a_voxel},
    {QT_TRANSLATE_NOOP("Limits", "Dense, faint data"), LimitTopic::structures,
     QT_TRANSLATE_NOOP("Limits", "Where most voxels are visible there is nothing to skip, and asking costs."),
     Guard::bounded, QT_TRANSLATE_NOOP("Limits", "a ray that can skip nothing asks once."),
     QT_TRANSLATE_NOOP("Limits",
                       "one look-up a ray where every cell is visible; leaping costs little more than nothing."),
     "DistanceStructures.AskOnceWhereNothingCanBeSkipped", skips_in_ea, limit::fog},
    {QT_TRANSLATE_NOOP("Limits", "Corners of cells"), LimitTopic::structures,
     QT_TRANSLATE_NOOP("Limits", "A ray through a corner or along a face of cells can loop, or jump a cell."),
     Guard::corrected,
     QT_TRANSLATE_NOOP("Limits", "jumps end a hair behind the cell's border and always advance a sample."),
     QT_TRANSLATE_NOOP("Limits",
                       "diagonals through voxel corners: no pixel off by more than a level, by any structure."),
     "Rays.ThroughVoxelCornersAlongDiagonals", skips},
    {QT_TRANSLATE_NOOP("Limits", "Equal samples outside regions"), LimitTopic::structures,
     QT_TRANSLATE_NOOP("Limits",
                       "The leaping kernel as published takes two equal samples for a region, wherever they lie, "
                       "and then samples nearest: saturated, striped or padded data fools it."),
     Guard::corrected,
     QT_TRANSLATE_NOOP("Limits",
                       "`--leaping confirmed` believes only the leap voxel's own bit; the planner never takes "
                       "`published`."),
     QT_TRANSLATE_NOOP("Limits",
                       "published: off by over 10 of 255 levels on balls without noise; confirmed: within 1."),
     "Leaping.EqualSamplesOutsideRegionsFoolThePublishedKernelButNotTheConfirmedOne", leaps_as_published,
     limit::fooled_leaps},
    {QT_TRANSLATE_NOOP("Limits", "Wide regions are drawn as their mean"), LimitTopic::structures,
     QT_TRANSLATE_NOOP("Limits",
                       "Above threshold 0 the picture is that of the volume in which each region has its average."),
     Guard::bounded, QT_TRANSLATE_NOOP("Limits", "0 is lossless."),
     QT_TRANSLATE_NOOP("Limits",
                       "exactly the brute-force picture of the flattened volume; its error grows with the "
                       "threshold."),
     "LeapStructure.TheErrorGrowsWithTheThreshold", leaps, limit::flattened_regions},
    {QT_TRANSLATE_NOOP("Limits", "Leaps that go too far"), LimitTopic::structures,
     QT_TRANSLATE_NOOP("Limits", "A leap longer than the way to the region's end skips a pore."), Guard::corrected,
     QT_TRANSLATE_NOOP("Limits", "every leap value is at most the distance less one and a half voxel diagonals."),
     QT_TRANSLATE_NOOP("Limits", "no voxel's value exceeds its true distance, in all three ways of making them."),
     "LeapVolume.KeepsWhatItPromisesInAllThreeWays", leaps},
    {QT_TRANSLATE_NOOP("Limits", "Floating-point voxels"), LimitTopic::structures,
     QT_TRANSLATE_NOOP("Limits", "16 bits with a flag leave 15 for a density."), Guard::refused,
     QT_TRANSLATE_NOOP("Limits", "`leap` on f32 unless the range to quantise is stated."),
     QT_TRANSLATE_NOOP("Limits", "none is drawn."), "LeapVolume.RefusesFloatsWithoutAQuantisationInOneLine", leaps},
    {QT_TRANSLATE_NOOP("Limits", "Noise leaves nothing to leap through"), LimitTopic::structures,
     QT_TRANSLATE_NOOP("Limits", "Noise makes tiny regions; with none large enough every sample is taken."),
     Guard::detected,
     QT_TRANSLATE_NOOP("Limits", "the share of equal neighbours is counted; `--smooth` first brings regions back."),
     QT_TRANSLATE_NOOP("Limits",
                       "at noise of 10 % of the contrast over ten times as many regions, and over a tenth less of "
                       "the voxels in large ones; smoothed by 1.5 voxels, at most three times as many."),
     "Noise.ShattersRegionsUntilTheVolumeIsSmoothed", leaps, limit::nothing_to_leap},
    {QT_TRANSLATE_NOOP("Limits", "Wires between cast pixels"), LimitTopic::sparse,
     QT_TRANSLATE_NOOP("Limits", "What is thinner than K pixels and met by no cast ray is lost."), Guard::corrected,
     QT_TRANSLATE_NOOP("Limits",
                       "`--sparse K,G,aware` asks min-max cells; nothing is promised for `lmip`, `mean`, and for "
                       "what floats before or behind something visible."),
     QT_TRANSLATE_NOOP("Limits",
                       "a wire of one voxel vanishes at K = 16 for some views; with `aware` no pixel is off by "
                       "more than 6 levels."),
     "SparseFails.AOnePixelWireVanishesBetweenCastPixelsUnlessCellsAreAsked", is_sparse, limit::thin_wires},
    {QT_TRANSLATE_NOOP("Limits", "Soft differences between cast pixels"), LimitTopic::sparse,
     QT_TRANSLATE_NOOP("Limits", "Differences below G between four cast pixels are interpolated away."), Guard::bounded,
     QT_TRANSLATE_NOOP("Limits", "`--sparse K,0` interpolates between equal pixels only."),
     QT_TRANSLATE_NOOP("Limits", "the error grows with G, the number of rays falls."),
     "Sparse.ErrorGrowsAndRaysShrinkWithTheThreshold", is_sparse},
    {QT_TRANSLATE_NOOP("Limits", "Occlusion from the picture alone"), LimitTopic::effects,
     QT_TRANSLATE_NOOP("Limits",
                       "SSAO sees only what the picture shows: what is hidden or outside it darkens nothing, and "
                       "near things could darken far ones."),
     Guard::bounded, QT_TRANSLATE_NOOP("Limits", "depths too far apart are left out (range check)."),
     QT_TRANSLATE_NOOP("Limits", "no halo on what lies far behind; a plane stays as it is."),
     "Effects.SsaoCastsNoHaloOnWhatLiesFarBehind", has_ssao},
    {QT_TRANSLATE_NOOP("Limits", "Blur across outlines"), LimitTopic::effects,
     QT_TRANSLATE_NOOP("Limits", "Depth of field blurs a picture: colours of what is sharp bleed into what is not."),
     Guard::corrected, QT_TRANSLATE_NOOP("Limits", "pixels weigh by their own circle of confusion."),
     QT_TRANSLATE_NOOP("Limits", "sharp colour stays out of the blur."),
     "Effects.DepthOfFieldKeepsSharpColourOutOfTheBlur", has_depth_of_field},
    {QT_TRANSLATE_NOOP("Limits", "Voxels that are no numbers"), LimitTopic::volumes,
     QT_TRANSLATE_NOOP("Limits", "A NaN or infinite voxel spoils every sample of its neighbourhood."), Guard::corrected,
     QT_TRANSLATE_NOOP("Limits",
                       "such samples contribute nothing and are counted nowhere; structures never call their "
                       "cells empty or alike."),
     QT_TRANSLATE_NOOP("Limits",
                       "every mode by every structure, NaN and both infinities scattered: the reference's "
                       "picture, but for 1 % of pixels."),
     "Voxels.NanAndInfinityContributeNothingAnywhere", always, limit::not_finite},
    {QT_TRANSLATE_NOOP("Limits", "One value, or one voxel across"), LimitTopic::volumes,
     QT_TRANSLATE_NOOP("Limits", "Ranges, gradients and cells of nothing: divisions by zero, empty trees."),
     Guard::corrected, QT_TRANSLATE_NOOP("Limits", "every build and fit takes them."),
     QT_TRANSLATE_NOOP("Limits", "constant volumes and 1xN, 1x1xN, 1x1x1 in every mode by every structure."),
     "Voxels.OneValueOrOneVoxelAcrossIsDrawnByEveryStructure", always, limit::flat_or_thin},
    {QT_TRANSLATE_NOOP("Limits", "Rays exactly along axes"), LimitTopic::volumes,
     QT_TRANSLATE_NOOP("Limits",
                       "A direction component of exactly zero divides by zero; rays within voxel faces belong to "
                       "two voxels."),
     Guard::corrected, QT_TRANSLATE_NOOP("Limits", "slabs the ray runs along are left out of its entry and exit."),
     QT_TRANSLATE_NOOP("Limits",
                       "six axes, on voxel centres and faces: the reference's picture but for rays within the "
                       "box's own faces; structures change nothing."),
     "Rays.ExactlyAlongAxesOnVoxelCentresFacesAndEdges", always},
    {QT_TRANSLATE_NOOP("Limits", "An eye inside the volume"), LimitTopic::volumes,
     QT_TRANSLATE_NOOP("Limits", "There is no entry, and the first sample may lie inside a region or an object."),
     Guard::corrected, QT_TRANSLATE_NOOP("Limits", "rays start at the eye; leaps look ahead for the region's value."),
     QT_TRANSLATE_NOOP("Limits", "the reference's picture; structures change nothing."), "Rays.FromInsideTheVolume",
     always},
    {QT_TRANSLATE_NOOP("Limits", "Single precision far away"), LimitTopic::volumes,
     QT_TRANSLATE_NOOP("Limits", "At 10 000 voxels a float's last digit is a thousandth of a voxel."), Guard::bounded,
     QT_TRANSLATE_NOOP("Limits", "rays are re-based to the volume's box in double precision."),
     QT_TRANSLATE_NOOP("Limits",
                       "depth within 0.01 voxels at 10 000 voxels and with origins up to 1e6 mm; 0.02 at the far "
                       "end of a volume 10 000 voxels long."),
     "Precision.AnEyeTenThousandVoxelsAwaySeesTheSameSurface", always, limit::far_away},
    {QT_TRANSLATE_NOOP("Limits", "The pixel's own error"), LimitTopic::volumes,
     QT_TRANSLATE_NOOP("Limits", "Between pixel centres nothing is cast."), Guard::bounded,
     QT_TRANSLATE_NOOP("Limits", "larger pictures only."),
     QT_TRANSLATE_NOOP("Limits", "second order in the pixel (slope within 0.15 of 2)."),
     "Slopes.APictureIsOfSecondOrderInThePixel", always},
    {QT_TRANSLATE_NOOP("Limits", "Stored gradients"), LimitTopic::volumes,
     QT_TRANSLATE_NOOP("Limits", "Packed into four bytes, a normal's direction is rounded."), Guard::bounded,
     QT_TRANSLATE_NOOP("Limits", "`--gradient on-the-fly`."), QT_TRANSLATE_NOOP("Limits", "0.2 degrees."),
     "Gradients.StoredOnesLookLikeThoseOnTheFly", stores_gradients},
    {QT_TRANSLATE_NOOP("Limits", "Nearest voxels"), LimitTopic::volumes,
     QT_TRANSLATE_NOOP("Limits", "One voxel's value for its whole cell: stairs."), Guard::bounded,
     QT_TRANSLATE_NOOP("Limits", "`--sampler linear`; `adaptive` reads nearest only where nothing can tell."),
     QT_TRANSLATE_NOOP("Limits", "a surface is off by up to half a voxel diagonal and the step."),
     "NearestSampler.StairsAreHalfADiagonalHighAdaptiveHasNone", samples_nearest},
    {QT_TRANSLATE_NOOP("Limits", "Growth shatters under noise"), LimitTopic::regions,
     QT_TRANSLATE_NOOP("Limits", "A region's values span at most the width: noise wider than that leaves crumbs."),
     Guard::detected, QT_TRANSLATE_NOOP("Limits", "`--min-voxels` drops them, `--smooth` avoids them."),
     QT_TRANSLATE_NOOP("Limits", "as for leaping: over ten times as many regions at noise of 10 % of the contrast."),
     "Noise.ShattersRegionsUntilTheVolumeIsSmoothed"},
    {QT_TRANSLATE_NOOP("Limits", "The order of growth"), LimitTopic::regions,
     QT_TRANSLATE_NOOP("Limits", "Which seed comes first decides which voxels a region may still take."),
     Guard::bounded, QT_TRANSLATE_NOOP("Limits", "seeds are tried in the voxels' order, on any number of threads."),
     QT_TRANSLATE_NOOP("Limits", "the same labels, bit for bit."), "Growing.SameLabelsAndBitsForAnyNumberOfThreads"},
    {QT_TRANSLATE_NOOP("Limits", "Adjacency decides topology"), LimitTopic::regions,
     QT_TRANSLATE_NOOP("Limits", "A shell with a diagonal gap is closed for one adjacency and open for the other."),
     Guard::detected,
     QT_TRANSLATE_NOOP("Limits", "the adjacency used stands in the table; regions and cavities take opposite ones."),
     QT_TRANSLATE_NOOP("Limits", "both answers, each right for its adjacency."),
     "Topology.AShellWithADiagonalGapIsClosedForOneAdjacencyOnly"},
    {QT_TRANSLATE_NOOP("Limits", "Area from voxel faces"), LimitTopic::measures,
     QT_TRANSLATE_NOOP("Limits",
                       "Counted faces overestimate by half and never converge; weights for cubes are wrong by "
                       "tens of percent on flat voxels."),
     Guard::corrected, QT_TRANSLATE_NOOP("Limits", "Crofton's formula with 13 directions, weighted for the spacing."),
     QT_TRANSLATE_NOOP("Limits", "a flat tilted disc at 1:1:5 within the stated bound."),
     "CrackSurface.OfAFlatTiltedDiscIsRight"},
    {QT_TRANSLATE_NOOP("Limits", "Volume at one threshold"), LimitTopic::measures,
     QT_TRANSLATE_NOOP("Limits",
                       "A blurred pore of two voxels' radius reads 0.45 to 0.89 of its volume, as the threshold "
                       "goes from 60 to 40 %."),
     Guard::bounded, QT_TRANSLATE_NOOP("Limits", "every volume carries an interval."),
     QT_TRANSLATE_NOOP("Limits", "the true volume lies in the interval."),
     "PartAnalysis.BlurredBallsReadTooSmallAtOneThresholdAndTheIntervalSaysSo"},
    {QT_TRANSLATE_NOOP("Limits", "Porosity under noise"), LimitTopic::measures,
     QT_TRANSLATE_NOOP("Limits", "Noise moves the threshold and adds false pores."), Guard::bounded,
     QT_TRANSLATE_NOOP("Limits", "an interval; finds below the noise are dropped."),
     QT_TRANSLATE_NOOP("Limits", "at noise of 0 to 10 % of the contrast the truth lies in the interval."),
     "Noise.PorosityStaysWithinItsInterval"},
    {QT_TRANSLATE_NOOP("Limits", "Finds of a few voxels"), LimitTopic::measures,
     QT_TRANSLATE_NOOP("Limits", "Below eight voxels the uncertainty exceeds the object."), Guard::detected,
     QT_TRANSLATE_NOOP("Limits", "such finds are reported as detected, not measured."),
     QT_TRANSLATE_NOOP("Limits", "no volume is printed for them."),
     "PartAnalysis.TinyFindsAreDetectedButNotMeasurable"},
});
// clang-format on

}  // namespace

std::span<const Limit> limits() { return k_limits; }

}  // namespace lacuna
