package arcomat.pipeline.campaign.watch;

import arcomat.campaign.Campaign;
import arcomat.campaign.Watched;
import arcomat.generate.AutomatonLines;
import arcomat.model.Component;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.generate.WatchedParts;
import arcomat.sim.load.Program;
import arcomat.source.Diagnostic;
import arcomat.world.Kind;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;

/**
 * What runs need where a campaign watches: programs that watch themselves in the place of those
 * that do not, and which of their classes tell of which event.
 *
 * @param programs all of a campaign, by what worlds say of them
 * @param automata where those that were made of models have these, likewise
 * @param monitors columns by the full names of classes
 * @param findings about what is to be watched
 */
public record WatchFreight(
        Map<String, Program> programs,
        Map<String, List<AutomatonLines>> automata,
        Map<String, String> monitors,
        List<Diagnostic> findings) {
    static final String NOT_WATCHED = "ARC1137";

    /**
     * @param kinds what the campaign's worlds say of programs
     * @param plain programs that do not watch
     * @param automata where these have those of their models
     * @param file of the world, as the user would write it
     */
    public static WatchFreight of(
            Campaign campaign,
            Collection<Kind.Program> kinds,
            Map<String, Program> plain,
            Map<String, List<AutomatonLines>> automata,
            String file,
            Session session)
            throws WrongUse {
        WatchFreight freight =
                new WatchFreight(
                        new TreeMap<>(plain),
                        new TreeMap<>(automata),
                        new TreeMap<>(),
                        new ArrayList<>());
        if (campaign.watches().isEmpty()) {
            return freight;
        }
        Map<Watched, WrongUse> refused = new LinkedHashMap<>();
        Set<Watched> served = new HashSet<>();
        for (Map.Entry<String, List<Kind.Program>> root : roots(kinds, file).entrySet()) {
            CheckedModels checked = checked(campaign, root.getKey(), root.getValue(), session);
            if (checked.hasErrors()) {
                freight.findings.addAll(checked.findings());
                return freight;
            }
            LoweredModels models = checked.lower(session);
            WatchedPrograms.Result made =
                    WatchedPrograms.of(
                            campaign.watches(),
                            components(root.getValue(), models),
                            models,
                            session);
            freight.programs.putAll(made.programs());
            freight.automata.putAll(made.automata());
            freight.monitors.putAll(made.monitors());
            freight.findings.addAll(made.findings());
            refused.putAll(made.refused());
            campaign.watches().stream()
                    .filter(each -> !made.refused().containsKey(each))
                    .forEach(served::add);
        }
        for (Watched each : campaign.watches()) {
            if (!served.contains(each)) {
                freight.findings.add(refusal(each, refused));
            }
        }
        return freight;
    }

    private static Diagnostic refusal(Watched watched, Map<Watched, WrongUse> refused) {
        WrongUse why = refused.get(watched);
        String message =
                why == null
                        ? "no robot's program is made of a component, so none can watch itself"
                        : Objects.requireNonNull(why.getMessage());
        return Diagnostic.error(NOT_WATCHED, watched.place(), message);
    }

    private static Map<String, List<Kind.Program>> roots(
            Collection<Kind.Program> kinds, String file) {
        Path parent = Path.of(file).getParent();
        Path folder = parent == null ? Path.of("") : parent;
        Map<String, List<Kind.Program>> roots = new TreeMap<>();
        for (Kind.Program each : kinds) {
            if (each.form() == Kind.Program.Form.COMPONENT) {
                String root =
                        folder.resolve(each.folder()).normalize().toString().replace('\\', '/');
                roots.computeIfAbsent(root, r -> new ArrayList<>()).add(each);
            }
        }
        return roots;
    }

    private static CheckedModels checked(
            Campaign campaign, String root, List<Kind.Program> programs, Session session) {
        List<String> named =
                new ArrayList<>(
                        WatchedParts.requirements(
                                campaign.watches().stream().map(Watched::requirement).toList()));
        programs.forEach(each -> named.add(each.name().replaceFirst("\\(.*", "")));
        return CheckedModels.checkToExamine(List.of(root), Asked.components(named), session);
    }

    private static Map<String, Component> components(
            List<Kind.Program> programs, LoweredModels models) throws WrongUse {
        Map<String, Component> components = new TreeMap<>();
        for (Kind.Program each : programs) {
            components.put(each.key(), MainComponent.find(each.name(), models).closed());
        }
        return components;
    }
}
