package arcomat.generate.monitor;

import arcomat.generate.language.Places;
import arcomat.generate.plan.Program;
import arcomat.generate.text.ExpressionWriter;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.MemberNames;
import arcomat.generate.view.HeadView.AssignmentView;
import arcomat.generate.view.MonitorView;
import arcomat.generate.view.ProgramView.WatchView;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.network.Composition;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** Programs that watch themselves: the classes of their monitors, and what is shown to these. */
public final class SelfWatches {
    private final List<SelfWatch> all;
    private final Program program;
    private final Program monitors;

    /** One for a requirement, however many parts are watched for it. */
    private final Map<String, MonitorClass> classes = new LinkedHashMap<>();

    public SelfWatches(List<SelfWatch> all, Program program) {
        this.all = all;
        this.program = program;
        for (SelfWatch watch : all) {
            MonitorClass monitor = monitor(watch);
            classes.putIfAbsent(monitor.component().qualifiedName(), monitor);
        }
        List<Component> components =
                classes.values().stream().map(MonitorClass::component).toList();
        monitors = Program.ofMonitors(program.names(), components);
    }

    private static MonitorClass monitor(SelfWatch watch) {
        return MonitorClass.of(watch.required(), watch.automaton());
    }

    public Program monitors() {
        return monitors;
    }

    /** The classes of the monitors. */
    public List<MonitorView> views() {
        return classes.values().stream().map(each -> each.view(monitors)).toList();
    }

    /** What a program does with its monitors. */
    public List<WatchView> of(Component main) {
        List<WatchView> views = new ArrayList<>();
        for (SelfWatch watch : all) {
            if (watch.program().qualifiedName().equals(main.qualifiedName())) {
                views.add(view(watch, "watch" + views.size()));
            }
        }
        return views;
    }

    private WatchView view(SelfWatch watch, String name) {
        MonitorClass monitor = monitor(watch);
        MemberNames to = monitors.members(monitor.component());
        MemberNames from = program.members(watch.running());
        String part = watch.part().isEmpty() ? "" : fields(watch.program(), watch.part()) + ".";
        List<String> fixed = new ArrayList<>();
        List<AssignmentView> before = new ArrayList<>();
        List<AssignmentView> after = new ArrayList<>();
        for (Port port : watch.required().ports()) {
            Port there = watch.running().port(port.name()).orElseThrow();
            List<AssignmentView> copies = shownBefore(there) ? before : after;
            copies.add(new AssignmentView(to.of(port), part + from.of(there)));
            if (!to.flag(port).isEmpty() && from.flag(there).isEmpty()) {
                fixed.add(to.flag(port));
            } else if (!to.flag(port).isEmpty()) {
                copies.add(new AssignmentView(to.flag(port), part + from.flag(there)));
            }
        }
        return new WatchView(
                program.names().of(monitor.component()).qualified(),
                name,
                watch.required().title(watch.automaton())
                        + ", line "
                        + Places.line(watch.automaton().span())
                        + (watch.part().isEmpty() ? "" : ", on part " + watch.part()),
                arguments(watch),
                fixed,
                before,
                after,
                watch.goesOn());
    }

    /** Outputs with delay show in a slice what was sent in the one before: read them first. */
    private static boolean shownBefore(Port port) {
        return !port.isInput() && port.delay() > 0;
    }

    /** The fields that lead from a component to a part of it. */
    private String fields(Component component, String path) {
        FileContext context = program.context(component);
        Map<String, String> fields = program.arrangement(context).paths();
        for (Composition.Node node : context.composition().orElseThrow().nodes()) {
            String field = Objects.requireNonNull(fields.get(node.path()));
            if (node.path().equals(path)) {
                return field;
            }
            if (node.inside().isPresent() && path.startsWith(node.path() + ".")) {
                String rest = path.substring(node.path().length() + 1);
                return field + "." + fields(node.component(), rest);
            }
        }
        throw new IllegalArgumentException(component.qualifiedName() + " has no part " + path);
    }

    /** Literals; enums are numbers. */
    private String arguments(SelfWatch watch) {
        ExpressionWriter text = program.context(watch.program()).expressions();
        List<String> arguments = new ArrayList<>();
        for (int i = 0; i < watch.arguments().size(); i++) {
            Value value = watch.arguments().get(i);
            arguments.add(
                    value instanceof Value.EnumValue constant
                            ? String.valueOf(constant.ordinal() + 1)
                            : text.of(value, watch.required().parameters().get(i).type()).text());
        }
        return String.join(", ", arguments);
    }
}
