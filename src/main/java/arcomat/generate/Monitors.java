package arcomat.generate;

import arcomat.generate.OutputFiles.Kind;
import arcomat.generate.language.NameForms;
import arcomat.generate.language.Places;
import arcomat.generate.language.TargetNames;
import arcomat.generate.monitor.MonitorClass;
import arcomat.generate.plan.Program;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.MemberNames;
import arcomat.generate.view.HeadView.AssignmentView;
import arcomat.generate.view.MonitorView;
import arcomat.generate.view.MonitorsView;
import arcomat.generate.view.MonitorsView.WatcherView;
import arcomat.generate.views.Heads;
import arcomat.generate.views.MessageTypes;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Port;

import java.util.ArrayList;
import java.util.List;

/**
 * Writes classes that watch the ports of a component while it runs: one for each requirement, and
 * where there are several, one that asks them all. Each is a component of its own to the rest of
 * the generator: with the ports of the one that is watched, and a single automaton.
 */
public final class Monitors {
    private final Component watched;
    private final List<MonitorClass> classes;

    private Monitors(Component watched, List<Automaton> automata) {
        this.watched = watched.asPromised();
        this.classes = automata.stream().map(each -> MonitorClass.of(watched, each)).toList();
    }

    /** The name of the class that asks them all, as the layout of the generated files knows it. */
    public static String name(Component watched, List<Automaton> automata) {
        Monitors monitors = new Monitors(watched, automata);
        return automata.size() == 1
                ? monitors.classes.get(0).component().qualifiedName()
                : watched.qualifiedName() + "Monitor";
    }

    /**
     * Generates monitors of a component.
     *
     * @param automata some of the component
     * @param target that has templates for monitors
     * @return files, or findings that say why there are none, see {@link Generator#generate}
     */
    public static Generation generate(Component watched, List<Automaton> automata, Target target) {
        Monitors monitors = new Monitors(watched, automata);
        return Generator.generate(
                target, (names, output, findings) -> monitors.write(names, output));
    }

    private CodeLayout write(TargetNames names, OutputFiles output) {
        List<Component> all = new ArrayList<>();
        classes.forEach(each -> all.add(each.component()));
        Component whole = MonitorClass.component(watched, "", List.of(), watched.span());
        if (classes.size() > 1) {
            all.add(whole);
        }
        Program program = Program.ofMonitors(names, all);
        MessageTypes types = new MessageTypes(program);
        output.write(types);
        for (MonitorClass each : classes) {
            MonitorView view = each.view(program);
            output.write(Kind.MONITOR, view.head(), view);
        }
        if (classes.size() > 1) {
            MonitorsView view = view(program.context(whole), program);
            output.write(Kind.MONITORS, view.head(), view);
        }
        return CodeLayout.of(program, types, List.of(), List.of());
    }

    private MonitorsView view(FileContext context, Program program) {
        List<WatcherView> watchers = new ArrayList<>();
        for (MonitorClass each : classes) {
            String field = context.members().claim(NameForms.uncapitalised(each.requirement()));
            watchers.add(
                    new WatcherView(
                            field,
                            context.references().to(program.names().of(each.component())),
                            watched.title(each.automaton())
                                    + ", line "
                                    + Places.line(each.automaton().span()),
                            copies(field, context.members(), program.members(each.component()))));
        }
        return new MonitorsView(
                Heads.of(context, false),
                watched.qualifiedName(),
                watchers,
                context.isEventDriven());
    }

    private List<AssignmentView> copies(String field, MemberNames from, MemberNames to) {
        List<AssignmentView> copies = new ArrayList<>();
        boolean events = watched.profile() == Component.Profile.EVENT_DRIVEN;
        for (Port port : events ? watched.inputs() : watched.ports()) {
            copies.add(new AssignmentView(field + "." + to.of(port), from.of(port)));
            if (!from.flag(port).isEmpty()) {
                copies.add(new AssignmentView(field + "." + to.flag(port), from.flag(port)));
            }
        }
        return copies;
    }
}
