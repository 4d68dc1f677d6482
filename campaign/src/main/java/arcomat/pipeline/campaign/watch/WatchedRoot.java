package arcomat.pipeline.campaign.watch;

import arcomat.campaign.Campaign;
import arcomat.campaign.JointWatch;
import arcomat.campaign.Watched;
import arcomat.model.Component;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.generate.WatchedParts;
import arcomat.world.Kind;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * A model root that programs are made of, with what it may be asked for.
 *
 * @param models checked, without errors
 * @param components that programs run, by what worlds say of them
 */
record WatchedRoot(LoweredModels models, Map<String, Component> components) {
    /** Programs by the model roots that they are made of, as paths that messages show. */
    static Map<String, List<Kind.Program>> paths(Collection<Kind.Program> programs, String world) {
        Path parent = Path.of(world).getParent();
        Path folder = parent == null ? Path.of("") : parent;
        Map<String, List<Kind.Program>> roots = new TreeMap<>();
        for (Kind.Program each : programs) {
            if (each.form() == Kind.Program.Form.COMPONENT) {
                String root =
                        folder.resolve(each.folder()).normalize().toString().replace('\\', '/');
                roots.computeIfAbsent(root, r -> new ArrayList<>()).add(each);
            }
        }
        return roots;
    }

    static CheckedModels checked(
            Campaign campaign, String root, List<Kind.Program> programs, Session session) {
        List<String> named =
                new ArrayList<>(
                        WatchedParts.requirements(
                                campaign.watches().stream().map(Watched::requirement).toList()));
        campaign.jointWatches().stream().map(JointWatch::requirement).forEach(named::add);
        programs.forEach(each -> named.add(each.name().replaceFirst("\\(.*", "")));
        return CheckedModels.checkToExamine(List.of(root), Asked.components(named), session);
    }

    static WatchedRoot of(LoweredModels models, List<Kind.Program> programs) throws WrongUse {
        Map<String, Component> components = new TreeMap<>();
        for (Kind.Program each : programs) {
            components.put(each.key(), MainComponent.find(each.name(), models).closed());
        }
        return new WatchedRoot(models, components);
    }
}
