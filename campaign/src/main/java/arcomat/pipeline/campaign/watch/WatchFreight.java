package arcomat.pipeline.campaign.watch;

import arcomat.campaign.Campaign;
import arcomat.campaign.Watched;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.joint.JointFreight;
import arcomat.pipeline.check.CheckedModels;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.world.Kind;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;

/**
 * What runs need where a campaign watches: programs that watch themselves in the place of those
 * that do not, which of their classes tell of which event, and what watches several robots.
 *
 * @param code all programs of the campaign
 * @param monitors columns by the full names of classes
 * @param findings about what is to be watched
 */
public record WatchFreight(
        CampaignCode code,
        Map<String, String> monitors,
        JointFreight joint,
        List<Diagnostic> findings) {
    static final String NOT_WATCHED = "ARC1137";

    private static WatchFreight failed(CampaignCode code, List<Diagnostic> findings) {
        return new WatchFreight(code, Map.of(), JointFreight.NONE, findings);
    }

    /**
     * @param code programs that do not watch
     * @param world text of the world
     */
    public static WatchFreight of(
            Campaign campaign, CampaignCode code, SourceFile world, Session session)
            throws WrongUse {
        if (campaign.watches().isEmpty() && campaign.jointWatches().isEmpty()) {
            return failed(code, List.of());
        }
        List<WatchedRoot> roots = new ArrayList<>();
        for (Map.Entry<String, List<Kind.Program>> root :
                WatchedRoot.paths(code.named().values(), world.path()).entrySet()) {
            CheckedModels checked =
                    WatchedRoot.checked(campaign, root.getKey(), root.getValue(), session);
            if (checked.hasErrors()) {
                return failed(code, checked.findings());
            }
            roots.add(WatchedRoot.of(checked.lower(session), root.getValue()));
        }
        WatchFreight alone = selfWatching(campaign, code, roots, session);
        if (campaign.jointWatches().isEmpty()) {
            return alone;
        }
        JointPlan.Result joint = JointPlan.of(campaign, alone.code(), roots, world);
        List<Diagnostic> findings = new ArrayList<>(alone.findings());
        findings.addAll(joint.findings());
        return new WatchFreight(alone.code(), alone.monitors(), joint.freight(), findings);
    }

    /** Programs that watch themselves for what single robots are to keep. */
    private static WatchFreight selfWatching(
            Campaign campaign, CampaignCode code, List<WatchedRoot> roots, Session session)
            throws WrongUse {
        CampaignCode all = code;
        Map<String, String> monitors = new TreeMap<>();
        List<Diagnostic> findings = new ArrayList<>();
        Map<Watched, WrongUse> refused = new LinkedHashMap<>();
        Set<Watched> served = new HashSet<>();
        for (WatchedRoot root : campaign.watches().isEmpty() ? List.<WatchedRoot>of() : roots) {
            WatchedPrograms.Result made =
                    WatchedPrograms.of(
                            campaign.watches(), root.components(), root.models(), session);
            all = all.with(made.programs(), made.layouts());
            monitors.putAll(made.monitors());
            findings.addAll(made.findings());
            refused.putAll(made.refused());
            campaign.watches().stream()
                    .filter(each -> !made.refused().containsKey(each))
                    .forEach(served::add);
        }
        campaign.watches().stream()
                .filter(each -> !served.contains(each))
                .forEach(each -> findings.add(refusal(each, refused)));
        return new WatchFreight(all, monitors, JointFreight.NONE, findings);
    }

    private static Diagnostic refusal(Watched watched, Map<Watched, WrongUse> refused) {
        WrongUse why = refused.get(watched);
        String message =
                why == null
                        ? "no robot's program is made of a component, so none can watch itself"
                        : Objects.requireNonNull(why.getMessage());
        return Diagnostic.error(NOT_WATCHED, watched.place(), message);
    }
}
